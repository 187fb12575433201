#ifndef OMPL_CERTIFICATES_GEOMETRY_BODY_CONTACT_
#define OMPL_CERTIFICATES_GEOMETRY_BODY_CONTACT_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/Touching.h"

namespace ompl_certificates
{
    /** \brief Whether two bodies of space touch. YES and NO stay true if one of them moves so that no point of it
        goes farther than \e margin. UNKNOWN where they just touch, and where touching() of two of their shapes is.
        Allocates nothing.
        \param pose from the frame of \e second to the frame of \e first */
    Touching touching(const Body &first, const Body &second, const Pose &pose, double margin);

    /** \brief Whether balls inside two bodies of space prove that these touch, even if one of them moves so that no
        point of it goes farther than \e margin: see MeshInside. Asks meshes alone; much quicker than touching().
        \param pose from the frame of \e second to the frame of \e first */
    bool touchDeeply(const Body &first, const Body &second, const Pose &pose, double margin);
}

#endif
