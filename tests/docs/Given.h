#ifndef OMPL_CERTIFICATES_TESTS_DOCS_GIVEN_
#define OMPL_CERTIFICATES_TESTS_DOCS_GIVEN_

// What the snippets of README.md and docs/*.md assume: objects of the reader's own program. A name goes here only if
// the text around the snippet, or a comment in it, explains it. Our headers and OMPL's setup are left out: a snippet
// that forgets them must not compile.

#include <Eigen/Geometry>
#include <fcl/narrowphase/collision_object.h>
#include <memory>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <vector>

namespace ompl_certificates
{
    class TeamStateSpace;
}

/** \brief The obstacles of a program that uses FCL already */
extern std::vector<std::shared_ptr<fcl::CollisionObjectd>> collisionObjects;

/** \brief The bounds of the robots' positions */
extern ompl::base::RealVectorBounds bounds;

/** \brief An existing team */
extern std::shared_ptr<ompl_certificates::TeamStateSpace> team;

/** \brief Two poses of an obstacle */
extern Eigen::Isometry3d here, there;

#endif
