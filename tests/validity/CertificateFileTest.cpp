#include "ompl_certificates/validity/CertificateFile.h"
#include "support/Checkers.h"
#include "support/Folder.h"
#include "support/RandomMeshes.h"

#include <boost/crc.hpp>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <set>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class CertificateFile : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        }

        /** A checker with certificates */
        std::shared_ptr<TeamSetup> makeExperienced(const ObstaclesPtr &obstacles, Method method)
        {
            auto setup = makeFresh(obstacles, method);
            Random random(3);
            for (int i = 0; i < 200; ++i)
                setup->getTeamChecker()->isValid(randomState(random, team_).get());
            return setup;
        }

        std::shared_ptr<TeamSetup> makeFresh(const ObstaclesPtr &obstacles, Method method) const
        {
            auto setup = std::make_shared<TeamSetup>(team_, obstacles, method);
            setup->getTeamChecker()->setCertificatesAfter(0);
            return setup;
        }

        ObstaclesPtr makeObstacles(unsigned int seed = 1) const
        {
            Random random(seed);
            return scatteredObstacles(random, team_->getWorkspaceDimension(), 10);
        }

        /** Expects a refusal that names the file and contains \e reason, and that nothing was loaded. */
        void expectRefused(const ObstaclesPtr &obstacles, const std::string &file, const std::string &reason,
                           Method method = Method::SHARED_PROJECTION) const
        {
            const auto setup = makeFresh(obstacles, method);
            try
            {
                loadCertificates(*setup->getTeamChecker(), file);
                ADD_FAILURE() << "not refused, though " << reason;
            }
            catch (const ompl::Exception &exception)
            {
                const std::string told = exception.what();
                EXPECT_EQ(told.compare(0, file.size(), file), 0) << told;
                EXPECT_NE(told.find(reason), std::string::npos) << told;
            }
            EXPECT_EQ(setup->getTeamChecker()->getCertificateCount(), 0U);
        }

        const TeamStateSpacePtr team_ = anyTeam(HasParam() ? GetParam() : 0);
        const Folder folder_;
        const std::string file_ = folder_ / "certificates";

    private:
        static bool HasParam()
        {
            return testing::UnitTest::GetInstance()->current_test_info()->value_param() != nullptr;
        }
    };
}

TEST_P(CertificateFile, GivesBackWhatWasSaved)
{
    const auto obstacles = makeObstacles();
    const auto experienced = makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker();
    ASSERT_GT(experienced->getCertificateCount(), 20U);
    saveCertificates(*experienced, file_);
    // The same obstacles, made again in another order
    std::vector<PlacedBody> bodies = static_cast<const FclObstacles &>(*obstacles).getBodies();
    std::reverse(bodies.begin(), bodies.end());
    const auto again = std::make_shared<ExpensiveObstacles>(bodies, team_->getWorkspaceDimension());
    for (const Method method : {Method::SHARED_PROJECTION, Method::PARTIAL})
    {
        const auto checker = makeFresh(again, method)->getTeamChecker();
        EXPECT_EQ(loadCertificates(*checker, file_), experienced->getCertificateCount());
        const auto loaded = checker->getCertificates();
        const auto saved = experienced->getCertificates();
        for (std::size_t i = 0; i < loaded.size(); ++i)
            ASSERT_EQ(loaded[i], saved[i % saved.size()]);
    }
}

TEST_P(CertificateFile, SavesChecksAndChangesNoVerdict)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    const auto cold = makeFresh(obstacles, Method::SHARED_PROJECTION);
    const auto warm = makeFresh(obstacles, Method::SHARED_PROJECTION);
    loadCertificates(*warm->getTeamChecker(), file_);
    const auto standard = makeFresh(obstacles, Method::STANDARD);
    Random random(4);
    for (int i = 0; i < 100; ++i)
    {
        const ob::ScopedState<> state = randomState(random, team_), copy = state;
        ASSERT_EQ(warm->getTeamChecker()->isValid(state.get()), standard->getTeamChecker()->isValid(state.get()));
        cold->getTeamChecker()->isValid(copy.get());
    }
    EXPECT_LT(warm->getStatistics().getCounts().asked, cold->getStatistics().getCounts().asked);
}

TEST_P(CertificateFile, IsUsedAtOnce)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    TeamSetup setup(team_, obstacles, Method::SHARED_PROJECTION);
    const TeamValidityChecker &checker = *setup.getTeamChecker();
    Random random(4);
    for (int i = 0; i < 20; ++i)
        checker.isValid(randomState(random, team_).get());
    ASSERT_EQ(setup.getStatistics().getCounts().certifiedFree, 0U);
    loadCertificates(*setup.getTeamChecker(), file_);
    for (int i = 0; i < 20; ++i)
        checker.isValid(randomState(random, team_).get());
    EXPECT_GT(setup.getStatistics().getCounts().certifiedFree, 0U);
}

TEST_P(CertificateFile, KeepsItsSizeWhereNothingIsLearned)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::PARTIAL)->getTeamChecker(), file_);
    std::set<std::size_t> sizes;
    for (int run = 0; run < 3; ++run)
    {
        const auto checker = makeFresh(obstacles, Method::PARTIAL)->getTeamChecker();
        sizes.insert(loadCertificates(*checker, file_));
        EXPECT_EQ(checker->getCertificateCount(), *sizes.begin() * team_->getRobotCount());
        saveCertificates(*checker, file_);
    }
    EXPECT_EQ(sizes.size(), 1U);
}

/** As who loads it before each plan does */
TEST_P(CertificateFile, MayBeLoadedTwice)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    for (const Method method : {Method::SHARED_PROJECTION, Method::PARTIAL})
    {
        const auto checker = makeFresh(obstacles, method)->getTeamChecker();
        loadCertificates(*checker, file_);
        const std::size_t count = checker->getCertificateCount();
        loadCertificates(*checker, file_);
        EXPECT_EQ(checker->getCertificateCount(), count);
    }
}

TEST_P(CertificateFile, SharesALimitAmongRobots)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    const auto checker = makeFresh(obstacles, Method::PARTIAL)->getTeamChecker();
    checker->setMaxCertificates(5 * team_->getRobotCount());
    loadCertificates(*checker, file_);
    const std::vector<Certificate> kept = checker->getCertificates();
    ASSERT_EQ(kept.size(), 5U * team_->getRobotCount());
    for (std::size_t i = 0; i < kept.size(); ++i)
        EXPECT_EQ(kept[i], kept[i % 5]);
}

INSTANTIATE_TEST_SUITE_P(Teams, CertificateFile, testing::Range(0U, 3U));

TEST_F(CertificateFile, IsRefusedForOtherObstacles)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    expectRefused(makeObstacles(2), file_, "other obstacles");
    std::vector<PlacedBody> bodies = static_cast<const FclObstacles &>(*obstacles).getBodies();
    bodies[3].pose.translation().x() += 1e-12;
    expectRefused(std::make_shared<FclObstacles>(bodies, 2U), file_, "other obstacles");
    bodies.erase(bodies.begin() + 3);
    expectRefused(std::make_shared<FclObstacles>(bodies, 2U), file_, "other obstacles");
    expectRefused(obstacles, file_, "basic", Method::BASIC);
}

TEST_F(CertificateFile, TellsMeshesAndTheirHeightsApart)
{
    Random random(1);
    const TriangleMeshPtr mesh = boxMesh({1.0, 2.0, 3.0}), other = boxMesh({1.0, 2.0, 3.0 + 1e-9});
    const auto fingerprint = [](const TriangleMeshPtr &of, const ZInterval &zInterval)
    { return FclObstacles({{Body::planarMesh(of)}}, 2U, zInterval).getFingerprint(); };
    EXPECT_EQ(fingerprint(mesh, {}), fingerprint(boxMesh({1.0, 2.0, 3.0}), {}));
    EXPECT_NE(fingerprint(mesh, {}), fingerprint(other, {}));
    EXPECT_NE(fingerprint(mesh, {}), fingerprint(mesh, {0.0, 1.0}));
    EXPECT_NE(fingerprint(mesh, {0.0, 2.0}), fingerprint(mesh, {0.0, 1.0}));
}

/** All that makes a shape another one makes the file one of other obstacles. */
TEST_F(CertificateFile, TellsShapesApart)
{
    const std::vector<Eigen::Vector3d> corners{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    const auto open = [&](const std::vector<TriangleMesh::Triangle> &triangles)
    { return Body::mesh(std::make_shared<TriangleMesh>(corners, triangles)); };
    std::vector<Eigen::Vector3d> moved = corners;
    moved[1].x() += 1e-9;
    std::set<std::uint64_t> fingerprints;
    const std::vector<Body> bodies{Body::sphere(1.0),
                                   Body::sphere(1.0 + 1e-9),
                                   Body::capsule(1.0, 1.0),
                                   Body::capsule(1.0 + 1e-9, 1.0),
                                   Body::capsule(1.0, 1.0 + 1e-9),
                                   Body::cylinder(1.0, 1.0),
                                   Body::cylinder(1.0 + 1e-9, 1.0),
                                   Body::cylinder(1.0, 1.0 + 1e-9),
                                   Body::box(1.0, 1.0, 1.0),
                                   Body::box(1.0, 1.0 + 1e-9, 1.0),
                                   Body::convexHull(corners),
                                   Body::convexHull(moved),
                                   open({{0, 1, 2}, {0, 1, 3}}),
                                   open({{0, 1, 2}, {0, 2, 3}})};
    for (const Body &body : bodies)
        fingerprints.insert(FclObstacles({{body}}, 3).getFingerprint());
    EXPECT_EQ(fingerprints.size(), bodies.size());
    EXPECT_NE(FclObstacles({{Body::disc(1.0)}}, 2).getFingerprint(),
              FclObstacles({{Body::disc(1.0 + 1e-9)}}, 2).getFingerprint());
}

/** Numbers that are none would certify anything, so a right checksum does not make them good. */
TEST_F(CertificateFile, IsRefusedForNumbersThatAreNone)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    const std::string bytes = folder_.read("certificates");
    const auto withNumber = [&](std::size_t at, double number)
    {
        std::string changed = bytes;
        std::memcpy(&changed[at], &number, sizeof(number));
        boost::crc_32_type crc;
        crc.process_bytes(changed.data(), changed.size() - 4);
        const std::uint32_t checksum = crc.checksum();
        std::memcpy(&changed[changed.size() - 4], &checksum, sizeof(checksum));
        return folder_.write("changed", changed);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // The first certificate: its point, and its clearance
    constexpr std::size_t point = 32, clearance = 48;
    for (const std::size_t at : {point, point + 8, clearance})
        for (const double number : {std::nan(""), -infinity})
            expectRefused(obstacles, withNumber(at, number), "not a number");
    expectRefused(obstacles, withNumber(point, infinity), "not a number");
    EXPECT_GT(loadCertificates(*makeFresh(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(),
                               withNumber(clearance, 0.5)),
              0U);
}

TEST_F(CertificateFile, IsRefusedWhereverItIsCutOrDamaged)
{
    const auto obstacles = makeObstacles();
    saveCertificates(*makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker(), file_);
    const std::string bytes = folder_.read("certificates");
    ASSERT_GT(bytes.size(), 500U);
    for (std::size_t length = 0; length < bytes.size(); length += length < 60 ? 1 : 97)
        expectRefused(obstacles, folder_.write("cut", bytes.substr(0, length)), "is ");
    for (std::size_t at = 0; at < bytes.size(); at += at < 60 ? 1 : 97)
        for (const int bit : {0, 7})
        {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            expectRefused(obstacles, folder_.write("damaged", damaged), "");
        }
    expectRefused(obstacles, folder_.write("longer", bytes + "x"), "damaged");
    std::string newer = bytes;
    newer[8] = 2;
    expectRefused(obstacles, folder_.write("newer", newer),
                  "has version 2 of the format; this program reads version 1");
    // A count that would take exabytes
    std::string huge = bytes;
    huge.replace(24, 8, 8, '\x7f');
    expectRefused(obstacles, folder_.write("huge", huge), "cut short");
    expectRefused(obstacles, folder_ / "absent", "cannot be read");
}

TEST_F(CertificateFile, StaysAsItWasWhereItCannotBeWritten)
{
    const auto obstacles = makeObstacles();
    const auto checker = makeExperienced(obstacles, Method::SHARED_PROJECTION)->getTeamChecker();
    EXPECT_THROW(saveCertificates(*checker, "/dev/full"), ompl::Exception);
    EXPECT_THROW(saveCertificates(*checker, folder_ / "absent/file"), ompl::Exception);
}

namespace
{
    /** Obstacles without a fingerprint */
    class Nameless : public ExpensiveObstacles
    {
    public:
        using ExpensiveObstacles::ExpensiveObstacles;

        std::uint64_t getFingerprint() const override
        {
            return 0;
        }
    };
}

TEST_F(CertificateFile, NeedsObstaclesThatCanBeRecognized)
{
    const auto setup = makeFresh(std::make_shared<Nameless>(std::vector<PlacedBody>(), 2U), Method::PARTIAL);
    EXPECT_THROW(saveCertificates(*setup->getTeamChecker(), file_), ompl::Exception);
    EXPECT_THROW(loadCertificates(*setup->getTeamChecker(), file_), ompl::Exception);
}
