#include "MoveItWorld.h"

#include "MoveItFrames.h"
#include "MoveItMessages.h"
#include "MoveItOctomap.h"
#include "MoveItPlanes.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        /** The bodies of an arm's links, where those that stand still are */
        class Links
        {
        public:
            explicit Links(const Arm &arm) : arm_(arm), poses_(arm.getBodies().size())
            {
                ompl::base::ScopedState<> any(arm.getStateSpace());
                any = std::vector<double>(arm.getStateSpace()->getValueLocations().size(), 0.0);
                arm.placeBodies(any.get(), poses_.data());
                for (std::size_t i = 0; i < poses_.size(); ++i)
                    names.push_back(arm.getLinkOfBody(i));
            }

            /** Whether a body stands still and touches none of \e obstacles and of \e octomap, if there is one */
            bool staysClearOf(std::size_t body, const std::vector<PlacedBody> &obstacles,
                              const Obstacles *octomap) const
            {
                const auto isClearOf = [&](const Obstacles &all)
                { return !all.collides(arm_.getBodies()[body], poses_[body]); };
                return !arm_.moves(names[body]) && (obstacles.empty() || isClearOf(FclObstacles(obstacles, 3))) &&
                       (!octomap || isClearOf(*octomap));
            }

            std::vector<std::string> names;

        private:
            const Arm &arm_;
            std::vector<Pose> poses_;
        };
    }

    MoveItWorld::MoveItWorld(const YamlNode &node, const std::map<std::string, Pose> &frames, const std::string &folder,
                             std::vector<std::string> &notes)
    {
        node.allow({"collision_objects", "octomap"});
        if (node.has("octomap"))
        {
            octomapNode_.emplace(node.at("octomap"));
            octomap_ = readMoveItOctomap(*octomapNode_, frames);
        }
        std::set<std::string> names;
        for (const YamlNode &item : moveItItems(node, "collision_objects"))
        {
            const MoveItObject read = readMoveItObject(item, folder, notes);
            if (!names.insert(read.name).second)
                item.at("id").fail("there is an object '" + read.name + "' already");
            const Pose &frame = readMoveItFrame(item, frames);
            Object object;
            object.name = read.name;
            for (const MoveItObject::Placed &placed : read.shapes)
            {
                object.shapes.push_back({placed.shape.body, frame * placed.shape.pose});
                object.titles.push_back(placed.node.getKey() + " of '" + read.name + "'");
            }
            object.solids = object.shapes.size();
            for (const MoveItObject::Plane &plane : read.planes)
            {
                object.planes.push_back(frame * plane.pose);
                object.planeTitles.push_back(plane.node.getKey() + " of '" + read.name + "'");
            }
            objects_.push_back(std::move(object));
        }
    }

    void MoveItWorld::cutPlanes(const Arm &arm, const ArmFile::ArmSettings &settings)
    {
        const double reach = reachOf(arm, settings.jointValues);
        for (Object &object : objects_)
            for (std::size_t i = 0; i < object.planes.size(); ++i)
            {
                object.shapes.push_back(planeWithin(object.planes[i], settings.base.translation(), reach));
                object.titles.push_back(object.planeTitles[i]);
            }
    }

    void MoveItWorld::moveTouchable(const MoveItMatrix &matrix, const Arm &arm, ArmFile::ArmSettings &settings,
                                    std::vector<std::string> &notes)
    {
        const Links links(arm);
        std::vector<std::string> checked;
        for (std::size_t i = 0; i < links.names.size(); ++i)
        {
            const std::string &link = links.names[i];
            std::vector<PlacedBody> forbidden;
            const bool mayTouchMap = octomap_ && matrix.mayTouch(link, MOVE_IT_OCTOMAP);
            const Obstacles *const forbiddenMap = mayTouchMap ? nullptr : octomap_.get();
            bool mayTouchSome = mayTouchMap || matrix.mayTouchByDefault(link);
            for (const Object &object : objects_)
                if (matrix.mayTouch(link, object.name))
                    mayTouchSome = true;
                else
                    forbidden.insert(forbidden.end(), object.shapes.begin(), object.shapes.end());
            const bool isUnchecked = forbidden.empty() && !forbiddenMap && matrix.mayTouchByDefault(link);
            if (!isUnchecked && !(mayTouchSome && links.staysClearOf(i, forbidden, forbiddenMap)))
            {
                if (mayTouchMap)
                    octomapNode_->fail("link '" + link +
                                       "' may touch it, as the allowed collision matrix says, which is not supported");
                checked.push_back(link);
                continue;
            }
            settings.mayTouchObstacles.push_back(link);
            notes.push_back("link '" + link + "' is not checked against obstacles: it may touch " +
                            (isUnchecked ? "all" : "some, and stands still, clear of the others"));
        }
        const auto isTouchable = [&](const Object &object)
        {
            TouchableObstacle touchable{object.name, Body::sphere(0.0), Pose::Identity(), settings.mayTouchObstacles};
            const std::size_t unchecked = touchable.touchLinks.size();
            for (const std::string &link : checked)
                if (matrix.mayTouch(link, object.name))
                    touchable.touchLinks.push_back(link);
            if (touchable.touchLinks.size() == unchecked || object.shapes.empty())
                return false;
            touchable.body = Body::join(object.shapes);
            settings.touchable.push_back(std::move(touchable));
            return true;
        };
        objects_.erase(std::remove_if(objects_.begin(), objects_.end(), isTouchable), objects_.end());
    }
}
