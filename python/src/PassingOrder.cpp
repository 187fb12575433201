#include "Arrays.h"
#include "Bindings.h"
#include "Numbers.h"

#include <ompl_certificates/planning/PassingOrder.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <pybind11/stl.h>
#include <vector>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        using Integers = py::array_t<std::int64_t>;

        /** The index of a robot; of none if it is too large */
        unsigned int toIndex(const Number &number)
        {
            constexpr std::uint64_t most = std::numeric_limits<unsigned int>::max();
            return static_cast<unsigned int>(std::min<std::uint64_t>(number, most));
        }

        /** One row for each of \e items, with the numbers that \e write gives it */
        template <typename Item, typename Write>
        Integers toRows(const std::vector<Item> &items, py::ssize_t columns, const Write &write)
        {
            Integers rows({static_cast<py::ssize_t>(items.size()), columns});
            std::int64_t *number = rows.mutable_data();
            for (const Item &item : items)
                for (const std::size_t value : write(item))
                    *number++ = static_cast<std::int64_t>(value);
            return rows;
        }
    }

    void bindPassingOrder(py::module_ &module)
    {
        py::class_<PassingOrder> order(
            module, "PassingOrder",
            "Which robot passes first wherever the ways of two robots of a plan cross, for robots that may be late. The "
            "plan is cut into stages in time. Each robot drives its stages one after the other at its own pace, and "
            "begins one only when may_begin() says so; the robots of a group() drive that stage together, by one clock. "
            "Then no two robots touch, and none waits forever.");
        forbidNew(order, "Plan.passing_order() makes them");
        order
            .def_property_readonly(
                "times",
                [](const PassingOrder &self)
                { return Doubles(static_cast<py::ssize_t>(self.getTimes().size()), self.getTimes().data()); },
                "When the stages begin and end in the plan, of shape (stages + 1,): stage i is from times[i] to "
                "times[i + 1]")
            .def_property_readonly(
                "waits",
                [](const PassingOrder &self)
                {
                    return toRows(
                        self.getWaits(), 4,
                        [](const PassingOrder::Wait &wait) {
                            return std::array<std::size_t, 4>{wait.robot, wait.stage, wait.other, wait.otherStage};
                        });
                },
                "What robots wait for, of shape (n, 4): robot, stage, other, other_stage. The robot begins that stage only "
                "after the other one has ended its other_stage. By robots and then by stages; what earlier waits imply "
                "is left out.")
            .def_property_readonly(
                "meetings",
                [](const PassingOrder &self)
                {
                    return toRows(self.getMeetings(), 3,
                                  [](const PassingOrder::Meeting &meeting) {
                                      return std::array<std::size_t, 3>{meeting.first, meeting.second, meeting.stage};
                                  });
                },
                "Which robots drive which stages together, by one clock, as the plan does, since they are too close to "
                "each other there, of shape (m, 3): first, second, stage. They wait for each other before it. Smaller "
                "stages leave fewer.")
            .def(
                "group",
                [](const PassingOrder &self, const Number &robot, const Number &stage)
                { return self.getGroup(toIndex(robot), stage); },
                py::arg("robot"), py::arg("stage"),
                "The robots that drive a stage together with a robot, and itself, by their indices in the scene")
            .def(
                "may_begin",
                [](const PassingOrder &self, const Number &robot, const std::vector<std::size_t> &ended)
                { return self.mayBegin(toIndex(robot), ended); },
                py::arg("robot"), py::arg("ended"),
                "Whether a robot, by its index in the scene, and all others of its group() may begin their next stage, if "
                "each robot has ended that many stages. False if it has ended all.")
            .def("__repr__",
                 [](const PassingOrder &self)
                 {
                     return "<PassingOrder: " + std::to_string(self.getStageCount()) + " stages, " +
                            std::to_string(self.getWaits().size()) + " waits, " +
                            std::to_string(self.getMeetings().size()) + " meetings>";
                 });
    }
}
