#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_MATRIX_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_MATRIX_

#include "YamlNode.h"

#include <map>
#include <string>
#include <utility>

namespace ompl_certificates
{
    /** \brief What an AllowedCollisionMatrix says of links, attached objects and obstacles */
    class MoveItMatrix
    {
    public:
        /** \throws ompl::Exception that names the entry: if there are not as many as names, if one is not true or false,
            or if the matrix is not symmetric */
        explicit MoveItMatrix(const YamlNode &node);

        /** \brief Whether two may touch. What the matrix says of the pair comes first, then the defaults of both: they
            may if no default forbids it. A pair of which it says nothing may not. */
        bool mayTouch(const std::string &first, const std::string &second) const;

        /** \brief Whether one may touch all that the matrix does not name with it, and that has no default */
        bool mayTouchByDefault(const std::string &name) const
        {
            const auto found = defaults_.find(name);
            return found != defaults_.end() && found->second;
        }

    private:
        std::map<std::pair<std::string, std::string>, bool> entries_;
        std::map<std::string, bool> defaults_;
    };
}

#endif
