#ifndef OMPL_CERTIFICATES_NEIGHBORS_STATE_KD_TREE_LEAF_
#define OMPL_CERTIFICATES_NEIGHBORS_STATE_KD_TREE_LEAF_

#include "ompl_certificates/neighbors/StateKdTree.h"

#include <Eigen/Core>
#include <vector>

namespace ompl_certificates
{
    /** \brief States that lie close to each other */
    struct StateKdTree::Leaf
    {
        std::vector<Index> indices;
        /** One row for each state */
        Eigen::ArrayXXf columns;
    };
}

#endif
