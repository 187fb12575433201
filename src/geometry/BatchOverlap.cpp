#include "BatchOverlap.h"

#include "EightNumbers.h"
#include "WideRegisters.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** Pays for the rounding of a few operations in single precision, relative to the numbers that go in */
        constexpr double FLOAT_ROUNDING = 2e-6;

        /** Half the sizes of a box */
        struct Half
        {
            float of[3];

            explicit Half(const Eigen::AlignedBox3d &box)
              : of{static_cast<float>(0.5 * box.sizes()[0]), static_cast<float>(0.5 * box.sizes()[1]),
                   static_cast<float>(0.5 * box.sizes()[2])}
            {
            }
        };

        /** Where the middle of a box is in the frame of another one's middle, and its axes there */
        struct Relative
        {
            EightFloats axes[3][3], middle[3];
        };

        inline void makeAbsolute(EightFloats &numbers)
        {
            numbers = numbers < 0.0F ? -numbers : numbers;
        }

        /** The states in which no face of either box separates the two. Boxes so far apart that the rounding of their
            middles matters are apart anyhow, along another axis. */
        inline BatchMask overlapping(const Half &a, const Half &b, const Relative &relative, double slack)
        {
            const auto extra = static_cast<float>(slack);
            EightFlags apart{};
            for (int i = 0; i < 3; ++i)
            {
                EightFloats distance = relative.middle[i], both = EightFloats{} + (a.of[i] + extra);
                makeAbsolute(distance);
                for (int j = 0; j < 3; ++j)
                {
                    EightFloats part = relative.axes[j][i];
                    makeAbsolute(part);
                    both += part * b.of[j];
                }
                apart |= distance > both;
            }
            for (int j = 0; j < 3; ++j)
            {
                EightFloats distance{}, both = EightFloats{} + (b.of[j] + extra);
                for (int i = 0; i < 3; ++i)
                {
                    EightFloats part = relative.axes[j][i];
                    distance += part * relative.middle[i];
                    makeAbsolute(part);
                    both += part * a.of[i];
                }
                makeAbsolute(distance);
                apart |= distance > both;
            }
            return maskOf(~apart);
        }

        /** How far from the origin of the frame a box reaches */
        double reachOf(const Eigen::AlignedBox3d &box)
        {
            return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm();
        }

        /** What the error of the poses adds to the margin: points are off, and axes are not quite straight */
        double slackOf(const BoxBatch &box)
        {
            return box.error.at(reachOf(box.box)) + 3.0 * box.error.angular * box.box.sizes().norm();
        }
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    double placePoint(const PoseBatch &poses, const Eigen::Vector3d &local, PointBatch &point)
    {
        const auto x = static_cast<float>(local[0]), y = static_cast<float>(local[1]), z = static_cast<float>(local[2]);
        EightFloats farthest{};
        for (int i = 0; i < 3; ++i)
        {
            EightFloats origin = eight(poses.origin[i]);
            eight(point.at[i]) =
                origin + eight(poses.axes[0][i]) * x + eight(poses.axes[1][i]) * y + eight(poses.axes[2][i]) * z;
            makeAbsolute(origin);
            farthest = origin > farthest ? origin : farthest;
        }
        alignas(32) float all[PoseBatch::SIZE];
        eight(all) = farthest;
        return FLOAT_ROUNDING * (static_cast<double>(*std::max_element(all, all + PoseBatch::SIZE)) + local.norm());
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    BatchMask notFinite(const PointBatch &point)
    {
        EightFlags finite = ~EightFlags{};
        for (const auto &numbers : point.at)
            finite &= eight(numbers) - eight(numbers) == 0.0F;
        return maskOf(~finite);
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    BatchMask arePointsNear(const PointBatch &a, const PointBatch &b, double distance)
    {
        EightFloats squared{};
        for (int i = 0; i < 3; ++i)
        {
            const EightFloats difference = eight(a.at[i]) - eight(b.at[i]);
            squared += difference * difference;
        }
        const auto most = static_cast<float>(distance * distance * (1.0 + FLOAT_ROUNDING));
        return maskOf(~(squared > most));
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    BatchMask mayOverlap(const BoxBatch &a, const BoxBatch &b, double margin)
    {
        const Eigen::Vector3d middleA = a.box.center(), middleB = b.box.center();
        EightFloats between[3];
        for (int i = 0; i < 3; ++i)
        {
            between[i] = eight(b.poses.origin[i]) - eight(a.poses.origin[i]);
            for (int j = 0; j < 3; ++j)
                between[i] += eight(b.poses.axes[j][i]) * static_cast<float>(middleB[j]) -
                              eight(a.poses.axes[j][i]) * static_cast<float>(middleA[j]);
        }
        Relative relative{};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
            {
                const EightFloats along = eight(a.poses.axes[i][k]);
                relative.middle[i] += along * between[k];
                for (int j = 0; j < 3; ++j)
                    relative.axes[j][i] += along * eight(b.poses.axes[j][k]);
            }
        const double slack = margin + slackOf(a) + slackOf(b) + FLOAT_ROUNDING * (reachOf(a.box) + reachOf(b.box));
        return overlapping(Half(a.box), Half(b.box), relative, slack);
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    BatchMask mayOverlap(const Eigen::AlignedBox3d &standing, const Pose &toStanding, const BoxBatch &moving,
                         double margin)
    {
        const Eigen::Vector3d local = moving.box.center(), shift = toStanding.translation() - standing.center();
        EightFloats middle[3];
        for (int i = 0; i < 3; ++i)
        {
            middle[i] = eight(moving.poses.origin[i]);
            for (int j = 0; j < 3; ++j)
                middle[i] += eight(moving.poses.axes[j][i]) * static_cast<float>(local[j]);
        }
        Relative relative{};
        for (int i = 0; i < 3; ++i)
        {
            relative.middle[i] += static_cast<float>(shift[i]);
            for (int k = 0; k < 3; ++k)
            {
                const auto along = static_cast<float>(toStanding.linear()(i, k));
                relative.middle[i] += along * middle[k];
                for (int j = 0; j < 3; ++j)
                    relative.axes[j][i] += along * eight(moving.poses.axes[j][k]);
            }
        }
        const double slack =
            margin + slackOf(moving) +
            FLOAT_ROUNDING * (reachOf(standing) + reachOf(moving.box) + toStanding.translation().norm());
        return overlapping(Half(standing), Half(moving.box), relative, slack);
    }
}
