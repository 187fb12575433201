#include "KnownRobotType.h"

namespace ompl_certificates
{
    namespace
    {
        constexpr KnownRobotType KNOWN_TYPES[] = {
            {"single_integrator", StateLayout::R2, {0.1, 0.0}, 0},
            {"double_integrator", StateLayout::R2, {0.15, 0.0}, 2},
            {"unicycle_first_order", StateLayout::SE2, {0.5, 0.25}, 0},
            {"unicycle_first_order_sphere", StateLayout::SE2, {0.4, 0.0}, 0},
            {"unicycle_second_order", StateLayout::SE2, {0.5, 0.25}, 2},
            {"car_first_order", StateLayout::SE2, {0.5, 0.25}, 0},
            {"car_first_order_with_1_trailers", StateLayout::TRAILER, {0.5, 0.25}, 0},
        };
    }

    const KnownRobotType *findKnownRobotType(std::string name)
    {
        const std::size_t version = name.find("_0");
        if (version != std::string::npos && version > 0 && (version + 2 == name.size() || name[version + 2] == '_'))
            name.erase(version, 2);
        for (const KnownRobotType &type : KNOWN_TYPES)
            if (name == type.name)
                return &type;
        return nullptr;
    }

    std::vector<std::string> namesOfKnownRobotTypes()
    {
        std::vector<std::string> names;
        for (const KnownRobotType &type : KNOWN_TYPES)
            names.emplace_back(type.name);
        return names;
    }
}
