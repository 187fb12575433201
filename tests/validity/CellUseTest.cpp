#include "validity/CellUse.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;

TEST(CellUse, PaysForFewProofsWithoutAnswers)
{
    CellUse use;
    unsigned int proofs = 0;
    for (; use.pays() && proofs < 1000; ++proofs)
        use.countProof();
    EXPECT_GT(proofs, 0U);
    EXPECT_LT(proofs, 10U);
    // Answers of cells that are known, such as by other checkers of the robot, make up for them.
    for (unsigned int answer = 0; answer < 1000; ++answer)
        use.countAnswer();
    unsigned int more = 0;
    for (; use.pays() && more < 1000; ++more)
        use.countProof();
    EXPECT_GT(more, 100U);
    EXPECT_LT(more, 1000U);
    // Now and then one is tried nevertheless.
    for (unsigned int refusal = 0; refusal < 10000 && !use.pays(); ++refusal)
        use.countRefusal();
    EXPECT_TRUE(use.pays());
}
