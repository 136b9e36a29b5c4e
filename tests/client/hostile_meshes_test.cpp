// Proves that a whole run ends with a defined answer on meshes of degenerate, denormal, huge and
// mixed coordinates, under poses as far as doubles reach.
#include "client/commands/commands.hpp"
#include "client/exit_code.hpp"
#include "client/npz.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

/// A tetrahedron's open faces, two segments and a point.
void write_mesh(const std::filesystem::path& path, const Vec3& factors, const Vec3& offset) {
    const std::vector<std::int64_t> faces{0, 1, 2, 0, 1, 3, 1, 2, 3, 0, 0, 1, 1, 2, 1, 2, 2, 2};
    std::vector<double> vertices;
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Vec3 place = corner.cwiseProduct(factors) + offset;
        vertices.insert(vertices.end(), place.begin(), place.end());
    }
    NpzWriter writer(path);
    const auto v = writer.add_array("vertices", NpyType::F8, 3);
    const auto f = writer.add_array("faces", NpyType::I8, 3);
    writer.append(v, std::span<const double>(vertices));
    writer.append(f, std::span<const std::int64_t>(faces));
    ASSERT_TRUE(writer.finish());
}

} // namespace

TEST(HostileMeshes, EveryScenarioOfARunHasAnAnswer) {
    const TemporaryFolder folder;
    const Vec3 none = Vec3::Zero();
    write_mesh(folder / "unit.npz", Vec3(1, 1, 1), none);
    write_mesh(folder / "denormal.npz", Vec3::Constant(0x1p-1072), none);
    write_mesh(folder / "huge.npz", Vec3::Constant(0x1p400), none);
    write_mesh(folder / "widest.npz", Vec3(1.7e308, -1.7e308, 1.7e308), none);
    write_mesh(folder / "mixed.npz", Vec3(0x1p1000, 0x1p-1074, 1), none);
    write_mesh(folder / "point.npz", none, Vec3(1, 2, 3));
    write_mesh(folder / "far.npz", Vec3::Constant(1e-3), Vec3(1e7, -1e7, 1e7));
    write_text(folder / "poses.csv",
               "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n0.25,0.1,0.1,0.5,0.5,0.5,0.5\n1,0,0,0,0,0.6,0.8\n"
               "1e300,0,0,0,0,0,1\n-1.7e308,1.7e308,1e-320,0,0,0,1\n1e-320,0,0,0,0,0,1\n");
    for (const char* name : {"unit", "denormal", "huge", "widest", "mixed", "point", "far"}) {
        for (const std::string& other : {std::string(name), std::string("unit")}) {
            for (const char* level : {"any", "count", "contacts"}) {
                SCOPED_TRACE(std::string(name) + " and " + other);
                RunCommand command;
                command.job.a = (folder / (std::string(name) + ".npz")).string();
                command.job.b = (folder / (other + ".npz")).string();
                command.job.poses = (folder / "poses.csv").string();
                command.job.level = level;
                command.threads = 1;
                command.quiet = true;
                testing::internal::CaptureStdout();
                testing::internal::CaptureStderr();
                EXPECT_EQ(execute(command), exit_done);
                const std::string text =
                    testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
                EXPECT_THAT(text, testing::HasSubstr("failed 0    tested 6 of 6"));
            }
        }
    }
}

} // namespace cd::tests
