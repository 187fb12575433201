#ifndef OMPL_CERTIFICATES_VALIDITY_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_METHOD_

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief How robots are checked against the obstacles. All methods give the same verdicts, except for a fault of
        FCL alone that docs/guarantees.md tells.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II, for the last three. */
    enum class Method
    {
        /// FCL alone, as without this library.
        FCL,
        /// The contact test, then FCL: the fastest check without memory.
        STANDARD,
        /// The team certificate of a near state certifies all robots at once, or nothing; see Basic.
        BASIC,
        /// Certificates made by a robot certify that robot; see Partial.
        PARTIAL,
        /// Certificates made by any robot certify any robot; see SharedProjection.
        SHARED_PROJECTION
    };

    /** \brief All methods in the order above */
    const std::vector<Method> &allMethods();

    /** \brief The name of a method: fcl, standard, basic, partial or shared */
    std::string nameOf(Method method);

    /** \brief The method with a name that nameOf() returns
        \throws ompl::Exception that lists the names if there is none */
    Method methodOf(const std::string &name);

    /** \brief Whether a method makes certificates */
    inline bool makesCertificates(Method method)
    {
        return method != Method::FCL && method != Method::STANDARD;
    }
}

#endif
