#include "PairPadding.h"

#include "ContactText.h"

#include "ompl_certificates/robots/Arm.h"

namespace ompl_certificates
{
    double paddingBetween(const Robot &first, std::size_t body, const Robot &second, std::size_t otherBody)
    {
        const auto *arm = dynamic_cast<const Arm *>(&first), *other = dynamic_cast<const Arm *>(&second);
        const bool isOne = &first == &second || (arm && other && arm->isPartWith(*other));
        if (isOne && !isOwnObstacle(first, body) && !isOwnObstacle(second, otherBody))
            return 0.0;
        return first.getBodies()[body].getPadding() + second.getBodies()[otherBody].getPadding();
    }
}
