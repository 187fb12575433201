#include "RandomMaps.h"
#include "ompl_certificates/octomap/OctomapMessage.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"
#include "support/DecimalCommas.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTreeStamped.h>
#include <sstream>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    std::string contentOf(octomap::OcTree &map, bool binary)
    {
        std::ostringstream stream;
        if (binary)
            map.writeBinary(stream);
        else
            map.write(stream);
        return stream.str();
    }
}

class OctomapFile : public testing::TestWithParam<bool>
{
protected:
    std::string write(const std::string &content) const
    {
        return folder_.write(GetParam() ? "map.bt" : "map.ot", content);
    }

    /** Requires that reading \e content fails with a message that names the file and has \e words */
    void expectRefusal(const std::string &content, const std::string &words) const
    {
        const std::string file = write(content), message = messageOf([&] { OctomapObstacles{file}; });
        EXPECT_NE(message.find(file), std::string::npos) << message;
        EXPECT_NE(message.find(words), std::string::npos) << message;
    }

    Folder folder_;
};

TEST_P(OctomapFile, HoldsTheSameCells)
{
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto map = randomMap(random, 0.1);
        OctomapOptions options;
        options.unknownIsOccupied = random.chance(0.5);
        // Writing a .bt file prunes the map.
        const std::string content = contentOf(*map, GetParam());
        const OctomapObstacles expected(*map, options);
        EXPECT_EQ(OctomapObstacles(write(content), options).getFingerprint(), expected.getFingerprint());
        EXPECT_EQ(OctomapObstacles(write(content), options).getBoxes(), expected.getBoxes());
    }
    octomap::OcTree nothing(0.1);
    EXPECT_TRUE(OctomapObstacles(write(contentOf(nothing, GetParam()))).getBoxes().empty());
}

TEST_P(OctomapFile, IsRefusedWhenDamaged)
{
    Random random(1);
    const auto map = randomMap(random, 0.1);
    const std::string content = contentOf(*map, GetParam());
    const std::size_t data = content.find("data\n") + 5;
    for (std::size_t length = 0; length < content.size(); length += length < data + 50 ? 1 : content.size() / 50)
        expectRefusal(content.substr(0, length), "");
    expectRefusal(content + "more", "goes on");
    expectRefusal("o mesh\n" + content, "is no octomap");
    const auto changed = [&](const std::string &from, const std::string &to)
    {
        std::string text = content;
        return text.replace(text.find(from), from.size(), to);
    };
    expectRefusal(changed("id OcTree", "id CountingOcTree"), "CountingOcTree");
    expectRefusal(changed("res 0.1", "res 0"), "res");
    expectRefusal(changed("res 0.1", "res nan"), "res");
    expectRefusal(changed("res 0.1", "res -1"), "res");
    expectRefusal(changed("res 0.1", "res 0.1x"), "res");
    expectRefusal(changed("res 0.1", "res 1e-320"), "res");
    expectRefusal(changed("res 0.1", "res 1e308"), "res");
    expectRefusal(changed("size ", "size 1"), "size");
    expectRefusal(changed("size ", "length "), "size");
    // All nodes are inner ones, deeper and deeper.
    expectRefusal(content.substr(0, data) + std::string(100000, '\xFF'), "more nodes");
    expectRefusal(changed("size ", "size 9").substr(0, data + 1) + std::string(100000, '\xFF'), "deeper");
    expectRefusal(changed("size ", "size 99999999"), "size");
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        // Whatever it makes of it, it neither hangs nor crashes.
        Random noise(seed);
        std::string text = content;
        text[data + noise.below(text.size() - data)] = static_cast<char>(noise.below(256));
        const std::string file = write(text);
        messageOf([&] { OctomapObstacles{file}; });
    }
}

/** Such a cell is occupied for octomap's own threshold. */
TEST_P(OctomapFile, MayHaveCellsOfEvenOdds)
{
    octomap::OcTree map(0.1);
    map.setNodeValue(octomap::point3d(0.05F, 0.05F, 0.05F), 0.0F);
    const OctomapObstacles expected(map);
    ASSERT_EQ(expected.getBoxes().size(), 1U);
    EXPECT_EQ(OctomapObstacles(write(contentOf(map, GetParam()))).getBoxes(), expected.getBoxes());
}

/** Of trees whose nodes have more than OcTree's, such as a color, the cells count. */
template <typename Tree>
void expectCellsOf(const octomap::OcTree &map, const std::function<std::string(const std::string &)> &write,
                   bool isBinary)
{
    Tree tree(map.getResolution());
    for (auto leaf = map.begin_leafs(); leaf != map.end_leafs(); ++leaf)
        if (leaf.getDepth() == map.getTreeDepth())
            tree.setNodeValue(leaf.getKey(), leaf->getLogOdds());
    octomap::OcTree same(map.getResolution());
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
        same.setNodeValue(leaf.getKey(), leaf->getLogOdds());
    std::stringstream stream;
    ASSERT_TRUE(isBinary ? tree.writeBinary(stream) : tree.write(stream));
    EXPECT_EQ(OctomapObstacles(write(stream.str())).getFingerprint(), OctomapObstacles(same).getFingerprint())
        << tree.getTreeType();
}

TEST_P(OctomapFile, MayHaveColorsOrTimes)
{
    Random random(3);
    const auto map = randomMap(random, 0.1);
    const auto writeIt = [this](const std::string &content) { return write(content); };
    expectCellsOf<octomap::ColorOcTree>(*map, writeIt, GetParam());
    expectCellsOf<octomap::OcTreeStamped>(*map, writeIt, GetParam());
}

TEST_P(OctomapFile, IsReadInAnyLocale)
{
    Random random(4);
    const auto map = randomMap(random, 0.1);
    const std::string file = write(contentOf(*map, GetParam()));
    const std::uint64_t expected = OctomapObstacles(file).getFingerprint();
    const DecimalCommas commas;
    EXPECT_EQ(OctomapObstacles(file).getFingerprint(), expected);
}

TEST_P(OctomapFile, MustBeThere)
{
    const std::string file = folder_ / "none.bt";
    EXPECT_NE(messageOf([&] { OctomapObstacles{file}; }).find(file), std::string::npos);
}

TEST_P(OctomapFile, IsReadFromMessages)
{
    Random random(5);
    const auto map = randomMap(random, 0.1);
    const std::string content = contentOf(*map, GetParam());
    // What octomap_msgs puts into a message is what a file has after its header.
    const OctomapMessage message{GetParam(), "OcTree", 0.1, content.substr(content.find("data\n") + 5)};
    EXPECT_EQ(OctomapObstacles(message).getBoxes(), OctomapObstacles(*map).getBoxes());
    EXPECT_EQ(OctomapObstacles(message).getFingerprint(), OctomapObstacles(*map).getFingerprint());
    EXPECT_TRUE(OctomapObstacles(OctomapMessage{GetParam(), "OcTree", 0.1, ""}).getBoxes().empty());

    const auto expectMessage = [&](const std::string &words, const std::function<void(OctomapMessage &)> &damage)
    {
        OctomapMessage damaged = message;
        damage(damaged);
        EXPECT_EQ(messageOf([&] { OctomapObstacles{damaged}; }).rfind("octomap: " + words, 0), 0U)
            << messageOf([&] { OctomapObstacles{damaged}; });
    };
    expectMessage("id: must be", [](OctomapMessage &of) { of.id = "CountingOcTree"; });
    expectMessage("resolution: must be", [](OctomapMessage &of) { of.resolution = std::nan(""); });
    expectMessage("resolution: must be", [](OctomapMessage &of) { of.resolution = 0.0; });
    expectMessage("goes on", [](OctomapMessage &of) { of.data += "more"; });
    expectMessage("goes on", [](OctomapMessage &of) { of.data += "\n"; });
    expectMessage("is damaged", [](OctomapMessage &of) { of.data.assign(100000, '\xFF'); });
    for (std::size_t length = 1; length < message.data.size(); length += 1 + message.data.size() / 50)
        expectMessage("ends before", [length](OctomapMessage &of) { of.data.resize(length); });
}

/** Of a root without children a .bt file does not tell whether it is occupied. For octomap it is. */
TEST(OctomapFile, MayBeOfTheRootAlone)
{
    const Folder folder;
    const std::string file = folder.write(
        "root.bt", "# Octomap OcTree binary file\nid OcTree\nsize 1\nres 0.1\ndata\n" + std::string(2, '\0'));
    octomap::OcTree map(0.1);
    ASSERT_TRUE(map.readBinary(file));
    const OctomapObstacles expected(map);
    ASSERT_EQ(expected.getBoxes().size(), 1U);
    EXPECT_EQ(OctomapObstacles(file).getBoxes(), expected.getBoxes());
}

INSTANTIATE_TEST_SUITE_P(Kind, OctomapFile, testing::Bool(),
                         [](const auto &tested) { return tested.param ? "bt" : "ot"; });
