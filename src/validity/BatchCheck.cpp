#include "BatchCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    bool BatchCheck::areFree(std::size_t count)
    {
        SampleBatch &batch = context_.batch;
        for (unsigned int robot = 0; robot < batch.team.getRobotCount(); ++robot)
            for (std::size_t k = count; k < PoseBatch::SIZE; ++k)
                batch.robotState(robot, k) = batch.robotState(robot, 0);
        findNear();
        for (std::size_t sample = 0; sample < count; ++sample)
            if (!isFree(sample))
                return false;
        return true;
    }

    void BatchCheck::placeBatch(unsigned int robot)
    {
        SampleBatch &batch = context_.batch;
        std::size_t index = batch.team.getFirstBody(robot);
        PoseError error =
            batch.team.getRobot(robot).computePoseBatch(&batch.robotState(robot, 0), batch.poses.data() + index);
        double rounding = 0.0;
        for (const Body &body : batch.team.getRobot(robot).getBodies())
        {
            rounding = std::max(
                rounding, placePoint(batch.poses[index], body.getSphereTree().getRoot().center, batch.centers[index]));
            ++index;
        }
        error.linear += rounding;
        batch.errors[robot] = error;
    }

    void BatchCheck::findNear()
    {
        SampleBatch &batch = context_.batch;
        forEachRobot([this](unsigned int robot) { placeBatch(robot); });
        for (unsigned int i = 0; i < subjects_.count; ++i)
        {
            const Subject &subject = subjects_.begin[i];
            if (subject.kind == Subject::PAIR)
                check_.getPairs().findNear(subject.pair, context_);
            else
                subject.forEachRobot(
                    [&](unsigned int robot)
                    {
                        std::size_t index = batch.team.getFirstBody(robot);
                        for (const Body &body : batch.team.getRobot(robot).getBodies())
                        {
                            const BatchMask near =
                                batch.team.mayTouchObstacles(index)
                                    ? BatchMask(0)
                                    : check_.getObstacles().mayTouch(body, batch.poses[index], batch.errors[robot]);
                            // What is not finite is no valid state, whatever the user's own mayTouch() makes of it.
                            batch.nearObstacles[index] = static_cast<BatchMask>(near | notFinite(batch.centers[index]));
                            ++index;
                        }
                    });
        }
    }

    bool BatchCheck::isFree(std::size_t sample)
    {
        SampleBatch &batch = context_.batch;
        forEachRobot([&](unsigned int robot) { context_.placed[robot] = batch.robotState(robot, sample); });
        const auto haveAll = [this](bool pairs, const auto &isFree)
        {
            for (unsigned int i = 0; i < subjects_.count; ++i)
                if ((subjects_.begin[i].kind == Subject::PAIR) == pairs && !isFree(subjects_.begin[i]))
                    return false;
            return true;
        };
        if (!haveAll(true, [&](const Subject &pair)
                     { return check_.getPairs().settleNearByCells(sample, pair.pair, context_); }))
            return false;
        if (isAnythingNear(sample))
            forEachRobot([&](unsigned int robot) { check_.place(robot, batch.robotState(robot, sample), context_); });
        const auto areRobotsFree = [&](const Subject &subject)
        {
            bool free = true;
            subject.forEachRobot([&](unsigned int robot)
                                 { free = free && check_.getStandardMethod().isFreeAt(sample, robot, context_); });
            return free;
        };
        return haveAll(false, areRobotsFree) &&
               haveAll(true,
                       [&](const Subject &pair) { return check_.getPairs().areApartAt(sample, pair.pair, context_); });
    }

    bool BatchCheck::isAnythingNear(std::size_t sample) const
    {
        const SampleBatch &batch = context_.batch;
        BatchMask near = 0;
        const auto add = [&near](const std::vector<BatchMask> &masks, std::size_t first, std::size_t end)
        {
            for (std::size_t i = first; i < end; ++i)
                near |= masks[i];
        };
        for (unsigned int i = 0; i < subjects_.count; ++i)
        {
            const Subject &subject = subjects_.begin[i];
            if (subject.kind == Subject::PAIR)
                add(batch.nearEachOther, check_.getPairs().getFirstBodyPair(subject.pair),
                    check_.getPairs().getFirstBodyPair(subject.pair + 1));
            else
                add(batch.nearObstacles, batch.team.getFirstBody(subject.first),
                    batch.team.getFirstBody(subject.last + 1));
        }
        return contains(near, sample);
    }
}
