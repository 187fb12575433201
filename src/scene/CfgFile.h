#ifndef OMPL_CERTIFICATES_SCENE_CFG_FILE_
#define OMPL_CERTIFICATES_SCENE_CFG_FILE_

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The content of a .cfg file: sections with keys and their values. Whatever is wrong with one is thrown as
        an ompl::Exception of one line that names the file, the section, the key and the value. */
    class CfgFile
    {
    public:
        /** \brief One line of the file */
        struct Entry
        {
            std::string section, key, value;
        };

        /** \brief Read \e file
            \throws ompl::Exception if it cannot be read, or has a line that is neither a section nor a key */
        explicit CfgFile(const std::string &file);

        /** \brief The file */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief All entries, in the order of the file */
        const std::vector<Entry> &getEntries() const
        {
            return entries_;
        }

        /** \brief Complain about a key
            \throws ompl::Exception always */
        [[noreturn]] void fail(const std::string &section, const std::string &key, const std::string &complaint) const;

        /** \brief Require that \e section has no other keys than \e keys, and none twice */
        void allow(const std::string &section, const std::vector<std::string> &keys) const;

        /** \brief Whether \e section has \e key */
        bool has(const std::string &section, const std::string &key) const;

        /** \brief The value of a key that must be there and not be empty */
        std::string text(const std::string &section, const std::string &key) const;

        /** \brief A finite number, of at most a thousand million */
        double number(const std::string &section, const std::string &key) const;

        /** \brief A number above 0 */
        double positive(const std::string &section, const std::string &key) const;

        /** \brief A whole number from 1 to \e most */
        unsigned int count(const std::string &section, const std::string &key, unsigned int most) const;

    private:
        std::string name_;
        std::vector<Entry> entries_;
    };
}

#endif
