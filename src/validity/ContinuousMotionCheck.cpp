#include "ContinuousMotionCheck.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        /** How many cells there are for each segment of a discrete check; a power of four */
        constexpr int CELLS = 16;
    }

    ContinuousMotionCheck::ContinuousMotionCheck(const TeamCheck &check, CheckContext &context,
                                                 const ompl::base::State *s1, const ompl::base::State *s2)
      : MotionCheck(check, context, s1, s2)
    {
        orient();
        makeCells();
    }

    ContinuousMotionCheck::ContinuousMotionCheck(const TeamCheck &check, CheckContext &context,
                                                 const SubjectRange &subjects, States from, States to)
      : MotionCheck(check, context, subjects, from, to)
    {
        makeCells();
    }

    void ContinuousMotionCheck::makeCells()
    {
        // A number of a cell and as many again can be added.
        constexpr unsigned int mostSegments = std::numeric_limits<int>::max() / (2 * CELLS) - 1;
        cells_ = CELLS * static_cast<int>(std::min(std::max(countSegments(), 1U), mostSegments));
        // Nothing shorter is proved than a cell, from its middle to both ends.
        turnsOfJump_ = 2.0 * cells_;
    }

    void ContinuousMotionCheck::orient()
    {
        const ompl::base::StateSpace &space = *check_.getTeam().getStateSpace();
        if (!check_.getTeam().isSymmetric())
            return;
        const std::size_t size = space.getSerializationLength();
        context_.serialized.resize(2 * size);
        unsigned char *first = context_.serialized.data(), *second = first + size;
        space.serialize(first, s1_);
        space.serialize(second, s2_);
        reversed_ = std::memcmp(first, second, size) > 0;
        if (reversed_)
            std::swap(context_.from, context_.to);
    }

    bool ContinuousMotionCheck::settleCell(unsigned int subject, int cell, Cells &proved)
    {
        const Subject &settled = subjects_[subject];
        if (settleCell(settled, cell, proved))
            return true;
        if (settled.kind != Subject::TEAM)
            return false;
        // Not all robots of a team need stretches of one length.
        proved = {0, cells_ - 1};
        for (unsigned int robot = settled.first; robot <= settled.last; ++robot)
        {
            Cells ofRobot;
            if (!settleCell(*check_.getRobotSubjects(robot).begin, cell, ofRobot))
                return false;
            proved = {std::max(proved.first, ofRobot.first), std::min(proved.last, ofRobot.last)};
        }
        return true;
    }

    bool ContinuousMotionCheck::settleCell(const Subject &subject, int cell, Cells &proved)
    {
        // A whole segment first: near obstacles, one contact test is less than one for each of its cells.
        for (int count = CELLS; count > 0; count /= 4)
        {
            const int first = cell - cell % count;
            if (settleCells(subject, {first, first + count - 1}, proved))
                return true;
        }
        return false;
    }

    bool ContinuousMotionCheck::settleCells(const Subject &subject, Cells cells, Cells &proved)
    {
        const double middle = 0.5 * (cells.first + cells.last + 1), half = 0.5 * (cells.last + 1 - cells.first);
        const SubjectVerdict verdict = settle(subject, (reversed_ ? cells_ - middle : middle) / cells_, half / cells_,
                                              cells.last == cells_ - 1 ? 0.0 : 1.0);
        const double interval = std::min({verdict.before, verdict.after, 1.0}) * (1.0 - OVERLAP) * cells_;
        proved = {std::min(cells.first, static_cast<int>(std::ceil(middle - interval))),
                  std::max(cells.last, static_cast<int>(std::floor(middle + interval)) - 1)};
        return verdict.free;
    }

    bool ContinuousMotionCheck::isFree()
    {
        return settleEnd() && settleStart() && settleRest();
    }

    bool ContinuousMotionCheck::settleEnd()
    {
        context_.open.clear();
        // The second state's own references are the best hints. If it has none yet, it is near the first state.
        takeReferences(s2_, s1_);
        Cells proved;
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
        {
            const bool free = settleCell(subject, cells_ - 1, proved) && isEndFree(subject);
            countEnds();
            if (!free)
                return false;
            if (proved.first > 0)
                context_.open.push_back({subject, 0, proved.first - 1});
        }
        giveReferences(s2_);
        return true;
    }

    bool ContinuousMotionCheck::settleStart()
    {
        takeReferences(s1_, s2_);
        for (OpenInterval &open : context_.open)
        {
            Cells proved;
            if (!settleCell(open.subject, 0, proved))
                return false;
            open.first = proved.last + 1;
        }
        return true;
    }

    bool ContinuousMotionCheck::settleRest()
    {
        // Breadth first: times far from all known ones come first.
        auto &queue = context_.open;
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            if (first > last)
                continue;
            const int middle = first + (last - first) / 2;
            Cells proved;
            if (!settleCell(subject, middle, proved))
                return false;
            queue.push_back({subject, first, proved.first - 1});
            queue.push_back({subject, proved.last + 1, last});
        }
        return true;
    }

    bool ContinuousMotionCheck::isFree(double &freeUntil)
    {
        // The first cell that is not proved free
        int unproved = cells_;
        takeReferences(s1_, s2_);
        for (unsigned int subject = 0; subject < subjectCount_; ++subject)
            for (int cell = 0; cell < unproved;)
            {
                Cells proved;
                if (settleCell(subject, cell, proved))
                    cell = proved.last + 1;
                else
                    unproved = cell;
            }
        for (unsigned int subject = 0; subject < subjectCount_ && unproved == cells_; ++subject)
            if (!isEndFree(subject))
                --unproved;
        if (unproved == cells_)
        {
            giveReferences(s2_);
            return true;
        }
        freeUntil = static_cast<double>(unproved) / cells_;
        return false;
    }
}
