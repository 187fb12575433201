#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_MESSAGE_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_MESSAGE_

#include <string>

namespace ompl_certificates
{
    /** \brief An octomap as ROS sends it: the fields of octomap_msgs/Octomap that tell of its cells. A program that
        links octomap_msgs may as well make an octomap::OcTree of the message. */
    struct OctomapMessage
    {
        /** \brief Whether nodes are just free or occupied, as octomap_msgs::binaryMapToMsg() writes them; else as
            fullMapToMsg() does */
        bool binary{true};

        /** \brief The type of the map: OcTree, ColorOcTree or OcTreeStamped */
        std::string id{"OcTree"};

        /** \brief The edge length of the smallest cells */
        double resolution{0.0};

        /** \brief The bytes of the nodes; none if the map is empty */
        std::string data;
    };
}

#endif
