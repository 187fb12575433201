#ifndef OMPL_CERTIFICATES_CONTROL_SHOOTING_
#define OMPL_CERTIFICATES_CONTROL_SHOOTING_

#include "ompl_certificates/control/DynamicRobot.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <ompl/base/StateSpace.h>
#include <optional>
#include <vector>

namespace ompl_certificates
{
    /** \brief Finds controls that bring a robot from one state to another in a given number of steps: single shooting
        with Newton's method, whose derivatives are differences of what DynamicRobot::propagate() gives

        Obstacles play no part. The result is next to the guess: of all changes that lead to the end, Newton's steps take
        the least one. */
    class Shooting
    {
    public:
        /** \brief A control that is held for some steps */
        struct Piece
        {
            std::vector<double> control;
            unsigned int steps;
        };

        /** \brief For how many steps a control may be held */
        struct Durations
        {
            unsigned int least, most;
        };

        /** \brief Into so many pieces a way is divided, if their durations allow that: more cost more, with fewer a
            robot turns and stops less */
        static constexpr unsigned int PIECES = 12;

        /** \brief Divide a number of steps into pieces, without controls yet; none if no pieces of the durations give
            that number */
        static std::vector<Piece> divide(std::size_t steps, const Durations &durations);

        /** \brief Shoots with a robot whose states are those of \e space; both must outlive this */
        Shooting(const DynamicRobot &robot, const ompl::base::StateSpace &space, double stepSize);

        /** \brief How near the robot comes to its end, in its space's distance: 1e-7 of the space's extent */
        double getAccuracy() const
        {
            return accuracy_;
        }

        /** \brief Change the controls of \e pieces, within the robot's bounds, so that they bring it from \e from to
            \e to, and that numbers of R^n are within their bounds at the end of each piece before
            \return whether that was found; if not, the controls are undefined */
        bool solve(const ompl::base::State *from, const ompl::base::State *to, std::vector<Piece> &pieces);

    private:
        using StatePtr = std::unique_ptr<ompl::base::State, std::function<void(ompl::base::State *)>>;

        /** \brief One of the numbers that a state is made of */
        struct Coordinate
        {
            ompl::base::StateSpace::ValueLocation location;
            enum
            {
                NUMBER,
                ANGLE,
                QUATERNION
            } kind;
            double low, high;
        };

        /** \brief Numbers of a state that must be something at the end of a piece */
        struct Condition
        {
            std::size_t piece, coordinate;
            double value;
        };

        StatePtr makeState() const;
        double valueOf(const Coordinate &coordinate, const ompl::base::State *state) const;
        double difference(const Coordinate &coordinate, const ompl::base::State *state, double value) const;
        void run(const ompl::base::State *from, const std::vector<Piece> &pieces);
        static double within(const Coordinate &coordinate, double value);
        void turnGoals();
        bool addLimits(std::size_t pieces);
        Eigen::VectorXd computeErrors() const;
        Eigen::MatrixXd computeDerivatives(const std::vector<Piece> &pieces);
        bool improve(std::vector<Piece> &pieces, Eigen::VectorXd errors, Eigen::MatrixXd derivatives);

        const DynamicRobot &robot_;
        const ompl::base::StateSpace &space_;
        const double stepSize_, accuracy_;
        std::vector<Coordinate> coordinates_;
        /** \brief Before each piece, and after the last one */
        std::vector<StatePtr> ends_;
        StatePtr less_, more_;
        /** \brief Those of the end first */
        std::vector<Condition> conditions_;
    };
}

#endif
