#include "Octomaps.h"

#include "Arrays.h"
#include "Gil.h"

#include <cmath>
#include <ompl/util/Exception.h>

#ifdef OMPL_CERTIFICATES_HAVE_OCTOMAP
#include <ompl_certificates/octomap/OctomapObstacles.h>
#endif

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** Bytes, from what Python has for those of a message: bytes, an array, a list of numbers */
        std::string toBytes(const py::object &object, const std::string &what)
        {
            if (py::isinstance<py::bytes>(object))
                return object.cast<std::string>();
            const std::vector<double> numbers = toNumbers(object, what);
            std::string bytes;
            bytes.reserve(numbers.size());
            for (const double number : numbers)
            {
                if (!(number >= -128.0 && number <= 255.0 && number == std::floor(number)))
                    throw ompl::Exception(what, "must be bytes, from -128 to 255, not " + std::to_string(number));
                bytes.push_back(static_cast<char>(static_cast<int>(number)));
            }
            return bytes;
        }
    }

    OctomapMessage toOctomapMessage(const py::object &data, double resolution, bool binary, const std::string &id)
    {
        return {binary, id, resolution, toBytes(data, "data")};
    }

#ifdef OMPL_CERTIFICATES_HAVE_OCTOMAP
    std::shared_ptr<const CellObstacles> makeOctomap(unsigned int dimension, const MapSource &source,
                                                     const MapOptions &given)
    {
        const auto &[depth, unknownOccupied, heights, origin] = given;
        OctomapOptions options;
        options.depth = depth;
        options.unknownIsOccupied = unknownOccupied;
        // In the plane its z shifts the heights.
        options.origin = toOrigin(origin, 3);
        if ((dimension == 2) != heights.has_value())
            throw ompl::Exception("heights", heights ? "are for planar scenes alone"
                                                     : "a planar scene needs those of the slice, (low, high)");
        if (heights)
            options.slice = ZInterval{heights->first, heights->second};
        const GilRelease release;
        return std::visit([&](const auto &map) { return std::make_shared<OctomapObstacles>(map, options); }, source);
    }
#else
    std::shared_ptr<const CellObstacles> makeOctomap(unsigned int, const MapSource &, const MapOptions &)
    {
        throw ompl::Exception("octomap", "this module was built without octomap");
    }
#endif
}
