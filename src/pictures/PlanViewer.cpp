#include "ompl_certificates/pictures/PlanViewer.h"

#include "CertificateChoice.h"
#include "RobotMotion.h"
#include "SceneDrawing.h"
#include "ViewerData.h"
#include "ViewerPage.h"
#include "files/WholeFile.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/team/PathTimes.h"

#include <algorithm>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    using nlohmann::json;

    namespace
    {
        /** How many lines of a tree are shown, of all robots together */
        constexpr std::size_t MAX_SEGMENTS = 24000;

        constexpr std::size_t MAX_VIEWED_CERTIFICATES = 600;

        /** A ball is not shown if its center is that near to the center of a larger one, in radii of that one. */
        constexpr double SAME_PLACE = 0.4;

        /** Where the page has its plan */
        const std::string PLACE = "<script id=\"plan\" type=\"application/json\">";
    }

    PlanViewer::PlanViewer(const Scene &scene) : scene_(scene)
    {
        if (scene_.getMembers().empty())
            return;
        const ob::ScopedState<> start = scene_.makeStart(scene_.makeTeam());
        setStates({start.get()}, {0.0});
    }

    void PlanViewer::setStates(const std::vector<const ob::State *> &states, const std::vector<double> &times)
    {
        motions_ = motionsOf(scene_, states, times);
        end_ = times.back();
    }

    void PlanViewer::setPath(const ompl::geometric::PathGeometric &path)
    {
        setStates(SceneDrawing(scene_).statesOf(path), stateTimes(path));
    }

    void PlanViewer::setPath(const ompl::control::PathControl &path)
    {
        SceneDrawing(scene_).requireTeam(path.getSpaceInformation()->getStateSpace());
        // Between the states that it has, its robots do not move straight: all steps are shown.
        const ompl::control::PathControl steps = pathSteps(path);
        setStates(SceneDrawing(scene_).statesOf(steps), stateTimes(steps));
    }

    void PlanViewer::setTree(const ob::PlannerData &data)
    {
        edges_ = SceneDrawing(scene_).edgesOf(data);
    }

    void PlanViewer::setCertificates(const std::vector<Certificate> &certificates)
    {
        certificates_ = largestApart(certificates, MAX_VIEWED_CERTIFICATES, SAME_PLACE);
    }

    void PlanViewer::setReport(const PlanReport &report)
    {
        report_ = report.toJson();
    }

    std::string PlanViewer::toJson() const
    {
        ViewerData data(scene_);
        json page{{"format", 1},
                  {"name", scene_.getName()},
                  {"dimension", scene_.getDimension()},
                  {"bounds", data.bounds()},
                  {"end", end_},
                  {"obstacles", data.obstacles()},
                  {"cells", data.cells()},
                  {"clouds", data.clouds()},
                  {"robots", json::array()},
                  {"certificates", data.certificates(certificates_)}};
        const std::vector<BodyPoses> goals = SceneDrawing(scene_).getGoals();
        for (std::size_t i = 0; i < motions_.size(); ++i)
        {
            json robot = data.robot(i, *motions_[i], goals[i]);
            if (i < edges_.size())
                robot["tree"] = data.segments(edges_[i], MAX_SEGMENTS / edges_.size());
            page["robots"].push_back(robot);
        }
        page["shapes"] = data.shapes();
        page["report"] = report_.empty() ? json(nullptr) : json::parse(report_);
        // Names come from users: what is not UTF-8 is replaced, not an error at the end of a long run.
        return page.dump(-1, ' ', true, json::error_handler_t::replace);
    }

    std::string PlanViewer::toHtml() const
    {
        std::string html(VIEWER_PAGE, VIEWER_PAGE + VIEWER_PAGE_SIZE);
        std::string plan;
        // No name of a user's ends the element that the plan is in.
        for (const char c : toJson())
            plan += c == '<' ? "\\u003c" : std::string(1, c);
        return html.insert(html.rfind(PLACE) + PLACE.size(), plan);
    }

    void PlanViewer::write(const std::string &file) const
    {
        writeWholeFile(file, toHtml());
    }
}
