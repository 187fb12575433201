// Checks states of a file one after the other, as a C++ program does, and prints the seconds and how many are valid:
//
//     check_states scene.yaml states.bin
//
// The file has the doubles of all states, one state after the other. batch.py compares with a batch from Python.

#include <ompl_certificates/scene/SceneFile.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>
#include <vector>

using namespace ompl_certificates;

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    std::vector<double> values;
    std::ifstream file(argv[2], std::ios::binary);
    for (double value = 0.0; file.read(reinterpret_cast<char *>(&value), sizeof(value));)
        values.push_back(value);

    const TeamSetupPtr setup = loadScene(argv[1]).makeSetup();
    const auto &space = setup->getStateSpace();
    setup->getSpaceInformation()->setup();
    ompl::base::ScopedState<> state(space);
    const std::size_t count = space->getValueLocations().size();
    const TeamValidityChecker &checker = *setup->getTeamChecker();

    const auto begin = std::chrono::steady_clock::now();
    std::vector<double> row(count);
    std::size_t valid = 0;
    for (auto at = values.begin(); at != values.end(); at += static_cast<std::ptrdiff_t>(count))
    {
        row.assign(at, at + static_cast<std::ptrdiff_t>(count));
        space->copyFromReals(state.get(), row);
        valid += checker.isValid(state.get()) ? 1 : 0;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::printf("%.6f %zu\n", seconds, valid);
    return 0;
}
