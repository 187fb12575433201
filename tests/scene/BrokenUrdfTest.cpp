#include "ompl_certificates/scene/ArmFile.h"
#include "support/ArmTexts.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(BrokenUrdf, IsRefusedByName)
    {
        const auto shape = [](const std::string &geometry)
        { return robot(link("a", "<collision><geometry>" + geometry + "</geometry></collision>")); };
        const auto one = [](const std::string &type, const std::string &content)
        { return robot(link("a") + link("b") + joint("j", type, "a", "b", content)); };
        std::string many = link("l0"), deep, stray, attributes;
        for (int i = 1; i <= 10000; ++i)
        {
            many += link("l" + std::to_string(i), "");
            many += joint("j" + std::to_string(i), "fixed", "l" + std::to_string(i - 1), "l" + std::to_string(i));
        }
        for (int i = 0; i < 100000; ++i)
        {
            deep += "<a>";
            attributes += " a" + std::to_string(i) + "='1'";
            stray += joint("j", "fixed", "s" + std::to_string(i), "t" + std::to_string(i));
        }
        struct Case
        {
            std::string urdf;
            std::vector<std::string> parts;
        };
        const std::vector<Case> cases{
            {"", {}},
            {"<robot name='x'>\n<link", {":2", "not valid XML"}},
            {"<sdf/>", {"<robot>", "<sdf>"}},
            {"<robot name='r'/>", {"no link"}},
            {"<robot>" + link("a") + "</robot>", {"name"}},
            {robot("<xacro:include filename='x'/>" + link("a")), {":2", "<xacro:include>", "expand it first"}},
            {robot(link("${name}")), {":2", "<link>", "expand it first"}},
            {"<robot name='$(arg name)'>" + link("a") + "</robot>", {":1", "<robot>", "expand it first"}},
            {robot(link("a") + link("b") + joint("j", "fixed", "a", "b", "<origin xyz='0 0 1' quat_xyzw='0 0 1 0'/>")),
             {"<origin>", "quat_xyzw"}},
            {deep, {"not valid XML"}},
            {robot(many), {"10001 links", "1000"}},
            {robot(link("a") + stray), {"100000 joints", "1000"}},
            {"<robot name='r'" + attributes + ">" + link("a") + "</robot>", {":1", "64 attributes"}},
            {robot("<link name='a'" + attributes + "/>"), {":2", "64 attributes"}},
            {robot(link("a") + link("a")), {"'a'"}},
            {robot(link("a") + link("b")), {"root", "a", "b"}},
            {robot(link("a") + link("b") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a")), {"loop"}},
            {robot(link("r") + link("a") + link("b") + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a")),
             {"loop"}},
            {robot(link("a") + link("b") + link("c") + joint("j", "fixed", "a", "c") + joint("k", "fixed", "b", "c")),
             {"'c'", "'j'", "'k'"}},
            {robot(link("a") + link("b") + joint("j", "fixed", "z", "b")), {"[z]", "[j]"}},
            {one("sideways", ""), {"[j]", "sideways"}},
            {one("revolute", ""), {"[j]", "limits"}},
            {one("prismatic", ""), {"[j]", "limits"}},
            {one("revolute", "<limit lower='nan' upper='1' effort='1' velocity='1'/>"), {"nan"}},
            {one("revolute", "<limit lower='2' upper='1' effort='1' velocity='1'/>"), {"'j'", "lower 2", "upper 1"}},
            {one("revolute", "<axis xyz='0 0 0'/>" + LIMIT), {"'j'", "axis"}},
            {one("revolute", "<axis xyz='0 0 z'/>" + LIMIT), {"z"}},
            {one("fixed", "<origin xyz='0 0'/>"), {"[j]"}},
            {one("fixed", "<origin xyz='0 0 1e300'/>"), {"'j'", "origin"}},
            {one("fixed", "<origin xyz='%s%n 0 0'/>"), {"<origin>", "xyz", "'%s%n 0 0'"}},
            {shape("<sphere radius='%s%s%n'/>"), {"<sphere>", "radius", "'%s%s%n'"}},
            {one("continuous", "<mimic joint='j'/>"), {"'j'"}},
            {shape("<sphere radius='-1'/>"), {"'a'", "collision 1", "radius", "-1"}},
            {shape("<sphere radius='x'/>"), {"x"}},
            {shape("<box size='1 -1 1'/>"), {"'a'", "box size y", "-1"}},
            {shape("<cylinder radius='1' length='-2'/>"), {"'a'", "cylinder length", "-2"}},
            {shape("<capsule radius='1' length='2'/>"), {"[a]", "capsule"}},
            {shape("<mesh filename='none.stl'/>"), {"'a'", "'none.stl'"}},
            {shape("<mesh filename='package://none/none.stl'/>"), {"'a'", "package 'none'"}},
            {shape("<mesh filename='http://x/y.stl'/>"), {"'a'", "http://x/y.stl"}},
            {shape("<mesh filename='a.urdf'/>"), {"'a'", "a.urdf", ".stl"}},
            {shape("<mesh filename='t.obj' scale='1 0 1'/>"), {"'a'", "scale", "1 0 1"}},
            {shape(""), {"[a]"}},
        };
        testing::internal::CaptureStderr();
        testing::internal::CaptureStdout();
        for (const Case &broken : cases)
        {
            const test::Folder folder;
            folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            const std::string file = folder.write("a.urdf", broken.urdf);
            const std::string message = messageOf([&] { ArmFile{file}; });
            EXPECT_NE(message.find(file), std::string::npos) << message << broken.urdf.substr(0, 500);
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            for (const std::string &part : broken.parts)
                EXPECT_NE(message.find(part), std::string::npos) << "no " << part << " in " << message;
        }
        EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "urdfdom must not print";
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "urdfdom must not print";
        EXPECT_NE(messageOf([] { ArmFile("/none.urdf"); }).find("/none.urdf"), std::string::npos);
    }
}
