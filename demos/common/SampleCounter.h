#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_SAMPLE_COUNTER_
#define OMPL_CERTIFICATES_DEMOS_COMMON_SAMPLE_COUNTER_

#include "ompl_certificates/planning/TeamSetup.h"

#include <cstdint>
#include <ompl/base/MotionValidator.h>

namespace demos
{
    /** \brief A motion validator that lets another one work and tells the checks of a planner's samples from the rest.

        RRT, RRT* and their kin check one motion for each new sample, from its nearest node to itself, before anything
        else of the iteration. If it is valid, the sample becomes a node. So the end of the first motion of each
        iteration is a sample, and the motions after it, which connect nodes, are not counted here. Whether a planner is
        of that kind shows in its tree; see isConsistentWith(). For one thread. */
    class SampleCounter : public ompl::base::MotionValidator
    {
    public:
        /** \brief The checks at samples. A pose is a robot at a sample; robots that were not looked at because another
            one collides do not count. The standard method counts no poses. */
        struct Counts
        {
            /** \brief Samples that were checked, and those of them that became nodes */
            std::uint64_t samples{0}, nodes{0};

            /** \brief Poses at samples, and those of them that the obstacles had to be asked for */
            std::uint64_t samplePoses{0}, sampleAsked{0};

            /** \brief The same at samples that became nodes */
            std::uint64_t nodePoses{0}, nodeAsked{0};
        };

        /** \brief Put a counter before the motion validator of \e setup, which must outlive it */
        static std::shared_ptr<SampleCounter> insertInto(const ompl_certificates::TeamSetup &setup);

        /** \brief The next motion is that of a sample: to be called once in each iteration */
        void beginIteration()
        {
            begun_ = true;
            posesBefore_ = statistics_.getCount(&ompl_certificates::CheckCounts::robotPoses);
        }

        const Counts &getCounts() const
        {
            return counts_;
        }

        /** \brief Whether the nodes that were counted are those of a tree of \e states states that began with \e
            starts, and no sample was asked for before its motion, as EST does: the motion would find it known */
        bool isConsistentWith(std::uint64_t starts, std::uint64_t states) const
        {
            return counts_.nodes + starts == states && !askedBefore_;
        }

        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

    private:
        SampleCounter(const ompl::base::SpaceInformationPtr &si, const ompl_certificates::Statistics &statistics);

        template <typename Check>
        bool count(const Check &check) const;

        ompl::base::MotionValidatorPtr inner_;
        const ompl_certificates::Statistics &statistics_;
        mutable bool begun_{false}, askedBefore_{false};
        std::uint64_t posesBefore_{0};
        mutable Counts counts_;
    };
}

#endif
