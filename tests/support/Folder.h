#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_FOLDER_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_FOLDER_

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdlib.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A folder for the files of one test, removed with it */
        class Folder
        {
        public:
            Folder()
            {
                std::string name = (std::filesystem::temp_directory_path() / "ompl_certificates_XXXXXX").string();
                path_ = mkdtemp(name.data());
            }

            ~Folder()
            {
                std::error_code error;
                std::filesystem::remove_all(path_, error);
            }

            Folder(const Folder &) = delete;
            Folder &operator=(const Folder &) = delete;

            /** \brief The path of this folder */
            std::string path() const
            {
                return path_.string();
            }

            /** \brief The names of the files that are there */
            std::vector<std::string> list() const
            {
                std::vector<std::string> names;
                for (const auto &entry : std::filesystem::directory_iterator(path_))
                    names.push_back(entry.path().filename().string());
                return names;
            }

            /** \brief The path of a file in this folder */
            std::string operator/(const std::string &name) const
            {
                return (path_ / name).string();
            }

            /** \brief Write a file and return its path */
            std::string write(const std::string &name, const std::string &content) const
            {
                std::ofstream(*this / name, std::ios::binary) << content;
                return *this / name;
            }

            /** \brief What is in a file of this folder */
            std::string read(const std::string &name) const
            {
                std::ifstream stream(*this / name, std::ios::binary);
                return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
            }

        private:
            std::filesystem::path path_;
        };
    }
}

#endif
