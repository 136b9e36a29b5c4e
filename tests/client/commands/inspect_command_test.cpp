// Proves that `cdctl inspect` warns of every two meshes whose sizes differ like units, and ends at
// the first file that is no mesh.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "tests/client/import/gltf_text.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Inspect : public testing::Test {
  protected:
    /// Adds a triangle with sides 3, 4 and 5 times `size`: its box has a diagonal of 5 times
    /// `size`.
    void add(const std::string& name, double size) {
        std::ostringstream text;
        text.precision(17);
        text << "v 0 0 0\nv " << 3 * size << " 0 0\nv 0 " << 4 * size << " 0\nf 1 2 3\n";
        add_text(name, text.str());
    }
    void add_text(const std::string& name, const std::string& text) {
        write_text(folder_ / name, text);
        command_.meshes.push_back((folder_ / name).string());
    }

    int run() {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(command_);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    TemporaryFolder folder_;
    InspectCommand command_;
    std::string stdout_;
    std::string stderr_;
};

} // namespace

TEST_F(Inspect, EachTwoMeshesWhoseSizesDifferAsUnitsDoAreWarnedAbout) {
    add("metres.obj", 1);
    add("other.obj", 3);
    add("inches.obj", 1000 / 25.4);
    add("millimetres.obj", 1000);
    EXPECT_EQ(run(), exit_done);
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 2) << stderr_;
    EXPECT_THAT(stderr_,
                HasSubstr("millimetres.obj is 1000.0 times as large as " +
                          (folder_ / "metres.obj").string() +
                          "; if one is in another unit (mm or m)"));
    EXPECT_THAT(stderr_,
                HasSubstr("millimetres.obj is 25.4 times as large as " +
                          (folder_ / "inches.obj").string() +
                          "; if one is in another unit (in or mm)"));
    EXPECT_THAT(stderr_, Not(HasSubstr("other.obj")));
    for (const std::string& mesh : command_.meshes) {
        EXPECT_THAT(stdout_, HasSubstr(mesh));
    }
}

TEST_F(Inspect, SizesWithinTwoPercentOfAUnitAreSuspect) {
    for (const double unit : {25.4, 1000.0}) {
        for (const double off : {0.979, 0.981, 1.019, 1.021}) {
            SCOPED_TRACE(testing::Message() << unit << " times " << off);
            command_.meshes.clear();
            add("a.obj", unit * off);
            add("b.obj", 1);
            EXPECT_EQ(run(), exit_done);
            EXPECT_EQ(!stderr_.empty(), off > 0.98 && off < 1.02) << stderr_;
        }
    }
}

TEST_F(Inspect, AUnitGivenIsApplied) {
    command_.unit = "mm";
    add("a.obj", 1000);
    EXPECT_EQ(run(), exit_done);
    EXPECT_THAT(stdout_, HasSubstr("3 x 4 x 0"));
}

TEST_F(Inspect, WhatTheFileDeclaresIsNamed) {
    add_text("a.gltf", GltfText::triangle().text());
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("up axis Y, from the file; not turned"));
    command_.unit = "mm";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(stdout_, HasSubstr("unit mm, as asked; the file says m"));
}

TEST_F(Inspect, ANameThatIsNoUtf8IsStillJson) {
    add_text("a.obj", "o a\xff\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    command_.output = "json";
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_TRUE(nlohmann::json::accept(stdout_)) << stdout_;
}

TEST_F(Inspect, EndsAtTheFirstFileThatIsNoMesh) {
    add("good.obj", 1);
    add_text("bad.ac", "AC3Db\nOBJECT poly\nnumvert 1\n0 0 1d5\n");
    add("after.obj", 1);
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stdout_, AllOf(HasSubstr("good.obj"), Not(HasSubstr("after.obj"))));
    EXPECT_THAT(stderr_, HasSubstr("bad.ac:4: "));
    EXPECT_EQ(std::count(stderr_.begin(), stderr_.end(), '\n'), 1);
}

TEST_F(Inspect, APictureOfOneMeshIsDrawn) {
    add("a.obj", 1);
    command_.png = (folder_ / "a.png").string();
    EXPECT_EQ(run(), exit_done) << stderr_;
    EXPECT_THAT(read_text(command_.png), testing::StartsWith("\x89PNG\r\n"));
    add("b.obj", 1);
    EXPECT_EQ(run(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--png draws one mesh"));
}

} // namespace cd::tests
