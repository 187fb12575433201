#ifndef OMPL_CERTIFICATES_GENERATORS_SCENE_SKETCH_
#define OMPL_CERTIFICATES_GENERATORS_SCENE_SKETCH_

#include "generators/MeshBuilder.h"
#include "generators/TeamPlaces.h"

#include <functional>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <string>

namespace generators
{
    /** \brief A shape, as scene files tell of it and as a body */
    struct SketchedShape
    {
        std::string name;
        std::string text;
        ompl_certificates::Body body;

        static SketchedShape disc(double radius);
        static SketchedShape sphere(double radius);
        static SketchedShape cylinder(double radius, double length);

        /** \brief A box with two or three sides */
        static SketchedShape box(const std::vector<double> &sides);

        /** \brief A mesh in the plane, whose file ends with \e name and .obj */
        static SketchedShape planarMesh(const std::string &name, const MeshBuilder &mesh);
    };

    /** \brief A kind of robot, as scene files tell of it and as one makes it */
    struct SketchedRobot
    {
        std::string name;
        std::string text;
        std::function<ompl_certificates::RobotPtr(const std::string &, const ompl::base::RealVectorBounds &)> make;

        /** \brief A robot of one body. It turns unless it is a disc or a sphere. */
        static SketchedRobot rigid(const SketchedShape &shape);

        static SketchedRobot carWithTrailer(const SketchedShape &car, const SketchedShape &trailer, double hitchLength);
    };

    /** \brief A scene in the making: obstacles, and robots that still need a place */
    class SceneSketch
    {
    public:
        /** \brief A workspace from the origin to \e sides, which are two or three. Motions are checked every \e
            step. */
        SceneSketch(const std::vector<double> &sides, double step);

        /** \brief Add an obstacle, turned by \e angle about the z axis in the plane */
        void addObstacle(const SketchedShape &shape, const std::vector<double> &center, double angle = 0.0);

        /** \brief Add a robot that starts and ends in zones */
        void addRobot(const SketchedRobot &robot, const Ends<Zone> &zones);

        /** \brief All positions */
        const Zone &getWorkspace() const
        {
            return workspace_;
        }

        /** \brief Place the robots, and return the text of the scene file
            \throws ompl::Exception if no place was found for a robot */
        std::string toYaml(SeededRandom &random) const;

    private:
        ompl::base::RealVectorBounds bounds_;
        Zone workspace_;
        std::vector<ompl_certificates::PlacedBody> obstacles_;
        ompl_certificates::TeamStateSpacePtr team_;
        std::vector<std::string> robotTexts_;
        std::vector<Ends<Zone>> zones_;
        std::string head_, obstacleTexts_;
    };
}

#endif
