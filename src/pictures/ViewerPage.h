#ifndef OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_PAGE_
#define OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_PAGE_

#include <cstddef>

namespace ompl_certificates
{
    /** \brief viewer/dist/viewer.html: the page of PlanViewer, without a plan. The build makes it from that file; see
        cmake/EmbedFile.cmake. */
    extern const unsigned char VIEWER_PAGE[];

    /** \brief The number of its bytes */
    extern const std::size_t VIEWER_PAGE_SIZE;
}

#endif
