#ifndef OMPL_CERTIFICATES_TEAM_STATE_KD_TREE_LEAF_
#define OMPL_CERTIFICATES_TEAM_STATE_KD_TREE_LEAF_

#include "ompl_certificates/team/StateKdTree.h"

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
