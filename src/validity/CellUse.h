#ifndef OMPL_CERTIFICATES_VALIDITY_CELL_USE_
#define OMPL_CERTIFICATES_VALIDITY_CELL_USE_

#include <cstdint>

namespace ompl_certificates
{
    /** \brief How often small joint cells of a pair of bodies gave an answer, and how often one was proved. A proof costs
        more than the check that it spares. It pays where a planner comes back to the same cells, but not where it moves
        through all of a robot's joint limits. */
    class CellUse
    {
    public:
        /** \brief Counts a check that a small cell has answered */
        void countAnswer()
        {
            ++answers_;
        }

        /** \brief Counts the proof of a small cell */
        void countProof()
        {
            ++proofs_;
        }

        /** \brief Counts a proof that was left out */
        void countRefusal()
        {
            ++refusals_;
        }

        /** \brief Whether another proof is worth its time. Sometimes one is: the planner may be elsewhere now. */
        bool pays() const
        {
            return proofs_ < FREE_PROOFS + answers_ / ANSWERS_PER_PROOF + refusals_ / REFUSALS_PER_PROOF;
        }

    private:
        static constexpr std::uint64_t FREE_PROOFS = 4, ANSWERS_PER_PROOF = 4, REFUSALS_PER_PROOF = 1024;

        std::uint64_t answers_{0}, proofs_{0}, refusals_{0};
    };
}

#endif
