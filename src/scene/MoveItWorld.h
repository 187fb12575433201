#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_WORLD_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_WORLD_

#include "MoveItMatrix.h"
#include "YamlNode.h"
#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/scene/ArmFile.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The obstacles of a PlanningSceneWorld */
    class MoveItWorld
    {
    public:
        /** \brief A CollisionObject in the workspace, with what its shapes are called in messages */
        struct Object
        {
            std::string name;
            std::vector<PlacedBody> shapes;
            /** \brief The number of shapes that are not cut from planes; these come last */
            std::size_t solids{0};
            std::vector<std::string> titles;
            std::vector<Pose> planes;
            std::vector<std::string> planeTitles;
        };

        /** \brief No obstacles */
        MoveItWorld() = default;

        /** \param frames the frames that obstacles can be in
            \param folder where meshes of files are looked for
            \param notes what a user should know is added here
            \throws ompl::Exception that names the node */
        MoveItWorld(const YamlNode &node, const std::map<std::string, Pose> &frames, const std::string &folder,
                    std::vector<std::string> &notes);

        /** \brief All objects, in their order */
        const std::vector<Object> &getObjects() const
        {
            return objects_;
        }

        /** \brief The occupied cells of the octomap; null if there is none */
        const std::shared_ptr<const CellObstacles> &getOctomap() const
        {
            return octomap_;
        }

        /** \brief Add to the shapes of objects the parts of their planes that \e arm can touch; see planeWithin() */
        void cutPlanes(const Arm &arm, const ArmFile::ArmSettings &settings);

        /** \brief Move objects that links may touch from here to \e settings, where they count as links, and name there
            the links that may touch all others. A link of \e arm that stands still is one of these if it may touch some
            and is clear of the others. Planes must be cut.
            \param arm the robot, without these settings
            \param notes what a user should know is added here
            \throws ompl::Exception if other links may touch the octomap */
        void moveTouchable(const MoveItMatrix &matrix, const Arm &arm, ArmFile::ArmSettings &settings,
                           std::vector<std::string> &notes);

    private:
        std::vector<Object> objects_;
        std::shared_ptr<const CellObstacles> octomap_;
        /** \brief Where messages say that the octomap is */
        std::optional<YamlNode> octomapNode_;
    };
}

#endif
