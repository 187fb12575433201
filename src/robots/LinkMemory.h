#ifndef OMPL_CERTIFICATES_ROBOTS_LINK_MEMORY_
#define OMPL_CERTIFICATES_ROBOTS_LINK_MEMORY_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/robots/JointCells.h"

#include <list>
#include <mutex>

namespace ompl_certificates
{
    /** \brief The joint cells of pairs of links, shared by all arms that move two links alike. Any number of threads
        may use it at once. */
    class LinkMemory
    {
    public:
        /** \brief Two links, and how they move relative to each other */
        struct Pair
        {
            Body first, second;
            std::vector<JointCells::Coordinate> coordinates;

            /** \brief All other numbers on which the relative pose depends */
            std::vector<double> numbers;
        };

        /** \brief The cells of a pair: new ones if there are none */
        std::shared_ptr<JointCells> getCells(const Pair &pair);

    private:
        /** \brief So many pairs are remembered, those that were asked for last: with grasped objects, new ones come and go.
            A robot of two arms has some 60, one with hands of five fingers some hundred. Of one with more all would be
            forgotten before they are asked for again. */
        static constexpr std::size_t MOST_PAIRS = 512;

        struct Known
        {
            Pair pair;
            std::shared_ptr<JointCells> cells;
        };

        std::mutex mutex_;

        /** \brief The one that was asked for last comes first. */
        std::list<Known> known_;
    };
}

#endif
