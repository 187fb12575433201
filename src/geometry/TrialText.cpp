#include "TrialText.h"

#include <cstdio>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        std::string listOf(const std::vector<double> &numbers)
        {
            std::string text;
            for (const double number : numbers)
                text += (text.empty() ? "" : ", ") + textOf(number);
            return "(" + text + ")";
        }
    }

    std::string textOf(double number)
    {
        char text[32];
        std::snprintf(text, sizeof(text), "%.10g", number);
        return text;
    }

    std::string textOf(const Eigen::Vector3d &point)
    {
        return listOf({point.x(), point.y(), point.z()});
    }

    std::string textOf(const Pose &pose)
    {
        const Eigen::Quaterniond turn(pose.linear());
        return textOf(Eigen::Vector3d(pose.translation())) + " with rotation " +
               listOf({turn.x(), turn.y(), turn.z(), turn.w()});
    }

    std::string textOf(const ompl::base::StateSpace &space, const ompl::base::State *state)
    {
        std::vector<double> reals;
        space.copyToReals(reals, state);
        return listOf(reals);
    }
}
