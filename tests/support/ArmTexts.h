#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_TEXTS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_ARM_TEXTS_

#include <string>

namespace ompl_certificates
{
    namespace test
    {
        inline const std::string SPHERE = "<collision><geometry><sphere radius='0.1'/></geometry></collision>";
        inline const std::string LIMIT = "<limit lower='-1' upper='2' effort='1' velocity='1'/>";

        inline std::string link(const std::string &name, const std::string &content = SPHERE)
        {
            return "<link name='" + name + "'>" + content + "</link>\n";
        }

        inline std::string joint(const std::string &name, const std::string &type, const std::string &parent,
                                 const std::string &child, const std::string &content = "")
        {
            return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
                   child + "'/>" + content + "</joint>\n";
        }

        inline std::string robot(const std::string &content)
        {
            return "<robot name='test'>\n" + content + "</robot>\n";
        }

        /** A base, an arm and a hand, which two joints connect */
        inline std::string chain(const std::string &more = "")
        {
            return robot(
                link("base") + link("arm") + link("hand") +
                joint("first", "revolute", "base", "arm", "<origin xyz='0 0 0.3'/><axis xyz='0 1 0'/>" + LIMIT) +
                joint("second", "continuous", "arm", "hand", "<origin xyz='0 0 0.3'/>") + more);
        }
    }
}

#endif
