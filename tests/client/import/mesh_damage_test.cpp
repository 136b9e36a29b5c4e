// Proves that damaged text files are refused with one line, and that files that only look damaged
// are read.
#include "client/import/mesh_import.hpp"
#include "client/report/inspect.hpp"
#include "tests/client/import/import_text.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::string off_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string ply_header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n"
                               "0 0 0\n1 0 0\n0 1 0\n";

} // namespace

TEST(MeshDamage, OffWithFewerOrMoreFacesThanItCounts) {
    EXPECT_TRUE(import_text("good.off", "OFF\n4 2 0\n" + off_vertices + "3 0 1 2\n3 0 1 3\n"));
    EXPECT_THAT(error_of("fewer.off", "OFF\n4 3 0\n" + off_vertices + "3 0 1 2\n"),
                HasSubstr("face 1 of 3"));
    EXPECT_THAT(error_of("more.off", "OFF\n4 1 0\n" + off_vertices + "3 0 1 2\n3 0 1 3\n"),
                HasSubstr("has data after"));
}

TEST(MeshDamage, OffWithOtherThanThreeNumbersALine) {
    EXPECT_NE(error_of("line.off", "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n"), "was taken");
    EXPECT_NE(error_of("short.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "was taken");
    EXPECT_THAT(error_of("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
                HasSubstr("vertex 1"));
    EXPECT_THAT(error_of("far.off", "OFF\n4 2 0\n" + off_vertices + "3 0 1 2\n3 0 1 9\n"),
                HasSubstr("face 1 names vertex 9 of 4"));
}

TEST(MeshDamage, OffPolygonsOfManyCornersAreRead) {
    std::string vertices;
    for (int i = 0; i < 10; ++i) {
        vertices += std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    }
    const auto imported =
        import_text("long.off", "OFF\n10 2 0\n" + vertices + "3 0 1 2\n10 0 1 2 3 4 5 6 7 8 9\n");
    EXPECT_EQ(mesh_of(imported).triangles().size(), 9u);
}

TEST(MeshDamage, PlyIndicesOutOfRangeInTrianglesAndPolygons) {
    EXPECT_THAT(error_of("triangle.ply", ply_header + "3 0 1 2\n3 0 1 7\n"),
                HasSubstr("face 1 names vertex 7 of 3"));
    EXPECT_THAT(error_of("polygon.ply", ply_header + "3 0 1 2\n4 0 1 2 1000000\n"),
                HasSubstr("face 1 names vertex 1000000 of 3"));
    EXPECT_NE(error_of("negative.ply", ply_header + "3 0 1 2\n3 0 1 -1\n"), "was taken");
}

TEST(MeshDamage, PlyThatEndsBeforeItsLastFace) {
    EXPECT_THAT(error_of("cut.ply", ply_header + "3 0 1 2\n"), HasSubstr("cut short"));
}

TEST(MeshDamage, ObjVerticesOfSevenNumbersAreRefused) {
    EXPECT_THAT(error_of("seven.obj", "v 0 0 0\nv 1 0 0 1 1 1 1\nv 1 1 0\nf 1 2 3\n"),
                HasSubstr("seven.obj:2"));
}

TEST(MeshDamage, ObjNumbersThatAreNotFiniteAreNamedByLine) {
    EXPECT_THAT(error_of("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"),
                HasSubstr("nan.obj:2"));
    EXPECT_THAT(error_of("big.obj", "v 0 0 0\nv 1e400 0 0\nv 0 1 0\nf 1 2 3\n"),
                HasSubstr("not finite"));
}

TEST(MeshDamage, WordsThatBeginAsNumbersAreNamedByLine) {
    const auto stl = [](const std::string& number) {
        return "solid a vertex x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
               "vertex 0 " +
               number + " 0\nendloop\nendfacet\nendsolid a\n";
    };
    const std::string cut = ply_header.substr(0, ply_header.rfind("0 1 0\n"));
    EXPECT_TRUE(import_text("good.stl", stl("+1.5e-3")));
    for (const std::string number : {"1.#QNAN", "-1.#IND00", "1d5", "1,5", "0x10"}) {
        SCOPED_TRACE(number);
        EXPECT_THAT(error_of("half.stl", stl(number)), HasSubstr("half.stl:6"));
        EXPECT_THAT(error_of("half.ply", cut + "0 1 " + number + "\n3 0 1 2\n3 0 1 2\n"),
                    HasSubstr("half.ply:12"));
    }
    EXPECT_THAT(error_of("old.off", "OFF\n3 1 0\n0 0 0\n1 0 1.#INF\n0 1 0\n3 0 1 2\n"),
                HasSubstr("old.off:4"));
    EXPECT_THAT(error_of("infinite.stl", stl("-inf")), HasSubstr("infinite.stl:6"));
    EXPECT_THAT(error_of("infinite.ply", cut + "0 1 nan\n3 0 1 2\n3 0 1 2\n"),
                HasSubstr("infinite.ply:12"));
    EXPECT_TRUE(import_text("large.stl", stl("1e39")));
}

TEST(MeshDamage, FilesCutShort) {
    EXPECT_NE(error_of("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
              "was taken");
    EXPECT_NE(error_of("cut.dae", "<?xml version=\"1.0\"?><COLLADA>"), "was taken");
    EXPECT_NE(error_of("points.ply",
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\nend_header\n0 0 0\n"),
              "was taken");
}

TEST(MeshDamage, LinesAndPointsAreSkippedAndCounted) {
    const auto imported =
        import_text("mixed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1 2\np 1\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().mesh->triangles().size(), 2u);
    EXPECT_EQ(imported.value().lines_skipped, 1u);
    EXPECT_EQ(imported.value().points_skipped, 1u);
}

TEST(MeshDamage, AReportOfNamesThatAreNoUtf8IsStillJson) {
    const auto imported = import_text("name.obj", "o a\xff\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_THAT(to_json(inspect_mesh("name.obj", imported.value())), HasSubstr("\"triangles\": 1"));
}

} // namespace cd::tests
