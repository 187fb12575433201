#include "ompl_certificates/validity/TeamSetup.h"

#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"
#include "ompl_certificates/validity/TimedMotionValidator.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    const std::vector<Method> &allMethods()
    {
        static const std::vector<Method> methods{Method::STANDARD, Method::BASIC, Method::PARTIAL,
                                                 Method::SHARED_PROJECTION};
        return methods;
    }

    std::string nameOf(Method method)
    {
        switch (method)
        {
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
            case Method::STANDARD:
                if (mode == CertificateMotionValidator::CONTINUOUS)
                    throw ompl::Exception(
                        "The standard method makes no certificates and so cannot check motions continuously");
                checker_ = std::make_shared<TeamValidityChecker>(si_, obstacles);
                si_->setMotionValidator(std::make_shared<TimedMotionValidator>(si_, checker_));
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

    void TeamSetup::setNearestStructure(NearestStructure structure)
    {
        if (configured_)
            throw ompl::Exception("The structure for near states is to be chosen before setup()");
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
