#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_SCENES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_SCENES_

#include "ArmFiles.h"

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <memory>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A scene of the demo arm with \e keys */
        inline Scene sceneWithArm(const std::string &keys, const std::string &end = "start: ready, goal: upright")
        {
            return sceneFromYaml(
                "environment: {min: [-1, -1, 0], max: [1, 1, 2]}\n"
                "robots:\n"
                "  - {type: urdf, file: arm6.urdf, srdf: arm6.srdf, group: arm, " +
                    (keys.empty() ? "" : keys + ", ") + end + "}\n",
                ARMS + "test.yaml");
        }

        /** \brief The first robot of such a scene */
        inline std::shared_ptr<const Arm> armOf(const Scene &scene)
        {
            return std::dynamic_pointer_cast<const Arm>(scene.getMembers().front().robot);
        }

        /** \brief What is wrong with such a scene; empty if nothing */
        inline std::string messageAboutArm(const std::string &keys,
                                           const std::string &end = "start: ready, goal: upright")
        {
            try
            {
                sceneWithArm(keys, end);
            }
            catch (const ompl::Exception &exception)
            {
                return exception.what();
            }
            return "";
        }
    }
}

#endif
