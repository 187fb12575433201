#ifndef OMPL_CERTIFICATES_BENCHMARKS_COMMON_LOOKUP_RECORD_
#define OMPL_CERTIFICATES_BENCHMARKS_COMMON_LOOKUP_RECORD_

#include "ompl_certificates/certificates/CertificateTree.h"
#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <cstdint>
#include <vector>

namespace benchmarks
{
    /** \brief A plan's query to a store of certificates: any that settles \e ball, near \e hint, which did not */
    struct Lookup
    {
        ompl_certificates::BallQuery ball;
        ompl_certificates::CertificateIndex hint;
    };

    /** \brief The certificates of plans, in the order in which they were made, and the lookups of later plans in
        them */
    struct LookupRecord
    {
        std::vector<ompl_certificates::Certificate> certificates;
        std::vector<Lookup> lookups;

        /** \brief How many of \e lookups find a certificate that proves freedom, and how many one that proves
            collision */
        std::size_t free{0}, colliding{0};

        /** \brief How many more lookups the hints made needless */
        std::size_t hinted{0};
    };

    /** \brief What to plan, again and again from random starts, by RRT and RRT* in turns */
    struct LookupPlans
    {
        /** \brief Teams that share the certificates, in turns */
        std::vector<ompl_certificates::TeamStateSpacePtr> teams;
        ompl_certificates::ObstaclesPtr obstacles;

        /** \brief The length of a robot's steps, and the part of it at which OMPL checks motions */
        double range, resolution;
        std::uint_fast32_t seed{1};
    };

    /** \brief Plan until there are \e certificates certificates, keep no more of them, and plan on until there are
        \e lookups lookups. Stops early after \e iterations iterations without either. */
    LookupRecord recordLookups(const LookupPlans &plans, std::size_t certificates, std::size_t lookups,
                               unsigned int iterations = 50000000);
}

#endif
