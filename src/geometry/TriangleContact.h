#ifndef OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_CONTACT_
#define OMPL_CERTIFICATES_GEOMETRY_TRIANGLE_CONTACT_

#include "ompl_certificates/geometry/TriangleTree.h"

namespace ompl_certificates
{
    /** \brief Whether two triangles cross: NO and YES stay true if one of them moves by less than \e margin. UNKNOWN where
        they lie in one plane, and for YES where one is not higher than about twice \e margin.

        Two triangles that cross have an edge that pierces the other's face. An edge does so if its ends are on both
        sides of the face, and if it passes the three edges of the face on the same side. If no edge does, beyond
        doubt, for any shift of one triangle by less than the margin, then they are at least that far apart. */
    Touching crossing(const TriangleTree::Facet &a, const TriangleTree::Facet &b, double margin);
}

#endif
