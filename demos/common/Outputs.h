#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_OUTPUTS_
#define OMPL_CERTIFICATES_DEMOS_COMMON_OUTPUTS_

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace demos
{
    /** \brief Whether two names are those of one file; - is standard output, and a device is no file */
    bool isSameFile(const std::string &first, const std::string &second);

    /** \brief Check by trying that all of the files that options name can be written, and that they differ. Empty names
        are left out, and - is standard output: if it is named, all that is printed from now on goes to standard error.
        \param outputs pairs of an option and the file that it names
        \param inputs files that must not be overwritten
        \throws ompl::Exception that names the option and the file */
    void prepareOutputs(const std::vector<std::pair<std::string, std::string>> &outputs,
                        const std::vector<std::string> &inputs);

    /** \brief Write \e text to \e file with writeFile(), or to standard output if it is -
        \throws ompl::Exception that names the file if it cannot be written */
    void writeOutput(const std::string &file, const std::string &text);

    /** \brief Files that are written one after another: one that cannot be written does not keep the others from it. */
    class Outputs
    {
    public:
        /** \brief Write \e file by \e writeFile, unless it has no name */
        template <typename WriteFile>
        void attempt(const std::string &file, const WriteFile &writeFile)
        {
            if (file.empty())
                return;
            try
            {
                writeFile(file);
            }
            catch (const std::exception &exception)
            {
                failures_ += (failures_.empty() ? "" : "; ") + std::string(exception.what());
            }
        }

        /** \brief Tell of all that failed
            \throws ompl::Exception if anything has */
        void finish() const;

    private:
        std::string failures_;
    };
}

#endif
