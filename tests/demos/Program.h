#ifndef OMPL_CERTIFICATES_TESTS_DEMOS_PROGRAM_
#define OMPL_CERTIFICATES_TESTS_DEMOS_PROGRAM_

#include "support/Folder.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using ompl_certificates::test::Folder;

/** \brief The folder with the scenes of the demos */
inline const std::string SCENES = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/";

inline std::string contentOf(const std::string &file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/** \brief One of the demos, as a child process */
class Program
{
public:
    /** \brief Start the program; its output is kept for output() and errors() */
    Program(const std::string &name, const std::vector<std::string> &arguments)
    {
        const std::string path = OMPL_CERTIFICATES_BIN_DIR "/" + name;
        std::vector<char *> argv{const_cast<char *>(path.c_str())};
        for (const std::string &argument : arguments)
            argv.push_back(const_cast<char *>(argument.c_str()));
        argv.push_back(nullptr);
        const std::string output = folder_ / "output", errors = folder_ / "errors";
        child_ = fork();
        if (child_ == 0)
        {
            if (!std::freopen(output.c_str(), "w", stdout) || !std::freopen(errors.c_str(), "w", stderr) ||
                chdir(std::filesystem::path(output).parent_path().c_str()) != 0)
                _exit(126);
            execv(path.c_str(), argv.data());
            _exit(127);
        }
    }

    ~Program()
    {
        if (child_ > 0)
        {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
    }

    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    /** \brief Send it a signal */
    void signal(int number) const
    {
        kill(child_, number);
    }

    /** \brief Wait until it ends, and return its exit code, or minus the signal that killed it */
    int wait()
    {
        int status = 0;
        waitpid(child_, &status, 0);
        child_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

    /** \brief What it wrote to standard output so far */
    std::string output() const
    {
        return contentOf(folder_ / "output");
    }

    /** \brief What it wrote to standard error so far */
    std::string errors() const
    {
        return contentOf(folder_ / "errors");
    }

private:
    Folder folder_;
    pid_t child_{0};
};

/** \brief A scene of two discs and a box that is solved at once */
inline const char *easyScene()
{
    return R"(environment:
  min: [0, 0]
  max: [10, 10]
  obstacles:
    - {type: box, center: [5, 5], size: [1, 6]}
robots:
  - {type: unicycle_first_order_0_sphere, start: [1, 5, 0], goal: [9, 5, 0]}
  - {type: unicycle_first_order_0, start: [9, 4, 0], goal: [1, 4, 1]}
)";
}

inline void writeFile(const std::string &file, const std::string &text)
{
    std::ofstream(file) << text;
}

#endif
