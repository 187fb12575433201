#ifndef OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_
#define OMPL_CERTIFICATES_VALIDITY_ROBOT_PAIRS_

#include "CheckMethod.h"

#include "certificates/CertificateLimit.h"

#include "ompl_certificates/validity/Method.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief Checks the robots of a team against each other.

        Two discs or spheres are settled by arithmetic. Otherwise one body is the environment of the other, seen from
        its own frame, as in the paper's footnote 2. Bodies of equal shape share that environment and its certificates.
        Bodies of the same robot are not checked against each other. */
    class RobotPairs
    {
    public:
        /** \brief All pairs of robots of \e team, which must outlive this object
            \param limit how many certificates all stores that share it may keep */
        RobotPairs(const Team &team, Method method, std::shared_ptr<CertificateLimit> limit);
        ~RobotPairs();

        /** \brief The number of pairs of robots */
        unsigned int getPairCount() const
        {
            return static_cast<unsigned int>(pairs_.size());
        }

        /** \brief The robot of a pair with the smaller index */
        unsigned int getFirst(unsigned int pair) const
        {
            return pairs_[pair].first;
        }

        /** \brief The other robot of a pair */
        unsigned int getSecond(unsigned int pair) const
        {
            return pairs_[pair].second;
        }

        /** \brief The index of the pair of two robots
            \throws ompl::Exception if both are the same robot, or there is no such robot */
        unsigned int find(unsigned int first, unsigned int second) const;

        /** \brief Settles whether the robots of a pair stay apart. Reads their poses from \e context and counts
            there. */
        PoseVerdict settle(unsigned int pair, CheckContext &context, const MotionSample &sample) const;

        /** \brief How long the robots of a pair stay apart, by their bounding spheres alone; 0 if these touch */
        double provenInterval(unsigned int pair, const CheckContext &context) const;

        /** \brief Whether the robots of a pair touch each other, by FCL */
        bool collide(unsigned int pair, const CheckContext &context) const;

        /** \brief A lower bound of the distance between the robots of a pair, to within the leaves of their sphere
            trees. Negative if they may touch. */
        double distance(unsigned int pair, const CheckContext &context) const;

        /** \brief See TeamValidityChecker::setAdaptive() */
        void setAdaptive(bool adaptive)
        {
            adaptive_ = adaptive;
        }

        /** \brief Removes all certificates. Not while others use the pairs. */
        void clear();

    private:
        /** \brief A body as the environment of others, seen from its own frame */
        struct BodyFrame;

        /** \brief A body of one robot and a body of the other. Indices count the bodies of the whole team. */
        struct BodyPair
        {
            std::size_t firstIndex, secondIndex;
            const Body *first, *second;

            /** \brief The environment: the second body, or the first if \e swapped. Null for two balls. */
            BodyFrame *frame;
            bool swapped;

            /** \brief The possible error of rounding and of FCL when bounding spheres are compared */
            double margin;

            /** \brief The body that is looked up in the frame of the other */
            const Body &lookedUp() const
            {
                return swapped ? *second : *first;
            }

            /** \brief The pose of that body in the frame */
            Pose relativePose(const CheckContext &context) const
            {
                const Pose &a = context.poses[firstIndex], &b = context.poses[secondIndex];
                return swapped ? a.inverse() * b : b.inverse() * a;
            }

            /** \brief The distance between the bounding spheres; negative if they overlap */
            double gap(const CheckContext &context) const;
        };

        struct Pair
        {
            unsigned int first, second;
            std::vector<BodyPair> bodies;
        };

        /** \brief Settles two bodies whose bounding spheres are too close to decide, in the environment's frame */
        PoseVerdict settleBodies(const BodyPair &bodies, CheckContext &context, const MotionSample &sample) const;

        BodyFrame *frameOf(const Body &body, const ZInterval &zInterval);

        const Method method_;
        const std::shared_ptr<CertificateLimit> limit_;
        const unsigned int robotCount_;
        std::vector<Pair> pairs_;
        bool adaptive_{true};
        std::vector<std::unique_ptr<BodyFrame>> frames_;
    };
}

#endif
