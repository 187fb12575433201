#ifndef OMPL_CERTIFICATES_CONTROL_STEP_PROOF_
#define OMPL_CERTIFICATES_CONTROL_STEP_PROOF_

#include "validity/TeamCheck.h"

#include "ompl_certificates/control/DynamicRobot.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Proves that a team is free throughout a step of its controls */
    class StepProof
    {
    public:
        /** \brief The proof of a step from \e from; \e controls are those of each robot */
        StepProof(const TeamCheck &check, CheckContext &context, const ompl::base::State *from, const double *controls,
                  const std::vector<std::size_t> &firstControl, double duration);

        /** \brief Whether each robot and each pair of robots is proved free at all times of the step */
        bool succeeds();

        /** \brief The same for one robot, and its pairs with some others */
        bool succeeds(unsigned int robot, const std::vector<unsigned int> &others);

    private:
        /** \brief Begins a proof
            \return false if the step goes back */
        bool begin();

        /** \brief Computes a robot's bounds
            \return false if they are none */
        bool computeBounds(unsigned int robot);

        /** \brief Whether some subjects are proved free throughout the step */
        bool areFree(const Subject *subjects, std::size_t count);

        /** \brief Whether a subject is proved free from time \e first to \e last of the step, which runs from 0 to 1 */
        bool isFree(const Subject &subject, double first, double last, int depth);

        /** \brief Puts the poses of a robot at a time of the step into the context */
        void place(unsigned int robot, double time);

        const DynamicRobot &robotAt(unsigned int robot) const
        {
            return static_cast<const DynamicRobot &>(check_.getTeam().getRobot(robot));
        }

        const TeamCheck &check_;
        CheckContext &context_;
        const ompl::base::State *const from_;
        const double *const controls_;
        const std::vector<std::size_t> &firstControl_;
        const double duration_;
    };
}

#endif
