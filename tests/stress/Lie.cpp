#include "Lie.h"

#include <iomanip>

namespace ompl_certificates
{
    namespace stress
    {
        namespace
        {
            void write(std::ostream &out, const Shape &shape)
            {
                static const char *const names[] = {"ball", "box", "capsule", "cylinder", "polytope", "mesh"};
                out << names[static_cast<int>(shape.getKind())] << " radius " << shape.getRadius() << " size "
                    << shape.getSize().transpose();
                if (const TriangleMesh *mesh = shape.getMesh())
                {
                    out << ", " << mesh->getTriangles().size() << " triangles";
                    for (std::size_t i = 0; i < mesh->getTriangles().size() && i < 20; ++i)
                        for (const auto &corner : mesh->getCorners(i))
                            out << "; " << corner.transpose();
                }
                else if (shape.getKind() == Shape::Kind::POLYTOPE)
                    for (const auto &corner : shape.getHull()->vertices)
                        out << "; " << corner.transpose();
            }

            void write(std::ostream &out, const Body &body, const Pose &pose)
            {
                for (const auto &part : body.getParts())
                {
                    const Pose placed = pose * part.pose;
                    const Eigen::Quaterniond turn(placed.linear());
                    out << "    ";
                    write(out, part.shape);
                    out << "\n      at " << placed.translation().transpose() << " turned (w x y z) " << turn.w() << ' '
                        << turn.vec().transpose() << '\n';
                }
            }

            template <typename Values>
            void write(std::ostream &out, const char *name, const Values &values)
            {
                out << "  " << name;
                for (const auto &value : values)
                    out << ' ' << value;
                out << '\n';
            }
        }

        void report(std::ostream &out, const Lie &lie, const TeamStateSpacePtr &team, Setting setting)
        {
            out << std::setprecision(17) << "LIE: " << lie.what << '\n';
            for (std::size_t i = 0; i < lie.states.size(); ++i)
            {
                write(out, "state", lie.states[i]);
                write(out, "references", lie.references[i]);
            }
            if (lie.isSeenIn && lie.isSeenIn(Checked(team, setting)))
            {
                for (std::size_t i = setting.obstacles.size(); i-- > 0;)
                {
                    Setting fewer = setting;
                    fewer.obstacles.erase(fewer.obstacles.begin() + static_cast<std::ptrdiff_t>(i));
                    if (lie.isSeenIn(Checked(team, fewer)))
                        setting = fewer;
                }
                out << "  A fresh checker says the same; obstacles that matter:\n";
            }
            else
                out << "  A fresh checker does not say so: it depends on what was known. All obstacles:\n";
            for (const auto &[body, pose] : setting.obstacles)
                write(out, body, pose);
            for (const auto &robot : team->getRobots())
            {
                out << "  robot " << robot->getName() << ", " << robot->getStateSpace()->getDimension()
                    << " coordinates\n";
                for (const Body &body : robot->getBodies())
                    write(out, body, Pose::Identity());
            }
            const Checked checked(team, setting);
            out << "  tolerance " << checked.obstacles->getTolerance() << ", resolution " << setting.resolution
                << (setting.expensive ? ", expensive obstacles" : "") << '\n';
            auto *state = team->allocState();
            for (const auto &reals : lie.states)
            {
                team->copyFromReals(state, reals);
                out << "  FCL: " << (checked.isValid(state) ? "valid" : checked.standard->describeCollision(state))
                    << ", clearance by covering balls " << checked.standard->clearance(state) << '\n';
            }
            team->freeState(state);
        }
    }
}
