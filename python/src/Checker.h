#ifndef OMPL_CERTIFICATES_PYTHON_CHECKER_
#define OMPL_CERTIFICATES_PYTHON_CHECKER_

#include "Arrays.h"
#include "World.h"

#include <ompl_certificates/team/Rotations.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <ompl/geometric/PathGeometric.h>

namespace ompl_certificates_python
{
    using ompl_certificates::ObstacleSet;
    using ompl_certificates::Scene;
    using ompl_certificates::TeamSetup;

    /** \brief How motions are checked, by its name: discrete or continuous
        \throws ompl::Exception for another one */
    ompl_certificates::CertificateMotionValidator::Mode modeOf(const std::string &motion);

    /** \brief A scene's team among its obstacles, which may change. Checks batches of states and motions, and keeps
        what is known of the obstacles. All methods may be called from many threads at once.

        Members that take arrays release Python's lock while they check. */
    class Checker
    {
    public:
        /** \brief A checker for the team of \e scene
            \param scene with at least one robot
            \param method the name of a method; see ompl_certificates::methodOf()
            \param motion how motions are checked: discrete or continuous
            \throws ompl::Exception if a name is unknown, or the scene has no robot */
        Checker(const Scene &scene, const std::string &method, const std::string &motion);

        /** \brief Which states are valid: one bool for each row of \e states, of shape (n, coordinates) or
            (coordinates,); none of an empty list. A state with a number that is not finite is not valid. Another thread
            may write to the array meanwhile: a row whose quaternion has not length 1 when it is read is not valid.
            \throws ompl::Exception for another shape, and for a quaternion whose length is not 1 */
        py::array_t<bool> isValid(const Doubles &states) const;

        /** \brief A lower bound of the distance to the nearest contact, for each state */
        py::array_t<double> clearance(const Doubles &states) const;

        /** \brief Which motions are valid, between the same rows of both. As in OMPL, starts must be valid: they are
            not checked here in the discrete mode. */
        py::array_t<bool> checkMotions(const Doubles &starts, const Doubles &ends) const;

        /** \brief How far each end is from its start, in the team's space, whatever is in between; NaN if a number of
            either is not finite. One state serves for many, here and below.
            \throws ompl::Exception as isValid() does, and if there are not as many of one as of the other */
        py::array_t<double> distance(const Doubles &starts, const Doubles &ends) const;

        /** \brief States on the team's ways from starts to ends, one in each row, of NaN as above
            \param fractions how much of the way, from 0 to 1
            \throws ompl::Exception as above, and for another fraction */
        Doubles interpolate(const Doubles &starts, const Doubles &ends, const Doubles &fractions) const;

        /** \brief Which motions of a path are blocked, or begin or end in a state that is: i is that from row i to row i
            + 1. Of a single state, 0. All are checked among the same obstacles, also while others change them.
            \throws ompl::Exception as isValid() does */
        std::vector<std::int64_t> findBlocked(const Doubles &path) const;

        /** \brief What collides in a state, in one line that names the obstacle; empty if it is valid */
        std::string describeCollision(const Doubles &state) const;

        /** \brief The same, of a state of the team */
        std::string describeCollision(const ompl::base::State *state) const;

        /** \brief Change the obstacles that are bodies, and return the numbers of those that are added. Waits for
            running checks of other threads, which see all of the change or nothing, here and below.
            \throws ompl::Exception as World does. Then nothing has changed. */
        std::vector<ObstacleSet::Id> changeObstacles(const BodyChange &change);

        /** \brief Add a cloud of points with one radius, and return its number.
            \throws ompl::Exception as World does, here and below */
        std::size_t addCloud(CloudPoints points, double radius);

        /** \brief Change the points of a cloud. */
        void changeCloud(std::size_t cloud, CloudChange change);

        /** \brief Remove a cloud. */
        void removeCloud(std::size_t cloud);

        /** \brief The points of a cloud, in no order */
        std::vector<Eigen::Vector3d> getCloudPoints(std::size_t cloud) const;

        /** \brief Add a grid of occupied cells, and return its number. */
        std::size_t addGrid(const std::vector<ompl_certificates::CellBox> &occupied, double size,
                            const Eigen::Vector3d &origin);

        /** \brief Change cells of a grid. */
        void changeGrid(std::size_t grid, const std::vector<ompl_certificates::CellBox> &occupied,
                        const std::vector<ompl_certificates::CellBox> &free);

        /** \brief Add a map of cells, and return its number. */
        std::size_t addMap(std::shared_ptr<const ompl_certificates::CellObstacles> map);

        /** \brief Let a grid have the cells of a map alone. */
        void replaceGrid(std::size_t grid, const ompl_certificates::CellObstacles &map);

        /** \brief Remove a grid. */
        void removeGrid(std::size_t grid);

        /** \brief The occupied cells of a grid, in boxes */
        std::vector<ompl_certificates::CellBox> getCells(std::size_t grid) const;

        /** \brief A state of the team, from its numbers
            \throws ompl::Exception that names \e what as isValid() does, and if a number is not finite */
        ompl::base::ScopedState<> toState(const Doubles &values, const char *what) const;

        /** \brief A path of the team, from a row of numbers for each of its states
            \throws ompl::Exception as toState() does, if there is no row, or if an angle that counts turns moves by
            more than half of one between two rows */
        ompl::geometric::PathGeometric toPath(const Doubles &states, const char *what) const;

        /** \brief The obstacles there are now */
        ompl_certificates::ObstaclesPtr getObstacles() const;

        /** \brief The scene with the obstacles there are now, a start and a goal
            \param start, goal states of the team; null for the scene's own */
        Scene getScene(const ompl::base::State *start, const ompl::base::State *goal) const;

        /** \brief The scene that the constructor got */
        const Scene &getOriginalScene() const
        {
            return scene_;
        }

        /** \brief The setup, for planning; see beginPlanning() */
        TeamSetup &getSetup() const
        {
            return *setup_;
        }

        /** \brief The numbers of a state */
        std::size_t getCoordinateCount() const
        {
            return rotations_.count;
        }

        /** \brief The dimension of the workspace: 2 or 3 */
        unsigned int getDimension() const
        {
            return scene_.getDimension();
        }

        /** \brief The name of the scene */
        const std::string &getSceneName() const
        {
            return scene_.getName();
        }

        /** \brief How motions are checked: discrete or continuous */
        const std::string &getMotion() const
        {
            return motion_;
        }

        /** \brief Begin a plan, which ends when what is returned is destroyed
            \throws ompl::Exception if a plan with this checker is under way, in this thread (a callback) or another */
        std::shared_ptr<const Checker> beginPlanning() const;

    private:
        class Row;

        /** \brief The number of rows, after a check of the shape and of all quaternions that are finite */
        std::size_t countRows(const Doubles &states, const char *what) const;

        /** \brief Refuse what is not one state, by its shape and its quaternions. */
        void requireState(const Doubles &values, const char *what) const;

        void tell(const ompl_certificates::ObstacleChange &change);

        Scene scene_;
        std::string motion_;
        ompl_certificates::Rotations rotations_;
        World world_;
        std::unique_ptr<TeamSetup> setup_;
        mutable std::mutex changing_;
        mutable std::atomic<bool> planning_{false};
    };
}

#endif
