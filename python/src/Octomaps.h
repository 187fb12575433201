#ifndef OMPL_CERTIFICATES_PYTHON_OCTOMAPS_
#define OMPL_CERTIFICATES_PYTHON_OCTOMAPS_

#include <ompl_certificates/obstacles/CellObstacles.h>
#include <ompl_certificates/octomap/OctomapMessage.h>

#include <memory>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief Which cells of an octomap count: depth, unknown_occupied, heights and origin */
    using MapOptions = std::tuple<unsigned int, bool, std::optional<std::pair<double, double>>, std::vector<double>>;

    /** \brief Where an octomap is: in a file or a message */
    using MapSource = std::variant<std::string, ompl_certificates::OctomapMessage>;

    /** \brief A message, from its fields: data as bytes, an array or a list of numbers
        \throws ompl::Exception that names data, if these are no bytes */
    ompl_certificates::OctomapMessage toOctomapMessage(const pybind11::object &data, double resolution, bool binary,
                                                       const std::string &id);

    /** \brief The occupied cells of an octomap, for a workspace of \e dimension. Other Python threads run meanwhile.
        \throws ompl::Exception as OctomapObstacles, if the heights do not fit the dimension, and if there is no
        octomap */
    std::shared_ptr<const ompl_certificates::CellObstacles> makeOctomap(unsigned int dimension, const MapSource &source,
                                                                        const MapOptions &given);
}

#endif
