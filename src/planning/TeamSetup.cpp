#include "ompl_certificates/planning/TeamSetup.h"

#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"
#include "ompl_certificates/validity/ExactMotionValidator.h"

#include <functional>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <ompl/util/Time.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    const std::vector<Method> &allMethods()
    {
        static const std::vector<Method> methods{Method::FCL, Method::STANDARD, Method::BASIC, Method::PARTIAL,
                                                 Method::SHARED_PROJECTION};
        return methods;
    }

    std::string nameOf(Method method)
    {
        switch (method)
        {
            case Method::FCL:
                return "fcl";
            case Method::STANDARD:
                return "standard";
            case Method::BASIC:
                return "basic";
            case Method::PARTIAL:
                return "partial";
            case Method::SHARED_PROJECTION:
                return "shared";
        }
        throw ompl::Exception("Unknown method");
    }

    Method methodOf(const std::string &name)
    {
        std::string known;
        for (const Method method : allMethods())
        {
            if (nameOf(method) == name)
                return method;
            known += (known.empty() ? "" : ", ") + nameOf(method);
        }
        throw ompl::Exception("There is no method '" + name + "'; the methods are " + known);
    }

    TeamSetup::TeamSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                         CertificateMotionValidator::Mode mode)
      : SimpleSetup(team)
    {
        const auto use = [this, mode](const auto &checker)
        {
            checker_ = checker;
            si_->setMotionValidator(std::make_shared<CertificateMotionValidator>(checker, mode));
        };
        switch (method)
        {
            case Method::FCL:
            case Method::STANDARD:
                if (mode == CertificateMotionValidator::CONTINUOUS)
                    throw ompl::Exception("The method " + nameOf(method) +
                                          " makes no certificates and so cannot check motions continuously");
                checker_ = std::make_shared<TeamValidityChecker>(
                    si_, obstacles, method == Method::FCL ? ExactCheck::FCL : ExactCheck::CONTACT_TEST_THEN_FCL);
                si_->setMotionValidator(std::make_shared<ExactMotionValidator>(checker_));
                break;
            case Method::BASIC:
                use(std::make_shared<Basic>(si_, obstacles));
                break;
            case Method::PARTIAL:
                use(std::make_shared<Partial>(si_, obstacles));
                break;
            case Method::SHARED_PROJECTION:
                use(std::make_shared<SharedProjection>(si_, obstacles));
                break;
        }
        setStateValidityChecker(checker_);
    }

    void TeamSetup::simplifySolution(double duration)
    {
        simplifySolution(duration > 0.0 ? ob::timedPlannerTerminationCondition(duration)
                                        : ob::plannerNonTerminatingCondition());
    }

    void TeamSetup::simplifySolution(const ob::PlannerTerminationCondition &condition)
    {
        if (!haveSolutionPath())
        {
            OMPL_WARN("%s: there is no solution to simplify", getTeam().getName().c_str());
            return;
        }
        const auto start = ompl::time::now();
        og::PathGeometric &solution = getSolutionPath();
        og::PathGeometric simplified = solution;
        psk_->simplify(simplified, condition);
        if (simplified.check())
            solution = simplified;
        else
            simplifyInSteps(solution, condition);
        simplifyTime_ = ompl::time::seconds(ompl::time::now() - start);
    }

    void TeamSetup::simplifyInSteps(og::PathGeometric &path, const ob::PlannerTerminationCondition &condition)
    {
        const std::vector<std::function<void(og::PathGeometric &)>> steps{
            [this](og::PathGeometric &p) { psk_->reduceVertices(p); },
            [this](og::PathGeometric &p) { psk_->collapseCloseVertices(p); },
            [this](og::PathGeometric &p) { psk_->shortcutPath(p); },
            [this](og::PathGeometric &p) { psk_->smoothBSpline(p); }};
        for (const auto &step : steps)
        {
            if (condition)
                return;
            og::PathGeometric next = path;
            step(next);
            if (next.check() && next.length() <= path.length())
                path = next;
        }
    }

    void TeamSetup::setNearestStructure(NearestStructure structure)
    {
        if (configured_)
            throw ompl::Exception("Choose the structure for near states before setup()");
        nearestStructure_ = structure;
    }

    void TeamSetup::chooseObjective()
    {
        if (pdef_->hasOptimizationObjective() && pdef_->getOptimizationObjective() != objective_)
            return;
        // SimpleSetup would make it later, but in the same order.
        if (!planner_ && pa_)
        {
            si_->setup();
            planner_ = pa_(si_);
        }
        objective_ = planner_ ? defaultObjective(*planner_) : std::make_shared<TeamPathLength>(si_);
        pdef_->setOptimizationObjective(objective_);
    }

    void TeamSetup::setup()
    {
        if (!planner_ || !planner_->isSetup())
            chooseObjective();
        SimpleSetup::setup();
        if (nearestStructure_ == NearestStructure::KD_TREE)
            useKdTree(*planner_);
    }
}
