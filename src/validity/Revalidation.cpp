#include "ompl_certificates/validity/Revalidation.h"

#include "ControlSteps.h"
#include "TeamCheck.h"

#include "ompl_certificates/obstacles/MixedObstacles.h"

#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        /** The space information of a checker
            \throws ompl::Exception if it is gone */
        ob::SpaceInformationPtr informationOf(const TeamValidityChecker &checker, const std::string &instead)
        {
            if (auto si = checker.watchSpaceInformation().lock())
                return si;
            throw ompl::Exception("Revalidation", "the checker's space information is gone; " + instead);
        }

        /** The mode in which motions of the checker's states are checked */
        CertificateMotionValidator::Mode modeOf(const TeamValidityChecker &checker)
        {
            const ob::SpaceInformationPtr si = informationOf(checker, "give the mode to the constructor");
            const auto *validator = dynamic_cast<const CertificateMotionValidator *>(si->getMotionValidator().get());
            return validator ? validator->getMode() : CertificateMotionValidator::DISCRETE;
        }
    }

    Revalidation::Revalidation(const TeamValidityChecker &checker, const ObstacleChange &change)
      : Revalidation(checker, change, modeOf(checker))
    {
    }

    Revalidation::Revalidation(const TeamValidityChecker &checker, const ObstacleChange &change,
                               CertificateMotionValidator::Mode mode, StepProof isStepFree)
      : isStepFree_(std::move(isStepFree))
    {
        if (!change.added && !change.removed && !change.before && change.members.empty())
            throw ompl::Exception("Revalidation",
                                  "the change must name what was added; obstacles that are new altogether "
                                  "are added by ObstacleChange::replacing()");
        const ObstaclesPtr added = addedBy(change);
        if (!added)
            return;
        // The constructor for a user's team is private.
        checker_.reset(new TeamValidityChecker(checker.si_, checker.spaceInformation_, checker.getTeam(), added,
                                               Method::SHARED_PROJECTION));
        // There are few obstacles, so certificates pay at once.
        checker_->setAdaptive(false);
        checker_->check_->ignoreAllButObstacles();
        validator_.reset(new CertificateMotionValidator(checker_->getSpaceInformation(),
                                                        checker_->watchSpaceInformation(), checker_, mode));
    }

    bool Revalidation::staysValid(const ob::State *state) const
    {
        return !checker_ || checker_->isValid(state);
    }

    bool Revalidation::staysValid(const ob::State *from, const ob::State *to) const
    {
        return !checker_ || (checker_->isValid(from) && validator_->checkMotion(from, to));
    }

    bool Revalidation::staysValid(const ob::State *from, const oc::Control *control, double duration) const
    {
        const auto si = std::dynamic_pointer_cast<const oc::SpaceInformation>(
            informationOf(*checker_, "it propagates controls, so it must exist"));
        if (!si)
            throw ompl::Exception("Revalidation", "controls need a checker whose space information has them");
        const bool isProved = validator_->getMode() == CertificateMotionValidator::CONTINUOUS;
        if (isProved && !isStepFree_)
            throw ompl::Exception("Revalidation",
                                  "controls in continuous mode need a proof of their steps, such as "
                                  "TeamPropagator::isStepFree()");
        ob::ScopedState<> state(si->getStateSpace());
        si->copyState(state.get(), from);
        const ControlSteps steps(duration, si->getPropagationStepSize());
        for (std::size_t step = 0; step < steps.count(); ++step)
        {
            if (isProved && !isStepFree_(*checker_, state.get(), control, steps[step]))
                return false;
            si->getStatePropagator()->propagate(state.get(), control, steps[step], state.get());
            if (!checker_->isValid(state.get()))
                return false;
        }
        return true;
    }

    Revalidation::Invalid Revalidation::findInvalid(const ob::PlannerData &data) const
    {
        Invalid invalid;
        if (!checker_)
            return invalid;
        // The checker's own space information may be gone.
        const bool hasControls =
            std::dynamic_pointer_cast<oc::SpaceInformation>(checker_->watchSpaceInformation().lock()) ||
            std::dynamic_pointer_cast<oc::SpaceInformation>(data.getSpaceInformation());
        if (hasControls && !data.hasControls())
            throw ompl::Exception("Revalidation",
                                  "planners with controls need an ompl::control::PlannerData, which has these");
        std::vector<bool> isValid(data.numVertices());
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            isValid[i] = checker_->isValid(data.getVertex(i).getState());
            if (!isValid[i])
                invalid.vertices.push_back(i);
        }
        std::vector<unsigned int> ends;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            data.getEdges(i, ends);
            std::sort(ends.begin(), ends.end());
            for (const unsigned int end : ends)
            {
                const ob::State *from = data.getVertex(i).getState(), *to = data.getVertex(end).getState();
                const auto *edge = dynamic_cast<const oc::PlannerDataEdgeControl *>(&data.getEdge(i, end));
                const auto isFree = [&] {
                    return edge ? staysValid(from, edge->getControl(), edge->getDuration())
                                : validator_->checkMotion(from, to);
                };
                if (!isValid[i] || !isValid[end] || !isFree())
                    invalid.edges.emplace_back(i, end);
            }
        }
        return invalid;
    }

    std::vector<std::size_t> Revalidation::findInvalidEdges(const oc::PathControl &path) const
    {
        std::vector<std::size_t> invalid;
        if (!checker_)
            return invalid;
        if (path.getStateCount() == 1 && !staysValid(path.getState(0)))
            invalid.push_back(0);
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            if (!checker_->isValid(path.getState(i)) ||
                !staysValid(path.getState(i), path.getControl(i), path.getControlDuration(i)))
                invalid.push_back(i);
        return invalid;
    }

    std::vector<std::size_t> Revalidation::findInvalidEdges(const ompl::geometric::PathGeometric &path) const
    {
        std::vector<std::size_t> invalid;
        if (!checker_)
            return invalid;
        if (path.getStateCount() == 1 && !staysValid(path.getState(0)))
            invalid.push_back(0);
        bool isValid = path.getStateCount() > 0 && checker_->isValid(path.getState(0));
        for (std::size_t i = 0; i + 1 < path.getStateCount(); ++i)
        {
            const bool isNextValid = checker_->isValid(path.getState(static_cast<unsigned int>(i + 1)));
            if (!isValid || !isNextValid ||
                !validator_->checkMotion(path.getState(static_cast<unsigned int>(i)),
                                         path.getState(static_cast<unsigned int>(i + 1))))
                invalid.push_back(i);
            isValid = isNextValid;
        }
        return invalid;
    }
}
