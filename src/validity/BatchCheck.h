#ifndef OMPL_CERTIFICATES_VALIDITY_BATCH_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_BATCH_CHECK_

#include "SampleOrder.h"
#include "TeamCheck.h"

namespace ompl_certificates
{
    /** \brief Checks samples of a motion, several at once, as Method::STANDARD does one by one.

        First it looks at bounding volumes at all samples of a batch, in single precision. What these leave open it
        checks sample by sample, in the same order as ever. For robots of many bodies, most of which are far from
        everything at most samples. */
    class BatchCheck
    {
    public:
        /** \brief A check of \e subjects; a TEAM stands for its robots
            \param context the states of its batch are taken from the caller */
        BatchCheck(const TeamCheck &check, CheckContext &context, const SubjectRange &subjects)
          : check_(check), context_(context), subjects_(subjects)
        {
        }

        /** \brief Whether the next samples are free. They are \e least samples or some more, if so many are left.
            \param withEnd whether to begin with the end of the motion, as if it were a sample of number \e end
            \param place puts the robots' states at the sample of a number into the batch */
        template <typename Place>
        bool areFree(BreadthFirstSamples &samples, std::size_t least, bool withEnd, int end, const Place &place)
        {
            for (std::size_t done = 0; withEnd || (done < least && !samples.isAtEnd()); withEnd = false)
            {
                std::size_t count = 0;
                if (withEnd)
                    place(end, count++);
                while (count < PoseBatch::SIZE && !samples.isAtEnd())
                    place(samples.next(), count++);
                if (!areFree(count))
                    return false;
                done += count;
            }
            return true;
        }

    private:
        /** \brief Whether the first \e count samples of the batch are free */
        bool areFree(std::size_t count);

        /** \brief Computes the poses of a robot at all samples */
        void placeBatch(unsigned int robot);

        /** \brief Notes in the batch which bodies are near something */
        void findNear();

        bool isFree(std::size_t sample);

        /** \brief Whether anything is near something at a sample */
        bool isAnythingNear(std::size_t sample) const;

        /** \brief Calls \e visit once for each robot of the subjects: a pair stands alone, or after its robots. */
        template <typename Visit>
        void forEachRobot(const Visit &visit) const
        {
            for (unsigned int i = 0; i < subjects_.count; ++i)
                if (i == 0 || subjects_.begin[i].kind != Subject::PAIR)
                    subjects_.begin[i].forEachRobot(visit);
        }

        const TeamCheck &check_;
        CheckContext &context_;
        const SubjectRange subjects_;
    };
}

#endif
