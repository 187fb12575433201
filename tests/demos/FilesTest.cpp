#include "common/Files.h"
#include "support/Folder.h"

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace fs = std::filesystem;
using ompl_certificates::test::Folder;

namespace
{
    template <typename Function>
    void expectToNameTheFile(const std::vector<std::string> &files, const Function &function)
    {
        for (const std::string &file : files)
            try
            {
                function(file);
                ADD_FAILURE() << file;
            }
            catch (const ompl::Exception &exception)
            {
                EXPECT_EQ(std::string(exception.what()).find((file.empty() ? "''" : file) + ": "), 0u)
                    << exception.what();
            }
    }
}

TEST(Files, areReplacedWhole)
{
    const Folder folder;
    const std::string file = folder / "a.txt", link = folder / "link.txt";
    demos::writeFile(file, "first, and longer");
    demos::writeFile(file, "second");
    EXPECT_EQ(demos::readFile(file), "second");
    fs::create_symlink(file, link);
    demos::writeFile(link, "third");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(demos::readFile(file), "third");
    EXPECT_EQ(folder.list().size(), 2u);
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    demos::writeFile(file, "secret");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    demos::writeFile("/dev/null", "nothing");
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST(Files, stayAsTheyAreWhenTheDiskIsFull)
{
    const Folder folder;
    demos::writeFile(folder / "a.txt", "old");
    // A limit on the size of files is met as a full disk is: some of the text is written, then no more.
    rlimit before;
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{10000, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(demos::writeFile(folder / "a.txt", std::string(1000000, 'x')), ompl::Exception);
    EXPECT_THROW(demos::writeFile(folder / "b.txt", std::string(1000000, 'x')), ompl::Exception);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(demos::readFile(folder / "a.txt"), "old");
    EXPECT_EQ(folder.list().size(), 1u) << "neither a part of a file nor a temporary one is left";
    EXPECT_THROW(demos::writeFile("/dev/full", "text"), ompl::Exception);
}

TEST(Files, thatCannotBeReadOrWrittenAreNamed)
{
    const Folder folder;
    demos::writeFile(folder / "a.txt", "old");
    fs::create_symlink(folder / "a.txt", folder / "link.txt");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const std::string &file :
         {folder / "a.txt", folder / "link.txt", folder / "new.txt", folder / "pipe", std::string("/dev/null")})
        EXPECT_NO_THROW(demos::requireWritable(file)) << file;
    EXPECT_EQ(demos::readFile(folder / "a.txt"), "old");
    // Access rights tell nothing of the last ones to root.
    expectToNameTheFile(
        {folder / "no/a.txt", folder / "a.txt/b.txt", folder.path(), "", "/dev/full", "/proc/a.txt", "/proc/version"},
        demos::requireWritable);
    expectToNameTheFile({folder / "no/a.txt", folder / "a.txt/b.txt", folder.path(), "", "/dev/full", "/proc/a.txt"},
                        [](const std::string &file) { demos::writeFile(file, "text"); });
    expectToNameTheFile({folder / "no/a.txt", folder / "a.txt/b.txt", folder.path(), ""}, demos::readFile);
    EXPECT_EQ(folder.list().size(), 3u);
}
