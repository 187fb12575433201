#include "support/Complaint.h"
#include "support/Teams.h"

#include "ompl_certificates/obstacles/CheckObstacles.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** True obstacles, and another's claims about them */
    struct Told : Obstacles
    {
        explicit Told(ObstaclesPtr obstacles) : truth(std::move(obstacles))
        {
        }

        unsigned int getDimension() const override
        {
            return truth->getDimension();
        }

        ZInterval getZInterval() const override
        {
            return truth->getZInterval();
        }

        bool collides(const Body &body, const Pose &pose) const override
        {
            return collision ? collision(body, pose) : truth->collides(body, pose);
        }

        bool knowsPadding() const override
        {
            return paddings;
        }

        double clearance(const Eigen::Vector3d &point) const override
        {
            return factor * truth->clearance(point) + offset;
        }

        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override
        {
            const double limited = factor * truth->clearanceUpTo(point, (most - offset) / factor) + offset;
            return limited + (limited < most - 1e-9 ? nearLimitOffset : beyondLimitOffset);
        }

        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override
        {
            part = partSaid;
            return clearance(point) + nearestOffset;
        }

        Touching touches(const Body &body, const Pose &pose, ObstaclePart * /*hit*/) const override
        {
            return touching ? touching(body, pose) : truth->touches(body, pose);
        }

        bool certainlyHits(const Body & /*body*/, const Pose & /*pose*/, ObstaclePart /*part*/) const override
        {
            return hits;
        }

        double gap(const Body &body, const Pose &pose, double needed, double wanted) const override
        {
            return truth->gap(body, pose, needed, wanted) + gapOffset;
        }

        bool staysFree(const Body & /*body*/, const Pose & /*pose*/, double /*distance*/) const override
        {
            return staysAlways;
        }

        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const override
        {
            return leavesOutAll ? BatchMask{0} : truth->mayTouch(body, poses, error);
        }

        double getTolerance() const override
        {
            return tolerance < 0.0 ? truth->getTolerance() : tolerance;
        }

        bool provesCollisions() const override
        {
            return proves;
        }

        ObstaclesPtr truth;
        double factor{1.0}, offset{0.0}, nearestOffset{0.0}, gapOffset{0.0}, tolerance{-1.0};
        double nearLimitOffset{0.0}, beyondLimitOffset{0.0};
        ObstaclePart partSaid{NO_PART};
        bool hits{false}, proves{true}, paddings{true}, leavesOutAll{false}, staysAlways{false};
        std::function<bool(const Body &, const Pose &)> collision;
        std::function<Touching(const Body &, const Pose &)> touching;
    };

    std::vector<Body> bodiesOf(const TeamStateSpace &team)
    {
        std::vector<Body> bodies;
        for (const auto &robot : team.getRobots())
            bodies.insert(bodies.end(), robot->getBodies().begin(), robot->getBodies().end());
        return bodies;
    }

    class ToldObstacles : public testing::TestWithParam<unsigned int>
    {
    protected:
        ToldObstacles() : team_(anyTeam(GetParam()))
        {
            Random random(3);
            // With an unbounded z-interval, so that discs may be asked about
            const auto made = anyObstacles(random, GetParam(), 10);
            told_ = std::make_unique<Told>(std::make_shared<FclObstacles>(made->getBodies(), made->getDimension()));
        }

        std::string complaint() const
        {
            return complaintOf(
                [&]
                { checkObstacles(*told_, bodiesOf(*team_), cubeBounds(told_->getDimension(), HALF), scaled(300)); });
        }

        void expectComplaint(const std::vector<std::string> &words) const
        {
            expectWords(complaint(), words);
        }

        TeamStateSpacePtr team_;
        std::unique_ptr<Told> told_;
    };
}

TEST_P(ToldObstacles, MustKnowOfPaddings)
{
    told_->paddings = false;
    const std::vector<Body> bodies = bodiesOf(*team_);
    const bool isPadded =
        std::any_of(bodies.begin(), bodies.end(), [](const Body &body) { return body.getPadding() > 0.0; });
    EXPECT_EQ(complaint(), isPadded ? "Obstacles: body 0 is padded, but knowsPadding() is false" : "");
}

TEST_P(ToldObstacles, AreWithoutFaultIfTheyTellTheTruth)
{
    EXPECT_EQ(complaint(), "");
    // The true ones, too, which know parts
    EXPECT_EQ(
        complaintOf(
            [&]
            { checkObstacles(*told_->truth, bodiesOf(*team_), cubeBounds(told_->getDimension(), HALF), scaled(300)); }),
        "");
    // A lower bound is enough if it does not prove collisions.
    told_->factor = 0.5;
    told_->offset = -0.01;
    told_->proves = false;
    EXPECT_EQ(complaint(), "");
}

TEST_P(ToldObstacles, AreFoundToLeaveOutABodyThatMayTouchThem)
{
    told_->leavesOutAll = true;
    expectComplaint({"mayTouch() leaves out", "with poses that are off by less than", "colliding"});
}

TEST_P(ToldObstacles, AreFoundNotToBeLipschitz)
{
    told_->factor = 1.1;
    expectComplaint({"clearance() is not 1-Lipschitz: it is ", " at (", "which differ by "});
}

TEST_P(ToldObstacles, AreFoundToHaveTooSmallATolerance)
{
    told_->offset = 0.001;
    expectComplaint({"collides() finds the ball of radius ", "colliding, where clearance() is ", "tolerance"});
    told_->tolerance = 0.002;
    EXPECT_EQ(complaint(), "");
    told_->tolerance = -1.0;
    told_->offset = -0.001;
    expectComplaint({"collides() finds the ball of radius ", "free, where clearance() is ", "tolerance"});
}

TEST_P(ToldObstacles, AreFoundToNameOtherClearancesAsNearest)
{
    told_->nearestOffset = 1e-3;
    expectComplaint({"findNearest() says ", " at (", "clearance() "});
}

TEST_P(ToldObstacles, AreFoundToGiveOtherClearancesBelowALimit)
{
    told_->nearLimitOffset = 1e-3;
    expectComplaint({"clearanceUpTo() says ", " at (", " with the limit ", "clearance() "});
    told_->nearLimitOffset = 0.0;
    told_->beyondLimitOffset = -1e-3;
    expectComplaint({"clearanceUpTo() says ", " at (", " with the limit ", "clearance() "});
    told_->beyondLimitOffset = 1e-3;
    EXPECT_EQ(complaint(), "");
}

TEST_P(ToldObstacles, AreFoundToContradictThemselvesAboutBodies)
{
    told_->touching = [](const Body &, const Pose &) { return Touching::UNKNOWN; };
    told_->gapOffset = -100.0;
    // Right only about balls
    told_->collision = [this](const Body &body, const Pose &pose)
    { return told_->truth->collides(body, pose) || (!body.isBall() && pose.translation().x() > 2.0); };
    if (GetParam() > 0)
        expectComplaint({"collides() finds body ", "colliding, but clearance() is larger"});
    told_->collision = [this](const Body &body, const Pose &pose)
    { return told_->truth->collides(body, pose) && (body.isBall() || pose.translation().x() > 2.0); };
    if (GetParam() == 1 || GetParam() == 2)
        expectComplaint({"collides() finds body ", "free, but clearance() is "});
}

TEST_P(ToldObstacles, AreFoundToTouchWhatIsFree)
{
    told_->touching = [](const Body &, const Pose &pose)
    { return pose.translation().x() > 3.0 ? Touching::YES : Touching::UNKNOWN; };
    expectComplaint({"touches() says YES of ", "collides() finds free"});
    told_->touching = [](const Body &, const Pose &) { return Touching::NO; };
    expectComplaint({"touches() says NO of ", "collides() finds colliding"});
    told_->touching = nullptr;
    told_->hits = true;
    told_->partSaid = 7;
    expectComplaint({"certainlyHits() says ", "hits part 7", "collides() finds it free"});
}

TEST_P(ToldObstacles, SayThatBodiesStayFreeThatDoNot)
{
    told_->staysAlways = true;
    expectComplaint({"staysFree() says so of body ", "collides() finds it colliding"});
}

TEST_P(ToldObstacles, SayThatBodiesAreFartherThanTheyAre)
{
    if (std::isinf(told_->gap(bodiesOf(*team_).front(), Pose::Identity(), 0.0, 1.0)))
        GTEST_SKIP() << "these obstacles know no gaps";
    told_->gapOffset = 3.0;
    expectComplaint({"gap() is ", "collides() finds it colliding"});
}

INSTANTIATE_TEST_SUITE_P(Kind, ToldObstacles, testing::Range(0U, TEAMS));

TEST(CheckObstacles, KeepsToTheZIntervalThatTheyWereMadeFor)
{
    Random random(3);
    const auto team = planarMeshTeam();
    const auto obstacles = anyObstacles(random, 3, 10);
    EXPECT_EQ(complaintOf([&] { checkObstacles(*obstacles, bodiesOf(*team), cubeBounds(2, HALF), scaled(300)); }), "");
    EXPECT_THROW(checkObstacles(*obstacles, {Body::disc(1.0)}, cubeBounds(2, HALF)), ompl::Exception);
}

TEST(CheckObstacles, RefuseOtherDimensions)
{
    const FclObstacles flat({{Body::disc(1.0)}}, 2), none(std::vector<PlacedBody>{}, 3);
    EXPECT_THROW(checkObstacles(flat, {}, cubeBounds(3, 1.0)), ompl::Exception);
    EXPECT_THROW(checkObstacles(flat, {Body::sphere(1.0)}, cubeBounds(2, 1.0)), ompl::Exception);
    EXPECT_NO_THROW(checkObstacles(none, {Body::sphere(1.0), Body::box(1.0, 1.0, 1.0)}, cubeBounds(3, 1.0)));
}
