#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include "ContinuousMotionCheck.h"
#include "DiscreteMotionCheck.h"
#include "SampledMotionCheck.h"

#include "ompl_certificates/team/Rotations.h"
#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/constraint/ConstrainedStateSpace.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <typeinfo>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** OMPL's counters are plain integers, but many threads may use a validator. */
        void countMotion(unsigned int &counter)
        {
            __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
        }

        /** So many refused motions are asked of a further checker, and later one in so many. */
        constexpr std::uint32_t FIRST_REFUSED = 64, ONE_REFUSED_IN = 1024;

        class RuleChecker : public ob::StateValidityChecker
        {
        public:
            RuleChecker(ob::SpaceInformation *si, CertificateMotionValidator::Rule rule)
              : StateValidityChecker(si), rule_(std::move(rule))
            {
            }

            bool isValid(const ob::State *state) const override
            {
                return rule_(state);
            }

        private:
            CertificateMotionValidator::Rule rule_;
        };

        const TeamValidityChecker &existing(const std::shared_ptr<const TeamValidityChecker> &checker)
        {
            return checker ? *checker : throw ompl::Exception("A motion validator needs a validity checker");
        }

        /** Whether a checker knows what this library's certificates know, and no more */
        bool isOfLibrary(const ob::StateValidityChecker &checker)
        {
            const std::type_info &type = typeid(checker);
            return type == typeid(TeamValidityChecker) || type == typeid(SharedProjection) || type == typeid(Partial) ||
                   type == typeid(Basic) || type == typeid(ob::AllValidStateValidityChecker);
        }

        /** Whether all samples of a motion are free, by whichever is quicker; if not, the last argument is set to the
            time up to which they are, if it is there
            \param sampled whether the method settles samples one by one */
        template <typename... FreeUntil>
        bool areSamplesFree(const TeamCheck &check, CheckContext &context, const ob::State *s1, const ob::State *s2,
                            bool sampled, FreeUntil &...freeUntil)
        {
            const auto byMethod = [&]
            {
                return sampled ? SampledMotionCheck(check, context, s1, s2).isFree(freeUntil...)
                               : DiscreteMotionCheck(check, context, s1, s2).isFree(freeUntil...);
            };
            return check.decide(context.motionPolicy, context, byMethod,
                                [&] { return SampledMotionCheck(check, context, s1, s2, true).isFree(freeUntil...); });
        }

        /** Write the state at \e t of a motion, from which OMPL can tell distances. */
        void interpolate(const ob::StateSpace &space, const ob::State *s1, const ob::State *s2, double t,
                         ob::State *state)
        {
            space.interpolate(s1, s2, t, state);
            wrapAngles(space, state);
        }

        /** Whether all of a motion is proved free; if not, \e freeUntil is set to the time up to which it is */
        bool isProved(const TeamCheck &check, CheckContext &context, const ob::State *s1, const ob::State *s2,
                      double &freeUntil)
        {
            ContinuousMotionCheck whole(check, context, s1, s2);
            if (whole.isFree(freeUntil))
                return true;
            // The motion to the last valid state has cells of its own, and must be proved in those.
            for (double step = whole.getCell(); freeUntil > 0.0; step *= 2.0)
            {
                interpolate(*check.getTeam().getStateSpace(), s1, s2, freeUntil, context.last);
                const bool proved = ContinuousMotionCheck(check, context, s1, context.last).isFree();
                --context.counts.motions;
                if (proved)
                    break;
                freeUntil = std::max(0.0, freeUntil - step);
            }
            return false;
        }
    }

    CertificateMotionValidator::CertificateMotionValidator(const std::shared_ptr<const TeamValidityChecker> &checker,
                                                           Mode mode)
      : CertificateMotionValidator(existing(checker).getSpaceInformation(), existing(checker).watchSpaceInformation(),
                                   checker, mode)
    {
        warnOfControls();
    }

    CertificateMotionValidator::CertificateMotionValidator(const ob::SpaceInformationPtr &si,
                                                           const std::shared_ptr<const TeamValidityChecker> &checker,
                                                           Mode mode)
      : CertificateMotionValidator(si.get(), si, checker, mode)
    {
        if (si->getStateSpace() != existing(checker).getTeam().getStateSpace())
            throw ompl::Exception(si->getStateSpace()->getName(), "is not the space of the validity checker");
        warnOfControls();
    }

    CertificateMotionValidator::CertificateMotionValidator(ob::SpaceInformation *si,
                                                           std::weak_ptr<ob::SpaceInformation> watched,
                                                           std::shared_ptr<const TeamValidityChecker> checker,
                                                           Mode mode)
      : MotionValidator(si ? si : throw ompl::Exception("A motion validator needs space information"))
      , spaceInformation_(std::move(watched))
      , checker_(std::move(checker))
      , mode_(mode)
    {
        const Team &team = existing(checker_).getTeam();
        const Method method = checker_->getMethod();
        if (dynamic_cast<const ob::ConstrainedStateSpace *>(team.getStateSpace().get()))
            throw ompl::Exception(
                team.getStateSpace()->getName(),
                "is constrained: keep OMPL's ConstrainedMotionValidator, which asks the validity checker");
        isSampled_ = !makesCertificates(method) || !team.interpolatesRobots();
        if (isSampled_ && mode == CONTINUOUS)
            throw ompl::Exception(makesCertificates(method)
                                      ? team.getStateSpace()->getName() +
                                            ": CertificateMotionValidator cannot check motions continuously: the space "
                                            "does not move the robots as their own spaces do. Plan in "
                                            "Robot::getStateSpace(), or in a TeamStateSpace"
                                      : "The method " + nameOf(method) +
                                            " makes no certificates and so cannot check motions continuously");
    }

    void CertificateMotionValidator::warnOfControls() const
    {
        if (mode_ == CONTINUOUS && !spaceInformation_.expired() &&
            dynamic_cast<const ompl::control::SpaceInformation *>(si_))
            OMPL_WARN(
                "CertificateMotionValidator: planners by controls ask no motion validator, so this one proves nothing. "
                "Their steps are proved by TeamPropagator::requireProof(), or in a TeamControlSetup.");
    }

    bool CertificateMotionValidator::isFree(const ob::State *s1, const ob::State *s2) const
    {
        const TeamCheck &check = checker_->getTeamCheck();
        const TeamCheck::Scope context(check);
        return mode_ == DISCRETE ? areSamplesFree(check, *context, s1, s2, isSampled_)
                                 : ContinuousMotionCheck(check, *context, s1, s2).isFree();
    }

    bool CertificateMotionValidator::isFree(const ob::State *s1, const ob::State *s2, double &freeUntil) const
    {
        const TeamCheck &check = checker_->getTeamCheck();
        const TeamCheck::Scope context(check);
        return mode_ == DISCRETE ? areSamplesFree(check, *context, s1, s2, isSampled_, freeUntil)
                                 : isProved(check, *context, s1, s2, freeUntil);
    }

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        double until = 1.0;
        const bool free = isFree(s1, s2), valid = free && areSamplesValid(s1, s2, until);
        if (!free)
            lookForPermission(s1, s2);
        countMotion(valid ? valid_ : invalid_);
        return valid;
    }

    void CertificateMotionValidator::setRule(const Rule &rule)
    {
        rule_ = rule ? std::make_shared<const RuleChecker>(si_, rule) : nullptr;
    }

    void CertificateMotionValidator::lookForPermission(const ob::State *s1, const ob::State *s2) const
    {
        if (mode_ != DISCRETE || rule_ || warnedOfPermission_)
            return;
        const ob::StateValidityChecker *further = getFurtherChecker();
        if (!further || isOfLibrary(*further))
            return;
        const std::uint32_t number = refused_.fetch_add(1, std::memory_order_relaxed);
        if (number >= FIRST_REFUSED && number % ONE_REFUSED_IN != 0)
            return;
        double until = 1.0;
        // The obstacles may have changed since the motion was refused.
        if (areSamplesValid(s1, s2, until) && !isFree(s1, s2) && !warnedOfPermission_.exchange(true))
            OMPL_WARN(
                "CertificateMotionValidator: the space information's validity checker permits states that the "
                "TeamValidityChecker does not. Motions are valid only where both permit them; to permit more, "
                "keep OMPL's motion validator.");
    }

    const ob::StateValidityChecker *CertificateMotionValidator::getFurtherChecker() const
    {
        if (rule_)
            return rule_.get();
        const ob::StateValidityChecker *set = getInformedChecker();
        if (set && set != checker_.get() && (!isOfLibrary(*set) || knowsOtherWorld(*set)))
            return set;
        return isOfLibrary(*checker_) ? nullptr : checker_.get();
    }

    const ob::StateValidityChecker *CertificateMotionValidator::getInformedChecker() const
    {
        if (!spaceInformation_.expired())
            return si_->getStateValidityChecker().get();
        if (!warnedOfLoss_.exchange(true))
            OMPL_WARN(
                "CertificateMotionValidator: the space information that it was made for is gone, and with it any "
                "validity checker of your own there. Make a motion validator with the new space information.");
        return nullptr;
    }

    bool CertificateMotionValidator::knowsOtherWorld(const ob::StateValidityChecker &checker) const
    {
        // Others, as of a proof or of a change, are made to look at a world of their own.
        if (si_->getMotionValidator().get() != this)
            return false;
        const auto *other = dynamic_cast<const TeamValidityChecker *>(&checker);
        if (!other || (other->getTeam().getRobots() == checker_->getTeam().getRobots() &&
                       other->getTeamCheck().shareObstacles() == checker_->getTeamCheck().shareObstacles()))
            return false;
        if (!warnedOfOther_.exchange(true))
            OMPL_WARN(
                "CertificateMotionValidator: the space information has another validity checker, among other "
                "obstacles or for other robots. Both are asked; make a motion validator with that one, too.");
        return true;
    }

    bool CertificateMotionValidator::areSamplesValid(const ob::State *s1, const ob::State *s2, double &until) const
    {
        const ob::StateValidityChecker *checker = getFurtherChecker();
        if (!checker)
            return true;
        const ob::StateSpacePtr &space = checker_->getTeam().getStateSpace();
        const unsigned int count = std::max(1U, space->validSegmentCount(s1, s2));
        ob::ScopedState<> sample(space);
        MotionCurve curve(*space);
        for (unsigned int i = 1; i <= count && static_cast<double>(i) / count <= until; ++i)
        {
            if (i < count)
                curve.interpolate(s1, s2, static_cast<double>(i) / count, sample.get());
            if (!checker->isValid(i < count ? sample.get() : s2))
            {
                until = static_cast<double>(i - 1) / count;
                return false;
            }
        }
        return true;
    }

    bool CertificateMotionValidator::isRobotMotionFree(unsigned int robot, const ob::State *from,
                                                       const ob::State *to) const
    {
        if (mode_ == DISCRETE)
            return checker_->isRobotMotionFree(robot, from, to);
        const TeamCheck &check = checker_->getTeamCheck();
        const TeamCheck::Scope context(check);
        return ContinuousMotionCheck(check, *context, check.getRobotSubjects(robot), {from}, {to}).isFree();
    }

    bool CertificateMotionValidator::isPairMotionFree(unsigned int first, const ob::State *firstFrom,
                                                      const ob::State *firstTo, unsigned int second,
                                                      const ob::State *secondFrom, const ob::State *secondTo) const
    {
        if (first > second)
            return isPairMotionFree(second, secondFrom, secondTo, first, firstFrom, firstTo);
        if (mode_ == DISCRETE)
            return checker_->isPairMotionFree(first, firstFrom, firstTo, second, secondFrom, secondTo);
        const TeamCheck &check = checker_->getTeamCheck();
        const TeamCheck::Scope context(check);
        return ContinuousMotionCheck(check, *context, check.getPair(first, second), {firstFrom, secondFrom},
                                     {firstTo, secondTo})
            .isFree();
    }

    bool CertificateMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                                 std::pair<ob::State *, double> &lastValid) const
    {
        double freeUntil = 1.0;
        const bool free = isFree(s1, s2, freeUntil);
        bool valid = free;
        if (!valid && mode_ == CONTINUOUS)
        {
            if (freeUntil > 0.0 && getFurtherChecker())
            {
                // The motion to the last valid state has samples of its own.
                ob::ScopedState<> last(checker_->getTeam().getStateSpace());
                interpolate(*last.getSpace(), s1, s2, freeUntil, last.get());
                double until = 1.0;
                freeUntil = areSamplesValid(s1, last.get(), until) ? freeUntil : 0.0;
            }
        }
        else if (double until = freeUntil; !areSamplesValid(s1, s2, until))
        {
            // How far a proof goes that ends earlier is not known.
            freeUntil = mode_ == DISCRETE ? until : 0.0;
            valid = false;
        }
        countMotion(valid ? valid_ : invalid_);
        if (!free)
            lookForPermission(s1, s2);
        if (!valid)
        {
            lastValid.second = freeUntil;
            if (lastValid.first)
                interpolate(*checker_->getTeam().getStateSpace(), s1, s2, freeUntil, lastValid.first);
        }
        return valid;
    }
}
