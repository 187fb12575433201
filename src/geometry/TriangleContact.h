#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_CONTACT_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_CONTACT_

#include "TriangleTree.h"

namespace ompl_certificates
{
    /** \brief Whether two triangles cross. NO and YES stay true if one of them moves so that no point of it
        goes farther than \e margin. UNKNOWN where they lie in one plane, and in place of YES where a triangle is not
        higher than about twice \e margin.

        If two triangles cross, an edge of one pierces the other's face. An edge does so if its ends are on both sides
        of the face, and if it passes the three edges of the face on the same side. If no edge can, for any shift of one
        triangle by less than the margin, they are at least that far apart. */
    Touching crossing(const TriangleTree::Facet &a, const TriangleTree::Facet &b, double margin);
}

#endif
