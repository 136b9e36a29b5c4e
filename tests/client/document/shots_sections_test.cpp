// Proves that a report has a row for each part that lines cross, and a picture of each direction.
#include "client/document/shots_sections.hpp"

#include "common/job/poses/pose_source.hpp"
#include "common/job/result/record_file.hpp"
#include "tests/support/line_scene.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

PreparedJob shots_job_of(const LineScene& scene) {
    PreparedJob job;
    job.spec.unit = "m";
    job.spec.poses = scene.spec;
    job.meshes = {scene.a, scene.lines};
    return job;
}

RecordFile shot_records_of(const LineScene& scene, const TemporaryFolder& folder) {
    auto writer = RecordWriter::create(folder / "records");
    for (const ScenarioResult& result : scene.results(shots_query(Level::Pairs))) {
        writer.value().add(result.index, encode_result(result));
    }
    EXPECT_TRUE(writer.value().finish());
    return std::move(RecordFile::open(folder / "records").value());
}

ShotsSections sections_of(const LineScene& scene) {
    const TemporaryFolder folder;
    return ShotsSections::read(shot_records_of(scene, folder), shots_job_of(scene), {}).value();
}

/// Returns width and height of a PNG file.
std::pair<unsigned, unsigned> size_of_png(const std::string& bytes) {
    const auto number = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = at; i < at + 4; ++i) {
            value = value << 8 | static_cast<unsigned char>(bytes[i]);
        }
        return value;
    };
    return {number(16), number(20)};
}

} // namespace

TEST(ShotsSections, APartHasItsAreaAndThickness) {
    const std::string table = sections_of(LineScene()).parts().markup();
    EXPECT_THAT(table, HasSubstr("<td>first</td><td>16</td><td>32</td><td>1 m"));
    EXPECT_THAT(table, HasSubstr("<td>0.5 m</td><td>0.5 m</td>"));
    EXPECT_THAT(table, HasSubstr("<td>open</td><td>open</td>")) << "the plate";
}

TEST(ShotsSections, EachDirectionHasAPicture) {
    const std::string one = sections_of(LineScene()).pictures().markup();
    EXPECT_THAT(one, HasSubstr("azimuth 0, elevation 0: at most 1.5 m thick"));
    EXPECT_THAT(one, Not(HasSubstr("The first")));
    LineScene scene;
    scene.spec.azimuth_deg = {0, 330, 12};
    const std::string many = sections_of(scene).pictures().markup();
    EXPECT_THAT(many, HasSubstr("azimuth 210, elevation 0"));
    EXPECT_THAT(many, Not(HasSubstr("azimuth 240, elevation 0")));
    EXPECT_THAT(many, HasSubstr("The first 8 of 12 directions."));
}

TEST(ShotsSections, EachDirectionHasALargePictureInAFile) {
    LineScene scene;
    scene.spec.azimuth_deg = {0, 330, 12};
    scene.spec.elevation_deg = {-15, 0, 2};
    scene.lines = share(shot_mesh(scene.spec, scene.box()).value());
    const TemporaryFolder folder;
    const RecordFile records = shot_records_of(scene, folder);
    ASSERT_TRUE(write_thickness_pictures(folder.path(), records, shots_job_of(scene), {}));
    std::size_t files = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) {
        files += each.path().extension() == ".png" ? 1 : 0;
    }
    EXPECT_EQ(files, 24u) << "more than a report shows";
    EXPECT_TRUE(std::filesystem::exists(folder / "thickness-az30-el-15.png"));
    const auto [width, height] = size_of_png(read_text(folder / "thickness-az0-el0.png"));
    EXPECT_EQ(width % 12, 0u) << "a line is a square of pixels";
    EXPECT_EQ(width, height);
    EXPECT_GT(width, 900u);
    EXPECT_LE(width, 1024u);
    EXPECT_EQ(
        write_thickness_pictures(folder.path(), records, shots_job_of(scene), [] { return true; })
            .error()
            .code,
        ErrorCode::Interrupted);
}

TEST(ShotsSections, SayThatNoLineCrossesTheBody) {
    LineScene scene;
    MeshArrays arrays;
    add_part(make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, {{0, 1, 2}}), "flat", arrays);
    scene.a = share(Mesh::create(std::move(arrays)).value());
    scene.lines = share(shot_mesh(scene.spec, scene.box()).value());
    EXPECT_THAT(sections_of(scene).parts().markup(), HasSubstr("No line crosses A."));
}

} // namespace cd::tests
