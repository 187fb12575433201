#ifndef OMPL_CERTIFICATES_SCENE_SRDF_READER_
#define OMPL_CERTIFICATES_SCENE_SRDF_READER_

#include "ompl_certificates/scene/ArmFile.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class XmlFile;

    /** \brief What files round numbers of joints and transforms by, at most: to three or four digits */
    constexpr double FILE_ROUNDING = 1e-3;

    /** \brief Whether a joint stays where it is, since both of its limits are equal */
    bool hasEqualLimits(const KinematicTree::Joint &joint);

    /** \brief The value of a joint as a file has it: if it is beyond a limit by no more than FILE_ROUNDING, the limit */
    double withinLimits(const KinematicTree::Joint &joint, double value);

    /** \brief What an SRDF file says about the robot of a URDF file */
    struct SrdfModel
    {
        /** \brief Read \e file about the links and joints of \e tree, the robot of that name. Names that the tree does not
            have are ignored and noted.
            \throws ompl::Exception see ArmFile */
        SrdfModel(const std::string &file, const std::string &robot, const KinematicTree &tree);

        /** \brief Without a file: one group without a name, of all joints that can move */
        explicit SrdfModel(const KinematicTree &tree);

        /** \brief Whether two links are not checked against each other */
        bool isDisabled(const std::string &first, const std::string &second) const;

        /** \brief Whether a link is not checked against anything, but for the pairs that the file enables again */
        bool isDisabledByDefault(const std::string &link) const
        {
            return disabledLinks_.count(link) > 0;
        }

        /** \brief The joints of each group: those that a plan can move, in the order of the tree */
        std::map<std::string, std::vector<std::string>> groups;

        /** \brief The values of the joints in each state of a group, by group and state. */
        std::map<std::string, std::map<std::string, std::map<std::string, double>>> states;

        /** \brief The joint between the root and the world, if there is one */
        std::optional<VirtualJoint> virtualJoint;

        /** \brief The joints that the file calls passive: they are in no group */
        std::set<std::string> passive;

        /** \brief What a user should know, one line each */
        std::vector<std::string> notes;

        /** \brief Those of the notes that tell what groups or frames may lack */
        std::vector<std::string> ignored;

        /** \brief Add \e note to these and to those */
        void ignore(const std::string &note);

    private:
        void readPairs(const XmlFile &file, const KinematicTree &tree);

        using Pair = std::pair<std::string, std::string>;
        std::set<Pair> disabled_, enabled_;
        std::set<std::string> disabledLinks_;
    };
}

#endif
