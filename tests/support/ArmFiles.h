#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_FILES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_FILES_

#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** The folder with the project's own arms */
        inline const std::string ARMS = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/arms/";

        /** The folder with arms from elsewhere */
        inline const std::string ROBOTS = OMPL_CERTIFICATES_SHARED_DIR "/robots/";
    }
}

#endif
