// Proves that the pictures of a report are the same pixels on every host: they equal golden files.
#include "client/document/report_pictures.hpp"

#include "common/core/limits/client.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;

/// Returns the pixels of a PNG file; empty if it cannot be read.
std::vector<png_byte> pixels_of(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) {
        return {};
    }
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
    return png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0
               ? std::vector<png_byte>()
               : pixels;
}

/// Compares a picture with its golden file. If they differ, the picture is left in the build
/// folder.
void expect_golden(const std::string& png, const std::string& name) {
    const fs::path golden = fs::path(CD_SOURCE_DIR) / "tests/client/document/golden" / name;
    const auto pixels = pixels_of(png);
    ASSERT_FALSE(pixels.empty()) << name;
    if (!fs::exists(golden) || pixels != pixels_of(read_text(golden))) {
        const fs::path made = fs::path(CD_BINARY_DIR) / "golden" / name;
        fs::create_directories(made.parent_path());
        write_text(made, png);
        ADD_FAILURE() << "the picture " << made << " differs from " << golden;
    }
}

/// Makes a job of a torus and a sphere in two poses.
PreparedJob two_poses() {
    PreparedJob job;
    const Mesh torus = make_torus(1, 0.3, 24, 12);
    MeshArrays arrays{torus.vertices(), torus.triangles(), {}, torus.precision()};
    const auto half = static_cast<std::uint32_t>(arrays.triangles.size() / 2);
    arrays.parts = {{"front", 0, half}, {"back", half, 2 * half}};
    job.meshes = {share(Mesh::create(std::move(arrays)).value()), share(make_sphere(2))};
    std::vector<Scenario> scenarios(2);
    scenarios[0].poses.b = translation_pose(1.5, 0.25, 0);
    scenarios[1].index = 1;
    scenarios[1].poses.b = translation_pose(0, -1.75, 0.5);
    job.poses = make_list_source(scenarios);
    return job;
}

std::vector<ScenarioResult> two_results() {
    std::vector<ScenarioResult> results(2);
    results[0].pairs = {{1, 5, PairClass::Proper}, {2, 6, PairClass::Proper}};
    results[1].index = 1;
    results[1].pairs = {{100, 50, PairClass::Proper}};
    return results;
}

} // namespace

TEST(ReportPictures, EqualTheirGoldenFiles) {
    ReportPictures pictures;
    ASSERT_TRUE(pictures.draw(two_poses(), two_results(), {}));
    ASSERT_EQ(pictures.bodies().size(), 2u);
    ASSERT_EQ(pictures.scenarios().size(), 2u);
    expect_golden(pictures.bodies()[0], "torus.png");
    expect_golden(pictures.bodies()[1], "sphere.png");
    expect_golden(pictures.scenarios()[0], "scenario-0.png");
    expect_golden(pictures.scenarios()[1], "scenario-1.png");
}

TEST(ReportPictures, ShowEachMeshOfASceneOnce) {
    PreparedJob job = two_poses();
    job.meshes = {job.meshes[0], job.meshes[1], job.meshes[0], job.meshes[0]};
    EXPECT_EQ(shown_bodies(job).size(), 4u) << "of no scene";
    job.scene.emplace();
    const std::vector<ShownBody> shown = shown_bodies(job);
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_EQ(shown[0].body, 0u);
    EXPECT_EQ(shown[0].others, 2u);
    EXPECT_EQ(shown[1].body, 1u);
    EXPECT_EQ(shown[1].others, 0u);
    ReportPictures pictures;
    ASSERT_TRUE(pictures.draw(job, {}, {}));
    EXPECT_EQ(pictures.bodies().size(), 2u);
    const TemporaryFolder folder;
    ASSERT_TRUE(write_pictures(folder.path(), job, {}, {}));
    EXPECT_TRUE(fs::exists(folder / "body-0.png"));
    EXPECT_TRUE(fs::exists(folder / "body-1.png"));
    EXPECT_FALSE(fs::exists(folder / "body-2.png"));
}

TEST(ReportPictures, ShowMotionsAtTheirEvent) {
    PreparedJob job = two_poses();
    Scenario moving = job.poses->read(0, 1).value().front();
    moving.poses.a = moved_pose({0, 0, 0});
    moving.poses.b = moved_pose({3, 0.5, 0});
    moving.to = PosePair{moving.poses.a, moved_pose({0, 0, 0})};
    job.poses = make_list_source({moving});
    ScenarioResult result = two_results()[0];
    result.motion =
        MotionOutcome{Until::Contact, 2, MotionEnd::Contact, 1, 2, {{CellState::Open, 0, 2, 2, 2}}};
    ReportPictures pictures;
    ASSERT_TRUE(pictures.draw(job, {result}, {}));
    EXPECT_EQ(pixels_of(pictures.scenarios()[0]).size(), 480u * 300 * 3);
    expect_golden(pictures.scenarios()[0], "scenario-0.png"); // Half of the way.
}

TEST(ReportPictures, AFolderGetsLargeOnes) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_pictures(folder / "large", two_poses(), two_results(), {}));
    for (const char* name : {"a.png", "b.png", "0.png", "1.png"}) {
        EXPECT_EQ(pixels_of(read_text(folder / "large" / name)).size(), 1200u * 750 * 3) << name;
    }
}

TEST(ReportPictures, StayWithinTheirLimit) {
    ReportPictures pictures;
    std::vector<ScenarioResult> many(400, two_results()[0]);
    for (ScenarioResult& result : many) {
        result.pairs.clear(); // Then no picture looks for the best direction.
    }
    ASSERT_TRUE(pictures.draw(two_poses(), many, {}));
    std::size_t bytes = 0;
    for (const auto* list : {&pictures.bodies(), &pictures.scenarios()}) {
        for (const std::string& png : *list) {
            bytes += png.size();
        }
    }
    EXPECT_LE(bytes, limits::report_pictures_bytes_max);
    EXPECT_EQ(pictures.scenarios().size(), many.size());
    EXPECT_FALSE(pictures.scenarios().front().empty());
    EXPECT_TRUE(pictures.scenarios().back().empty());
}

TEST(ReportPictures, CanBeInterrupted) {
    const TemporaryFolder folder;
    ReportPictures pictures;
    const auto stop = [] { return true; };
    for (const Status& drawn : {pictures.draw(two_poses(), two_results(), stop),
                                write_pictures(folder.path(), two_poses(), two_results(), stop)}) {
        ASSERT_FALSE(drawn);
        EXPECT_EQ(drawn.error().code, ErrorCode::Interrupted);
    }
}

} // namespace cd::tests
