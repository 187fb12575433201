#ifndef OMPL_CERTIFICATES_GENERATORS_SCENE_TEXTS_
#define OMPL_CERTIFICATES_GENERATORS_SCENE_TEXTS_

#include "generators/SeededRandom.h"

#include <map>
#include <string>
#include <vector>

namespace generators
{
    /** \brief A scene as the texts of its files */
    struct SceneTexts
    {
        /** \brief The YAML file. @ stands for what the names of its meshes begin with. */
        std::string yaml;

        /** \brief The OBJ files, by the ends of their names */
        std::map<std::string, std::string> meshes;
    };

    /** \brief Write the scene to \e file, and its meshes next to it
        \throws ompl::Exception that names the file if one cannot be written */
    void writeScene(const SceneTexts &scene, const std::string &file);

    /** \brief \e value, rounded to a multiple of 1 / \e parts: what is checked is then what is written and read */
    double rounded(double value, double parts);

    /** \brief \e value with ten digits, as in listOf() */
    std::string textOf(double value);

    /** \brief A list of YAML, such as [1, 2.5] */
    std::string listOf(const std::vector<double> &values);

    /** \brief What a scene file says of a rigid robot, apart from its name, start and goal. \e shape is the inside of
        its braces: type: disc, radius: 0.3 */
    std::string rigidOf(const std::string &space, const std::string &shape);

    /** \brief The line of a robot; \e type is what rigidOf() returns */
    std::string robotOf(const std::string &name, const std::string &type, const std::vector<double> &start,
                        const std::vector<double> &goal);

    /** \brief A turn about a random axis, as a quaternion x, y, z, w */
    std::vector<double> randomTurn(SeededRandom &random);
}

#endif
