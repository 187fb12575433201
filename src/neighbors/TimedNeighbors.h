#ifndef OMPL_CERTIFICATES_NEIGHBORS_TIMED_NEIGHBORS_
#define OMPL_CERTIFICATES_NEIGHBORS_TIMED_NEIGHBORS_

#include "ompl_certificates/neighbors/PlannerNeighbors.h"

#include <ompl/datastructures/NearestNeighbors.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief Forwards to another structure, and measures its time. */
    template <typename T>
    class TimedNeighbors : public ompl::NearestNeighbors<T>
    {
    public:
        using typename ompl::NearestNeighbors<T>::DistanceFunction;

        TimedNeighbors(std::shared_ptr<ompl::NearestNeighbors<T>> timed, std::shared_ptr<NearestClock> clock)
          : timed_(std::move(timed)), clock_(std::move(clock))
        {
            ompl::NearestNeighbors<T>::setDistanceFunction(timed_->getDistanceFunction());
        }

        void setDistanceFunction(const DistanceFunction &distance) override
        {
            ompl::NearestNeighbors<T>::setDistanceFunction(distance);
            timed_->setDistanceFunction(distance);
        }

        bool reportsSortedResults() const override
        {
            return timed_->reportsSortedResults();
        }

        void clear() override
        {
            const Timer timer(*clock_);
            timed_->clear();
        }

        void add(const T &data) override
        {
            const Timer timer(*clock_);
            timed_->add(data);
        }

        void add(const std::vector<T> &data) override
        {
            const Timer timer(*clock_);
            timed_->add(data);
        }

        bool remove(const T &data) override
        {
            const Timer timer(*clock_);
            return timed_->remove(data);
        }

        T nearest(const T &data) const override
        {
            const Timer timer(*clock_);
            return timed_->nearest(data);
        }

        void nearestK(const T &data, std::size_t k, std::vector<T> &nbh) const override
        {
            const Timer timer(*clock_);
            timed_->nearestK(data, k, nbh);
        }

        void nearestR(const T &data, double radius, std::vector<T> &nbh) const override
        {
            const Timer timer(*clock_);
            timed_->nearestR(data, radius, nbh);
        }

        std::size_t size() const override
        {
            return timed_->size();
        }

        void list(std::vector<T> &data) const override
        {
            const Timer timer(*clock_);
            timed_->list(data);
        }

    private:
        struct Timer
        {
            explicit Timer(NearestClock &clock) : clock_(clock), start_(std::chrono::steady_clock::now())
            {
            }

            ~Timer()
            {
                clock_.addSince(start_);
            }

            Timer(const Timer &) = delete;
            Timer &operator=(const Timer &) = delete;

            NearestClock &clock_;
            std::chrono::steady_clock::time_point start_;
        };

        std::shared_ptr<ompl::NearestNeighbors<T>> timed_;
        std::shared_ptr<NearestClock> clock_;
    };
}

#endif
