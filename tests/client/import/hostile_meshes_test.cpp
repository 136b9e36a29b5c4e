// Proves that a whole run on degenerate, denormal, huge and mixed coordinates, under poses as far
// as doubles reach, ends with a defined answer and bounded memory; and that coordinates and poses
// that are not finite give one line that names their location.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "client/formats/npz.hpp"
#include "client/import/mesh_import.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

const std::string still = "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n";
const std::string far_and_near =
    still + "0.25,0.1,0.1,0.5,0.5,0.5,0.5\n1,0,0,0,0,0.6,0.8\n1e300,0,0,0,0,0,1\n"
            "-1.7e308,1.7e308,1e-320,0,0,0,1\n1e-320,0,0,0,0,0,1\n";

/// Writes a tetrahedron's open faces, two segments and a point.
void write_mesh(const std::filesystem::path& path, const Vec3& factors, const Vec3& offset) {
    const std::vector<std::int64_t> faces{0, 1, 2, 0, 1, 3, 1, 2, 3, 0, 0, 1, 1, 2, 1, 2, 2, 2};
    std::vector<double> vertices;
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Vec3 place = corner.cwiseProduct(factors) + offset;
        vertices.insert(vertices.end(), place.begin(), place.end());
    }
    NpzWriter writer(path);
    const auto v = writer.add_array({"vertices", NpyType::F8, 3});
    const auto f = writer.add_array({"faces", NpyType::I8, 3});
    EXPECT_TRUE(writer.append(v, std::span<const double>(vertices)));
    EXPECT_TRUE(writer.append(f, std::span<const std::int64_t>(faces)));
    ASSERT_TRUE(writer.finish());
}

constexpr std::size_t text_faces[4][3] = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 0, 1}};

/// Writes each face as `begin`, its corners in the form of `corner`, `end`.
template <class Corner>
std::string faces_text(const std::string& begin, const Corner& corner, const std::string& end) {
    std::string text;
    for (const auto& face : text_faces) {
        text += begin;
        for (const std::size_t vertex : face) {
            text += corner(vertex);
        }
        text += end;
    }
    return text;
}

/// Returns three faces of a tetrahedron and a segment in the text of a format.
std::string text_mesh(const std::string& extension, const std::string& size) {
    const std::array<std::string, 4> corners{
        "0 0 0\n", size + " 0 0\n", "0 " + size + " 0\n", "0 0 " + size + "\n"};
    const std::string vertices = corners[0] + corners[1] + corners[2] + corners[3];
    const auto number = [](std::size_t vertex) { return " " + std::to_string(vertex); };
    if (extension == "obj") {
        return "v " + corners[0] + "v " + corners[1] + "v " + corners[2] + "v " + corners[3] +
               faces_text(
                   "f", [&](std::size_t vertex) { return number(vertex + 1); }, "\n");
    }
    if (extension == "off") {
        return "OFF\n4 4 0\n" + vertices + faces_text("3", number, "\n");
    }
    if (extension == "ply") {
        return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
               "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
               "end_header\n" +
               vertices + faces_text("3", number, "\n");
    }
    if (extension == "stl") {
        const auto corner = [&](std::size_t vertex) { return "vertex " + corners[vertex]; };
        return "solid a\n" +
               faces_text("facet normal 0 0 1\nouter loop\n", corner, "endloop\nendfacet\n") +
               "endsolid a\n";
    }
    const auto corner = [](std::size_t vertex) { return std::to_string(vertex) + " 0 0\n"; };
    return "AC3Db\nOBJECT poly\nnumvert 4\n" + vertices + "numsurf 4\n" +
           faces_text("SURF 0x10\nmat 0\nrefs 3\n", corner, "") + "kids 0\n";
}

struct Outcome {
    int code = 0;
    std::string text; ///< All output.
};

Outcome run(const std::filesystem::path& a,
            const std::filesystem::path& b,
            const std::filesystem::path& poses,
            const std::string& level,
            const std::filesystem::path& out = {}) {
    RunCommand command;
    command.job.a = a.string();
    command.job.b = b.string();
    command.job.poses.file = poses.string();
    command.job.query.level = level;
    command.job.output.dir = out.string();
    command.host.threads = 1;
    command.quiet = true;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = execute(command);
    outcome.text = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    return outcome;
}

/// Expects one line that names the location, and no output file.
void expect_refused(const TemporaryFolder& folder,
                    const std::string& mesh,
                    const std::string& poses,
                    const std::string& place) {
    SCOPED_TRACE(mesh + " under " + poses);
    for (const char* level : {"any", "contacts"}) {
        const Outcome outcome =
            run(folder / mesh, folder / "unit.npz", folder / poses, level, folder / "out");
        EXPECT_EQ(outcome.code, exit_usage);
        EXPECT_THAT(outcome.text, HasSubstr(place));
        EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
}

long peak_kib() {
    rusage usage{};
    EXPECT_EQ(::getrusage(RUSAGE_SELF, &usage), 0);
    return usage.ru_maxrss;
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
    write_mesh(folder / "segments.npz", Vec3(1, 0, 0), Vec3(0.25, 0, 0));
    write_mesh(folder / "point.npz", none, Vec3(1, 2, 3));
    write_mesh(folder / "far.npz", Vec3::Constant(1e-3), Vec3(1e7, -1e7, 1e7));
    write_text(folder / "poses.csv", far_and_near);
    const long before = peak_kib();
    for (const std::string name :
         {"unit", "denormal", "huge", "widest", "mixed", "segments", "point", "far"}) {
        for (const std::string& other : {name, std::string("unit")}) {
            for (const char* level : {"any", "count", "pairs", "contacts"}) {
                SCOPED_TRACE(name + " and " + other);
                const Outcome outcome = run(folder / (name + ".npz"),
                                            folder / (other + ".npz"),
                                            folder / "poses.csv",
                                            level);
                EXPECT_EQ(outcome.code, exit_done);
                EXPECT_THAT(outcome.text, HasSubstr("failed 0    tested 6 of 6"));
            }
        }
    }
#ifdef __SANITIZE_ADDRESS__ // It keeps freed memory for a while.
    const long bound_kib = 1024 * 1024;
#else
    const long bound_kib = 256 * 1024;
#endif
    EXPECT_LT(peak_kib() - before, bound_kib);
}

TEST(HostileMeshes, TextFilesOfTheSmallestAndTheLargestFloatsHaveAnAnswer) {
    const TemporaryFolder folder;
    write_mesh(folder / "unit.npz", Vec3(1, 1, 1), Vec3::Zero());
    write_text(folder / "poses.csv", far_and_near);
    for (const std::string extension : {"obj", "off", "ply", "stl", "ac"}) {
        for (const std::string size : {"1e-40", "1e-44", "1e-400", "-3e38"}) {
            SCOPED_TRACE(size + " in " + extension);
            const auto mesh = folder / ("mesh." + extension);
            write_text(mesh, text_mesh(extension, size));
            for (const auto& other : {mesh, folder / "unit.npz"}) {
                for (const char* level : {"any", "contacts"}) {
                    const Outcome outcome = run(mesh, other, folder / "poses.csv", level);
                    EXPECT_EQ(outcome.code, exit_done);
                    EXPECT_THAT(outcome.text, HasSubstr("failed 0    tested 6 of 6"));
                }
            }
        }
    }
}

TEST(HostileMeshes, CoordinatesThatAreNotFiniteAreRefusedByFace) {
    const TemporaryFolder folder;
    write_mesh(folder / "unit.npz", Vec3(1, 1, 1), Vec3::Zero());
    write_text(folder / "poses.csv", still);
    for (const double bad : {not_a_number, infinite, -infinite}) {
        write_mesh(folder / "bad.npz", Vec3(1, 1, 1), Vec3(0, bad, 0));
        expect_refused(folder, "bad.npz", "poses.csv", "bad.npz: vertex 0");
    }
    for (const std::string extension : {"obj", "off", "ply", "stl"}) {
        const std::string mesh = "bad." + extension;
        write_text(folder / mesh, text_mesh(extension, "1e400"));
        expect_refused(folder, mesh, "poses.csv", "a coordinate that is not finite");
    }
    // 2^400 exceeds floats, in which other formats are read.
    write_text(folder / "bad.ac", text_mesh("ac", "2.5822498780869086e120"));
    expect_refused(folder, "bad.ac", "poses.csv", "bad.ac: face 0");
}

TEST(HostileMeshes, PartsThatDoNotFitTheirMeshAreRefused) {
    using Row = std::array<std::uint32_t, 3>;
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "parts.npz";
    const auto import = [&](const std::vector<Row>& rows, std::size_t columns = 3) {
        NpzWriter writer(path);
        const auto v = writer.add_array({"vertices", NpyType::F8, 3});
        const auto f = writer.add_array({"faces", NpyType::U4, 3});
        const auto p = writer.add_array({"parts", NpyType::U4, columns});
        const auto n = writer.add_array({"part_names", NpyType::U1});
        EXPECT_TRUE(writer.append(v, std::span<const double>(std::array<double, 3>{})));
        EXPECT_TRUE(
            writer.append(f, std::span<const std::uint32_t>(std::array<std::uint32_t, 6>{})));
        for (const Row& row : rows) {
            EXPECT_TRUE(writer.append(p, std::span<const std::uint32_t>(row)));
        }
        EXPECT_TRUE(writer.append(n, std::span<const char>(std::string_view("a/bc"))));
        EXPECT_TRUE(writer.finish());
        return import_mesh(path, {});
    };
    const auto good = import({{0, 1, 3}, {1, 2, 1}});
    ASSERT_TRUE(good) << good.error().detail;
    EXPECT_EQ(good.value().mesh->parts(), (std::vector<Part>{{"a/b", 0, 1}, {"c", 1, 2}}));
    for (const auto& [rows, what] :
         {std::pair(std::vector<Row>{{0, 1, 3}, {1, 2, 2}}, "within the name of part 1"),
          std::pair(std::vector<Row>{{0, 3, 1}}, "part 'a' is out of order or out of range"),
          std::pair(std::vector<Row>{{1, 2, 1}, {0, 1, 1}}, "part '/' is out of order"),
          std::pair(std::vector<Row>{{0, 1, UINT32_MAX}}, "within the name of part 0")}) {
        const auto refused = import(rows);
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().detail, StartsWith(path.string() + ": "));
        EXPECT_THAT(refused.error().detail, HasSubstr(what));
    }
    EXPECT_FALSE(import({{0, 1, 3}}, 1));
}

TEST(HostileMeshes, PosesThatAreNotFiniteAreRefusedByPlace) {
    const TemporaryFolder folder;
    write_mesh(folder / "unit.npz", Vec3(1, 1, 1), Vec3::Zero());
    for (const std::string bad : {"nan", "NaN", "inf", "-inf"}) {
        write_text(folder / "poses.csv", far_and_near + "0," + bad + ",0,0,0,0,1\n");
        expect_refused(folder, "unit.npz", "poses.csv", "line 8");
        write_text(folder / "poses.csv", still + "0,0,0,0,0," + bad + ",1\n");
        expect_refused(folder, "unit.npz", "poses.csv", "line 3");
        write_text(folder / "poses.tum", "0 0 0 0 0 0 0 1\n1 " + bad + " 0 0 0 0 0 1\n");
        expect_refused(folder, "unit.npz", "poses.tum", "line 2");
    }
    write_text(folder / "poses.csv", still + "0,1e309,0,0,0,0,1\n");
    expect_refused(folder, "unit.npz", "poses.csv", "line 3: y is '1e309'");
    for (const double bad : {not_a_number, infinite, -infinite}) {
        std::vector<double> poses;
        for (int row = 0; row < 3; ++row) {
            poses.insert(poses.end(), {1, 0, 0, row == 2 ? bad : 0, 0, 1, 0, 0, 0, 0, 1, 0});
        }
        NpzWriter writer(folder / "poses.npz");
        const auto array = writer.add_array({"poses", NpyType::F8, 12});
        EXPECT_TRUE(writer.append(array, std::span<const double>(poses)));
        ASSERT_TRUE(writer.finish());
        expect_refused(folder, "unit.npz", "poses.npz", "row 2");
    }
}

} // namespace cd::tests
