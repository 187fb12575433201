#ifndef OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_
#define OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_

#include "CheckMethod.h"
#include "TwoBodies.h"

#include "certificates/CertificateLimit.h"

#include "ompl_certificates/validity/Method.h"

#include <memory>
#include <optional>
#include <vector>

namespace ompl_certificates
{
    class BodyFrame;

    /** \brief Checks the robots of a team against each other, and each against itself: the pairs of robots, and one
        pair more for each robot that names pairs of its own bodies.

        Two discs or spheres are settled by arithmetic. Otherwise one body is the environment of the other, seen from
        its own frame, as in the paper's footnote 2. First the gap between their convex covers may prove them apart. In
        discrete mode the contact test and FCL settle the rest: certificates cost more than they saved there. In
        continuous mode certificates do, which bodies of equal shape share. */
    class RobotPairs
    {
    public:
        /** \brief All pairs of \e team, which must outlive this object: the pairs of robots first
            \param limit how many certificates all stores that share it may keep */
        RobotPairs(const Team &team, Method method, std::shared_ptr<CertificateLimit> limit);
        ~RobotPairs();

        /** \brief The number of pairs */
        unsigned int getPairCount() const
        {
            return static_cast<unsigned int>(pairs_.size());
        }

        /** \brief The number of pairs of bodies, in all pairs */
        std::size_t getBodyPairCount() const
        {
            return getFirstBodyPair(getPairCount());
        }

        /** \brief The number of pairs of bodies in all pairs before \e pair: the index of its first one in
            CheckContext::bodyPairTimes */
        std::size_t getFirstBodyPair(unsigned int pair) const
        {
            return firstBodyPairs_[pair];
        }

        /** \brief The robot of a pair with the smaller index */
        unsigned int getFirst(unsigned int pair) const
        {
            return pairs_[pair].first;
        }

        /** \brief The other robot of a pair; the same for a robot and itself */
        unsigned int getSecond(unsigned int pair) const
        {
            return pairs_[pair].second;
        }

        /** \brief The index of the pair of two robots
            \throws ompl::Exception if both are the same robot, or there is no such robot */
        unsigned int find(unsigned int first, unsigned int second) const;

        /** \brief Prepares areFarApart() for a robot whose poses are in \e context. */
        void prepareFarApart(unsigned int robot, CheckContext &context) const
        {
            if (hasSimplePairs_)
                placeSpheres(robot, context);
        }

        /** \brief Whether a pair of robots that has one pair of bodies is apart by its bounding spheres; counts it if
            so. Where most robots are far apart, that settles their pairs soonest. Other pairs are left to settle(). */
        bool areFarApart(unsigned int pair, CheckContext &context) const
        {
            const std::vector<TwoBodies> &all = pairs_[pair].bodies;
            if (all.size() != 1 || !areSpheresApart(all.front(), context))
                return false;
            ++context.counts.pairPoses;
            return true;
        }

        /** \brief Settles whether the robots of a pair stay apart. Reads their poses from \e context and counts
            there. */
        SubjectVerdict settle(unsigned int pair, CheckContext &context, const MotionSample &sample) const;

        /** \brief Notes at which samples of \e context's batch the bodies of a pair are near each other: bounding spheres
            and boxes do not prove them apart. Reads their poses there. */
        void findNear(unsigned int pair, CheckContext &context) const;

        /** \brief Asks the joint cells about bodies that are near each other at a sample of the batch, without their
            poses. Those that they know to be apart are no longer near.
            \return false if two of them touch */
        bool settleNearByCells(std::size_t sample, unsigned int pair, CheckContext &context) const;

        /** \brief Whether the robots of a pair are apart at a sample of the batch, whose poses are in \e context. Only
            bodies that are near each other are checked. */
        bool areApartAt(std::size_t sample, unsigned int pair, CheckContext &context) const;

        /** \brief How long the robots of a pair stay apart after the start of a motion, by their bounding spheres
            alone; 0 if these touch */
        double provenInterval(unsigned int pair, CheckContext &context) const;

        /** \brief Two bodies of a pair that touch each other, by FCL: the first of the first robot, the second of the
            second. None if the robots stay apart. */
        std::optional<BodyPair> findCollision(unsigned int pair, const CheckContext &context) const;

        /** \brief A lower bound of the distance between the robots of a pair, to within the leaves of their sphere
            trees. Negative if they may touch. */
        double distance(unsigned int pair, const CheckContext &context) const;

        /** \brief Whether the robots of a pair are known to be farther from each other than \e distance. Cost: less
            than that of distance(). */
        bool areFarther(unsigned int pair, double distance, const CheckContext &context) const;

        /** \brief Removes all certificates. Not while others use the pairs. */
        void clear();

    private:
        struct Pair
        {
            unsigned int first, second;
            std::vector<TwoBodies> bodies;
        };

        /** \brief So many large joint cells are settled while a checker is made, at most, which takes some ten
            milliseconds. */
        static constexpr std::size_t MOST_LARGE_CELLS = 1U << 14;

        /** \brief Settles the joint cells of the first two levels, so that the first plan need not. */
        void settleLargeCells(const Team &team) const;

        /** \brief Whether it pays to know how long two bodies stay apart */
        bool searchesGaps(const MotionSample &sample) const
        {
            return makesCertificates(method_) && sample.samplesAhead > 0.0 && sample.requiredInterval == 0.0;
        }

        /** \brief Puts the centers of the bounding spheres of a robot's bodies into the context */
        static void placeSpheres(unsigned int robot, CheckContext &context);

        /** \brief Whether these bounding spheres prove two bodies apart */
        static bool areSpheresApart(const TwoBodies &bodies, const CheckContext &context)
        {
            const Eigen::Vector3d &a = context.sphereCenters[bodies.firstIndex],
                                  &b = context.sphereCenters[bodies.secondIndex];
            return (a - b).squaredNorm() > bodies.farthest * bodies.farthest;
        }

        /** \brief Settles two bodies; \e number is that of their pair in the whole team */
        SubjectVerdict settleTwo(const TwoBodies &bodies, std::size_t number, CheckContext &context,
                                 const MotionSample &sample) const;

        /** \brief Calls \e isApart for the bodies of a pair that are near each other at a sample of the batch, with their
            number in the whole team, until it returns false
            \return whether it did not */
        template <typename IsApart>
        bool areNearApart(std::size_t sample, unsigned int pair, CheckContext &context, const IsApart &isApart) const;

        /** \brief Settles two bodies by their joint cells, if these have an answer
            \param verdict what their bounding spheres say; takes the times at which the cells know them apart
            \return whether the verdict stands */
        bool settleByCells(const JointCellCheck &cells, std::size_t number, CheckContext &context,
                           const MotionSample &sample, SubjectVerdict &verdict) const;

        /** \brief Settles two bodies in the environment's frame, where their bounding spheres do not decide */
        PoseVerdict settleBodies(const TwoBodies &bodies, std::size_t number, CheckContext &context,
                                 const MotionSample &sample) const;

        /** \brief Whether two bodies collide: by the contact test unless the method is FCL, then by FCL if needed */
        bool collides(const TwoBodies &bodies, const Pose &relative, CheckCounts &counts) const;

        /** \brief Tries to settle two bodies by the gap between their convex covers
            \param stretch how much of the motion the gap is to prove, if it can
            \param direction where their planes were last; updated */
        PoseVerdict settleByGap(const TwoBodies &bodies, const Pose &relative, const MotionBound &bound, double stretch,
                                Eigen::Vector3d &direction) const;

        /** \brief Body \e a of robot \e first and body \e b of robot \e second */
        TwoBodies makeTwoBodies(const Team &team, unsigned int first, std::size_t a, unsigned int second,
                                std::size_t b);

        BodyFrame *frameOf(const Body &body, const ZInterval &zInterval);

        /** \brief A body with another padding, which lives as long as this object */
        const Body &paddedBody(const Body &body, double padding);

        const Method method_;
        const std::shared_ptr<CertificateLimit> limit_;
        const unsigned int robotCount_;
        std::vector<Pair> pairs_;
        std::vector<std::size_t> firstBodyPairs_{0};
        /** \brief Whether some pair of robots has one pair of bodies */
        bool hasSimplePairs_{false};
        std::vector<std::unique_ptr<BodyFrame>> frames_;
        std::vector<std::unique_ptr<const Body>> paddedBodies_;
    };
}

#endif
