#ifndef OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_
#define OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_

#include "ompl_certificates/certificates/CertificateLimit.h"
#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/certificates/PoseQuery.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief Checks the robots of a team against each other.

        Two discs or spheres are settled by arithmetic. Of two other bodies, one is the environment of the other, seen from
        its own frame, as in the paper's footnote 2; all bodies of equal shape share that environment and what is known of
        it. Bodies of the same robot are not checked against each other. */
    class RobotPairs
    {
    public:
        /** \brief The pairs of the robots of \e team
            \param limit how many certificates may be kept, together with others; none if null */
        explicit RobotPairs(const TeamStateSpace &team, std::shared_ptr<CertificateLimit> limit = nullptr);

        /** \brief The number of pairs of robots */
        unsigned int getPairCount() const
        {
            return static_cast<unsigned int>(pairs_.size());
        }

        /** \brief The first robot of a pair, which has the smaller index */
        unsigned int getFirst(unsigned int pair) const
        {
            return pairs_[pair].first;
        }

        /** \brief The second robot of a pair */
        unsigned int getSecond(unsigned int pair) const
        {
            return pairs_[pair].second;
        }

        /** \brief Whether the two robots of a pair touch each other, with no use of certificates
            \param first poses of the first robot's bodies
            \param second poses of the second robot's bodies
            \param contactTest whether the contact test may come before FCL */
        bool collide(unsigned int pair, const Pose *first, const Pose *second, bool contactTest,
                     CheckCounts &counts) const;

        /** \brief Like collide(), by clearances and certificates where possible, and for how long the two stay apart
            \param firstBounds how fast the first robot's bodies move
            \param secondBounds how fast the second robot's bodies move
            \param requiredInterval if positive, the two are taken to be apart only if that is proved for this long */
        PoseVerdict settle(unsigned int pair, const Pose *first, const Pose *second, const MotionBound *firstBounds,
                           const MotionBound *secondBounds, double requiredInterval, CheckCounts &counts) const;

        /** \brief For how long the two robots of a pair stay apart, judged by their enclosing balls alone; 0 if those touch */
        double intervalOfEnclosingBalls(unsigned int pair, const Pose *first, const Pose *second,
                                        const MotionBound *firstBounds, const MotionBound *secondBounds) const;

        /** \brief A lower bound of the distance between the two robots of a pair, to within the accuracy of their covers;
            negative if they may touch */
        double distance(unsigned int pair, const Pose *first, const Pose *second) const;

        /** \brief See CertificateChecker::setAdaptive() */
        void setAdaptive(bool adaptive)
        {
            adaptive_ = adaptive;
        }

        /** \brief Forget all certificates. Not while others use the pairs. */
        void clear();

    private:
        /** \brief A body as the environment of others, seen from its own frame */
        struct BodyFrame;

        /** \brief A body of one robot and a body of the other */
        struct BodyPair
        {
            std::size_t firstBody, secondBody;

            /** One body is the environment of the other: the second, or the first if \e swapped is set. Null for two
                balls. */
            bool swapped;
            std::shared_ptr<BodyFrame> frame;

            /** What rounding and FCL may be wrong by when the enclosing balls are compared */
            double margin;
        };

        struct Pair
        {
            unsigned int first, second;
            std::vector<BodyPair> bodies;
        };

        const Body &firstBody(const Pair &pair, const BodyPair &bodies) const;
        const Body &secondBody(const Pair &pair, const BodyPair &bodies) const;
        std::shared_ptr<BodyFrame> frameOf(const Body &body);

        const TeamStateSpace &team_;
        const std::shared_ptr<CertificateLimit> limit_;
        std::vector<Pair> pairs_;
        bool adaptive_{true};
        std::vector<std::shared_ptr<BodyFrame>> frames_;
    };
}

#endif
