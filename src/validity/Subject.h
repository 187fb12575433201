#ifndef OMPL_CERTIFICATES_VALIDITY_SUBJECT_
#define OMPL_CERTIFICATES_VALIDITY_SUBJECT_

namespace ompl_certificates
{
    /** \brief A unit that is proved free on its own: all robots together (Basic) or one robot, among the obstacles; a
        pair of robots; or a robot and itself */
    struct Subject
    {
        enum Kind
        {
            TEAM,
            ROBOT,
            PAIR
        };

        Kind kind;
        /** \brief The robots: the first and the last of a team, or the two of a pair, which are one if it is a robot
            and itself */
        unsigned int first, last;
        /** \brief The number of the pair */
        unsigned int pair;

        /** \brief Calls \e visit for each of the robots */
        template <typename Visit>
        void forEachRobot(const Visit &visit) const
        {
            const unsigned int step = kind == PAIR && first < last ? last - first : 1;
            for (unsigned int robot = first; robot <= last; robot += step)
                visit(robot);
        }
    };

    /** \brief Subjects that stand in a row */
    struct SubjectRange
    {
        const Subject *begin;
        unsigned int count;
    };
}

#endif
