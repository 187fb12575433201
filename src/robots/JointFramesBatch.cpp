#include "JointFrames.h"

#include "geometry/EightNumbers.h"
#include "geometry/WideRegisters.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t SIZE = PoseBatch::SIZE;

        /** The rounding of one joint: of its sine and cosine, and of the products of rotations. If all of it adds up,
            it is 1.6e-6: some 26 times half the resolution of single precision. */
        constexpr double JOINT_ROUNDING = 2e-6;

        /** Angles beyond are taken for no number. */
        constexpr double LARGEST_ANGLE = 1e6;

        /** The sines and cosines of eight angles, to within 2e-7: by the polynomials of Cephes for an eighth of a turn
            on either side of the nearest quarter */
        inline void turnBy(const double *values, double multiplier, double offset, EightFloats &sine,
                           EightFloats &cosine)
        {
            constexpr double half = boost::math::constants::half_pi<double>();
            alignas(32) float rests[SIZE];
            alignas(32) int quarters[SIZE];
            for (std::size_t k = 0; k < SIZE; ++k)
            {
                const double angle = multiplier * values[k] + offset;
                const bool fits = std::abs(angle) < LARGEST_ANGLE;
                const double quarter = std::floor((fits ? angle : 0.0) / half + 0.5);
                rests[k] = fits ? static_cast<float>(angle - quarter * half) : std::numeric_limits<float>::quiet_NaN();
                quarters[k] = static_cast<int>(quarter);
            }
            const EightFloats rest = eight(rests), squared = rest * rest;
            const EightFloats s =
                rest +
                rest * squared * (-1.6666654611e-1F + squared * (8.3321608736e-3F + squared * -1.9515295891e-4F));
            const EightFloats c =
                1.0F - 0.5F * squared +
                squared * squared *
                    (4.166664568298827e-2F + squared * (-1.388731625493765e-3F + squared * 2.443315711809948e-5F));
            const EightFlags quarter = *reinterpret_cast<const EightFlags *>(quarters);
            const EightFlags odd = (quarter & 1) != 0;
            sine = odd ? c : s;
            cosine = odd ? s : c;
            sine = (quarter & 2) != 0 ? -sine : sine;
            cosine = ((quarter + 1) & 2) != 0 ? -cosine : cosine;
        }

        /** Where a fixed pose in the frames \e parent is */
        inline void place(const PoseBatch &parent, const Pose &pose, bool isParallel, PoseBatch &result)
        {
            for (int i = 0; i < 3; ++i)
            {
                const EightFloats x = eight(parent.axes[0][i]), y = eight(parent.axes[1][i]),
                                  z = eight(parent.axes[2][i]);
                const auto along = [&](const auto &local, float *numbers)
                {
                    eight(numbers) = x * static_cast<float>(local[0]) + y * static_cast<float>(local[1]) +
                                     z * static_cast<float>(local[2]);
                };
                along(pose.translation(), result.origin[i]);
                eight(result.origin[i]) += eight(parent.origin[i]);
                for (int column = 0; column < 3; ++column)
                    if (isParallel)
                        eight(result.axes[column][i]) = eight(parent.axes[column][i]);
                    else
                        along(pose.linear().col(column), result.axes[column][i]);
            }
        }

        /** Shifts the frames along one of their axes
            \return how far, at most */
        inline double shiftAlong(const double *values, double multiplier, double offset, int axis, PoseBatch &frame)
        {
            alignas(32) float shifts[SIZE];
            double most = 0.0;
            for (std::size_t k = 0; k < SIZE; ++k)
            {
                const double shift = multiplier * values[k] + offset;
                most = std::max(most, std::abs(shift));
                // Not a number if it is infinite: no comparison may find that far from everything.
                shifts[k] = static_cast<float>(shift + 0.0 * shift);
            }
            for (int i = 0; i < 3; ++i)
                eight(frame.origin[i]) += eight(shifts) * eight(frame.axes[axis][i]);
            return most;
        }

        /** Turns the frames by quaternions: x, y, z and w */
        void turnByQuaternions(const double *values, PoseBatch &frame)
        {
            for (std::size_t k = 0; k < SIZE; ++k)
            {
                Eigen::Matrix3d axes;
                for (int column = 0; column < 3; ++column)
                    for (int i = 0; i < 3; ++i)
                        axes(i, column) = static_cast<double>(frame.axes[column][i][k]);
                axes *= Eigen::Quaterniond(values[3 * SIZE + k], values[k], values[SIZE + k], values[2 * SIZE + k])
                            .normalized()
                            .toRotationMatrix();
                for (int column = 0; column < 3; ++column)
                    for (int i = 0; i < 3; ++i)
                        frame.axes[column][i][k] = static_cast<float>(axes(i, column));
            }
        }
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    double JointFrames::computeBatch(const double *coordinates, PoseBatch *frames) const
    {
        for (int i = 0; i < 3; ++i)
        {
            for (int column = 0; column < 3; ++column)
                eight(frames[0].axes[column][i]) = EightFloats{} + (i == column ? 1.0F : 0.0F);
            eight(frames[0].origin[i]) = EightFloats{};
        }
        double shifted = 0.0;
        PoseBatch *frame = frames;
        for (const Mover &mover : movers_)
        {
            place(frames[mover.parent], mover.fixed, false, *++frame);
            const double *values = coordinates + mover.coordinate * SIZE;
            switch (mover.kind)
            {
                case Kind::REVOLUTE:
                {
                    EightFloats s, c;
                    turnBy(values, mover.multiplier, mover.offset, s, c);
                    for (int i = 0; i < 3; ++i)
                    {
                        const EightFloats x = eight(frame->axes[0][i]), y = eight(frame->axes[1][i]);
                        eight(frame->axes[0][i]) = c * x + s * y;
                        eight(frame->axes[1][i]) = c * y - s * x;
                    }
                    break;
                }
                case Kind::PRISMATIC:
                    shifted += shiftAlong(values, mover.multiplier, mover.offset, 2, *frame);
                    break;
                case Kind::SHIFT:
                    for (unsigned int axis = 0; axis < mover.dimension; ++axis)
                        shifted += shiftAlong(values + axis * SIZE, 1.0, 0.0, static_cast<int>(axis), *frame);
                    break;
                case Kind::TURN:
                    turnByQuaternions(values, *frame);
                    break;
            }
        }
        return shifted;
    }

    OMPL_CERTIFICATES_WIDE_WHOLE
    void JointFrames::locateBatch(const std::vector<Place> &places, const PoseBatch *frames, PoseBatch *poses)
    {
        for (const Place &place : places)
            ompl_certificates::place(frames[place.frame], place.pose, place.isParallel, *poses++);
    }

    PoseError JointFrames::errorOf(const std::vector<Place> &places) const
    {
        // How far the origin of each frame can be from that of the workspace, without what coordinates shift, and how
        // many joints there are between
        std::vector<PoseError> frames(getFrameCount());
        PoseError most;
        const auto next = [](const PoseError &parent, const Pose &fixed) {
            return PoseError{parent.linear + fixed.translation().norm(), parent.angular + 1.0};
        };
        for (std::size_t i = 0; i < movers_.size(); ++i)
            frames[i + 1] = next(frames[movers_[i].parent], movers_[i].fixed);
        for (const Place &place : places)
        {
            const PoseError one = next(frames[place.frame], place.pose);
            most = {std::max(most.linear, one.linear), std::max(most.angular, one.angular)};
        }
        most.angular = JOINT_ROUNDING * (most.angular + 1.0);
        most.linear *= most.angular;
        return most;
    }
}
