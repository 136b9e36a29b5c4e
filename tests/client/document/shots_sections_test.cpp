// Proves that a report has a row for each part that lines cross, and a picture of each direction.
#include "client/document/shots_sections.hpp"

#include "common/job/poses/pose_source.hpp"
#include "common/job/result/record_file.hpp"
#include "tests/support/line_scene.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

ShotsSections sections_of(const LineScene& scene) {
    const TemporaryFolder folder;
    auto writer = RecordWriter::create(folder / "records");
    for (const ScenarioResult& result : scene.results(shots_query(Level::Pairs))) {
        writer.value().add(result.index, encode_result(result));
    }
    EXPECT_TRUE(writer.value().finish());
    PreparedJob job;
    job.spec.unit = "m";
    job.spec.poses = scene.spec;
    job.meshes = {scene.a, scene.lines};
    const auto records = RecordFile::open(folder / "records");
    return ShotsSections::read(records.value(), job, {}).value();
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

TEST(ShotsSections, SayThatNoLineCrossesTheBody) {
    LineScene scene;
    MeshArrays arrays;
    add_part(make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, {{0, 1, 2}}), "flat", arrays);
    scene.a = share(Mesh::create(std::move(arrays)).value());
    scene.lines = share(shot_mesh(scene.spec, scene.box()).value());
    EXPECT_THAT(sections_of(scene).parts().markup(), HasSubstr("No line crosses A."));
}

} // namespace cd::tests
