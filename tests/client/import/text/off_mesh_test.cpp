// Proves that an OFF file is read completely, or refused by line, vertex or face.
#include "client/import/mesh_readers.hpp"
#include "tests/client/import/import_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::size_t triangles_of(const std::string& text) {
    return mesh_of(import_text("a.off", text)).triangles().size();
}

} // namespace

TEST(OffMesh, CommentsAndColoursArePassedAndPolygonsCut) {
    EXPECT_EQ(triangles_of("# made\nOFF # plain\n4 2 0 # counts\n\n" + vertices +
                           "# faces\n4 0 1 2 3 255 0 0\n3 0 1 2 # end\n# over\n"),
              3u);
    EXPECT_EQ(triangles_of("\xef\xbb\xbfOFF 4 1\r\n" + vertices + "4 0 1 2 3"), 2u);
}

TEST(OffMesh, VerticesMayHaveNormalsColoursAndTexture) {
    EXPECT_EQ(
        triangles_of("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0 0 0 0 1\n3 0 1 2\n"),
        1u);
    EXPECT_EQ(triangles_of("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n"), 1u);
    EXPECT_EQ(triangles_of("STCNOFF\n3 1 0\n0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 2\n"), 1u);
    EXPECT_THAT(error_of("plain.off", "OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("plain.off:3: vertex 0 of 3 has more than three numbers"));
}

TEST(OffMesh, OtherKindsAreRefusedByName) {
    EXPECT_THAT(error_of("a.off", "4OFF\n3 1 0\n"), HasSubstr("'4OFF'"));
    EXPECT_THAT(error_of("a.off", "nOFF\n3\n3 1 0\n"), HasSubstr("'nOFF'"));
    EXPECT_THAT(error_of("a.off", "OFF BINARY\n3 1 0\n"), HasSubstr("binary"));
    EXPECT_THAT(error_of("a.off", "3 1 0\n"), HasSubstr("a.off:1"));
    EXPECT_THAT(error_of("a.off", "OFF\n"), HasSubstr("counts"));
}

TEST(OffMesh, CoordinatesAreTheNearestDoubles) {
    const auto imported =
        import_text("a.off", "OFF\n3 1 0\n2.675 0 0\n2675e-3 1 0\n0 1 +1.5\n3 0 1 2\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().mesh->vertices()[0].x(), 2.675);
    EXPECT_EQ(imported.value().mesh->vertices()[1].x(), 2.675);
    EXPECT_EQ(imported.value().mesh->vertices()[2].z(), 1.5);
}

TEST(OffMesh, CountsAreNotBelieved) {
    EXPECT_THAT(error_of("v.off", "OFF\n4000000000 1 0\n" + vertices),
                HasSubstr("vertex 4 of 4000000000 is missing"));
    EXPECT_THAT(error_of("f.off", "OFF\n4 9 0\n" + vertices + "3 0 1 2\n"),
                HasSubstr("face 1 of 9 is missing"));
    EXPECT_THAT(error_of("c.off", "OFF\n4 1 0\n" + vertices + "4000000000 0 1 2\n"),
                HasSubstr("c.off:7: face 0 of 1 is missing or damaged"));
    EXPECT_THAT(error_of("m.off", "OFF\n4 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n"),
                HasSubstr("m.off:8: has data after"));
}

TEST(OffMesh, DamagedVerticesAndFacesAreNamed) {
    EXPECT_THAT(error_of("short.off", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
                HasSubstr("short.off:4"));
    EXPECT_THAT(error_of("nan.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
                HasSubstr("vertex 1"));
    EXPECT_THAT(error_of("far.off", "OFF\n4 2 0\n" + vertices + "3 0 1 2\n3 0 1 9\n"),
                HasSubstr("face 1 names vertex 9 of 4"));
}

TEST(OffMesh, PointsAndLinesAreCounted) {
    const auto imported = import_text("a.off", "OFF\n4 3 0\n" + vertices + "1 0\n2 0 1\n3 0 1 2\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().points_skipped, 1u);
    EXPECT_EQ(imported.value().lines_skipped, 1u);
    EXPECT_THAT(error_of("no.off", "OFF\n4 1 0\n" + vertices + "0\n"), HasSubstr("no corners"));
}

} // namespace cd::tests
