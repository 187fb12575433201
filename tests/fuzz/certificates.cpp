// Files of certificates. The first byte says whether to repair the dimension, the fingerprint of the obstacles and the
// checksum before the file is read: the fuzzer would never guess them.
#include "FuzzFile.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/validity/CertificateFile.h"

#include <boost/crc.hpp>
#include <cstdlib>
#include <cstring>

using namespace ompl_certificates;

namespace
{
    TeamSetup makeSetup()
    {
        ompl::base::RealVectorBounds bounds(2);
        bounds.setLow(-3.0);
        bounds.setHigh(3.0);
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::disc("first", 0.2, bounds));
        team->addRobot(RigidRobot::inSE2("second", Body::box(0.5, 0.25), bounds));
        return {team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0)}}, 2U)};
    }

    template <typename T>
    void put(std::string &bytes, std::size_t at, T value)
    {
        std::memcpy(bytes.data() + at, &value, sizeof(value));
    }

    /** See docs/certificate-file.md. */
    void putRight(std::string &bytes, std::uint64_t fingerprint)
    {
        if (bytes.size() < 36)
            return;
        bytes.replace(0, 8, "OMPLCERT");
        put(bytes, 8, std::uint32_t(1));
        put(bytes, 12, std::uint32_t(2));
        put(bytes, 16, fingerprint);
        boost::crc_32_type crc;
        crc.process_bytes(bytes.data(), bytes.size() - 4);
        put(bytes, bytes.size() - 4, static_cast<std::uint32_t>(crc.checksum()));
    }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static TeamSetup setup = makeSetup();
    if (size == 0)
        return 0;
    TeamValidityChecker &checker = *setup.getTeamChecker();
    checker.clear();
    std::string bytes = fuzz::textOf(data + 1, size - 1);
    if (data[0] % 2 == 1)
        putRight(bytes, checker.getObstacles().getFingerprint());
    const std::string file = fuzz::folder().write("certificates", bytes);
    std::size_t loaded = 0;
    fuzz::run([&] { loaded = loadCertificates(checker, file); });
    if (checker.getCertificateCount() > loaded)
        std::abort();  // A refused file leaves nothing.
    fuzz::run(
        [&]
        {
            ompl::base::ScopedState<> state(setup.getStateSpace());
            for (unsigned int i = 0; i < 20; ++i)
            {
                state.random();
                setup.getTeamChecker()->isValid(state.get());
            }
            saveCertificates(checker, fuzz::folder() / "again");
        });
    return 0;
}
