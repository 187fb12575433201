#ifndef OMPL_CERTIFICATES_VALIDITY_JOINT_CELL_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_JOINT_CELL_CHECK_

#include "CheckContext.h"

#include "ompl_certificates/robots/JointCells.h"

namespace ompl_certificates
{
    /** \brief Asks the joint cells of two bodies of a robot, and settles cells that are new */
    class JointCellCheck
    {
    public:
        /** \brief The check of a pair of a robot's bodies, which has \e cells
            \param margin what a gap between the bodies must exceed for the exact check to find them apart
            \param contactMargin the margin of their contact test */
        JointCellCheck(unsigned int robot, const Robot &description, std::size_t pair,
                       std::shared_ptr<JointCells> cells, double margin, double contactMargin);

        /** \brief What is known of the two bodies where \e context has placed the robot: APART, TOUCHING or nothing */
        JointCells::Answer find(const CheckContext &context) const
        {
            return cells_->find(valuesOf(context.placed[robot_])).answer;
        }

        /** \brief The same, but settles the cell if it is new; a small one when it is asked for again, if that pays. By
            the gap between convex covers and by balls inside meshes, which costs a few microseconds; by the contact
            test where the cell is small enough for that.
            \param number that of the pair of bodies among those of \e context */
        JointCells::Answer settle(CheckContext &context, std::size_t number) const;

        /** \brief Settles the cells of one of the first two levels that are new, unless this was done before, by any
            checker
            \param most how many of them, at most
            \param state one within its bounds; those of its coordinates that move the bodies are changed
            \param poses for all bodies of the robot
            \return how many were settled. Cost: some microseconds each */
        std::size_t settleLarge(unsigned int level, std::size_t most, ompl::base::State *state, Pose *poses) const;

        /** \brief How long the bodies are known to be apart before and after the time of their poses, along the motion
            that is checked */
        std::array<double, 2> apartFor(const CheckContext &context) const;

    private:
        /** \brief Only with up to so many coordinates are cells of the third level so small that the contact test
            settles them. */
        static constexpr std::size_t MOST_FOR_CONTACT = 2;

        JointCells::Values valuesOf(const ompl::base::State *state) const;

        /** \brief Whether a cell is so small that the contact test may settle it */
        bool mayContactSettle(const JointCells::Cell &cell) const;

        /** \brief What holds in all of \e cell. UNKNOWN if the robot's state proves nothing: it is beyond its bounds,
            or not finite.
            \param values any in the cell
            \param state where the robot is, but for these values; they become those of the middle
            \param poses for all bodies of the robot */
        JointCells::Answer prove(const JointCells::Cell &cell, JointCells::Values values, ompl::base::State *state,
                                 Pose *poses, CheckCounts &counts) const;

        const unsigned int robot_;
        const Robot &description_;
        const BodyPair pair_;
        const std::shared_ptr<JointCells> cells_;
        const double margin_, contactMargin_;
        std::vector<ompl::base::StateSpace::ValueLocation> locations_;
    };
}

#endif
