#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_BATCHES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_BATCHES_

#include "Random.h"

#include "ompl_certificates/geometry/PoseBatch.h"

#include <array>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief The poses that a batch stands for */
        using EightPoses = std::array<Pose, PoseBatch::SIZE>;

        /** \brief A batch of these poses, each of them off by at most \e error, and by the rounding of its numbers */
        inline PoseBatch batchOf(const EightPoses &poses, Random &random, const PoseError &error = {})
        {
            PoseBatch batch;
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            {
                Pose off = poses[k];
                off.translation() += random.uniform(0.0, error.linear) * random.direction(3);
                off.linear() *=
                    Eigen::AngleAxisd(random.uniform(0.0, error.angular), random.direction(3)).toRotationMatrix();
                for (int i = 0; i < 3; ++i)
                {
                    for (int column = 0; column < 3; ++column)
                        batch.axes[column][i][k] = static_cast<float>(off.linear()(i, column));
                    batch.origin[i][k] = static_cast<float>(off.translation()[i]);
                }
            }
            return batch;
        }

        /** \brief The pose of a state in a batch */
        inline Pose poseOf(const PoseBatch &batch, std::size_t state)
        {
            Pose pose = Pose::Identity();
            for (int i = 0; i < 3; ++i)
            {
                for (int column = 0; column < 3; ++column)
                    pose.linear()(i, column) = static_cast<double>(batch.axes[column][i][state]);
                pose.translation()[i] = static_cast<double>(batch.origin[i][state]);
            }
            return pose;
        }
    }
}

#endif
