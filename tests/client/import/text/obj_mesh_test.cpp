// Proves that the polygons of an OBJ file are read completely, or refused by line.
#include "client/import/mesh_readers.hpp"
#include "tests/client/import/import_text.hpp"
#include "tests/support/memory_bound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::size_t triangles_of(const std::string& text) {
    return mesh_of(import_text("a.obj", text)).triangles().size();
}

std::vector<std::string> parts_of(const std::string& text) {
    const auto imported = import_text("a.obj", text);
    std::vector<std::string> names;
    for (const Part& part : mesh_of(imported).parts()) {
        names.push_back(part.name + " " +
                        std::to_string(part.triangles_end - part.triangles_begin));
    }
    return names;
}

} // namespace

TEST(ObjMesh, LinesMayBeginWithBlanksAndTheFileWithAMark) {
    EXPECT_EQ(
        triangles_of("\xef\xbb\xbfv 0 0 0\n  v 1 0 0\n\tv 1 1 0\nv 0 1 0\n  f 1 2 3\nf 1 3 4"), 2u);
}

TEST(ObjMesh, LinesMayEndAnyhowAndBeJoined) {
    EXPECT_EQ(triangles_of("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n"), 1u);
    EXPECT_EQ(triangles_of("v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r"), 1u);
    EXPECT_EQ(triangles_of("v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 1 1 0\nf 1 2\\\n 3\n"), 1u);
    EXPECT_THAT(error_of("joined.obj", square + "# C:\\cars\\\nf 1 2 3\n"),
                HasSubstr("joined.obj:5: a comment or name that ends with a backslash"));
}

TEST(ObjMesh, CornersCountFromTheBeginningOrBackAndMayNameMore) {
    const auto imported = import_text(
        "a.obj", square + "vn 0 0 1\nvt 0 0\nf -4//1 -3/1 -2/1/1\nf 1 3 4 # the other\n");
    const Mesh& mesh = mesh_of(imported);
    ASSERT_EQ(mesh.triangles().size(), 2u);
    EXPECT_EQ(mesh.corners(0)[0], Vec3(0, 0, 0));
    EXPECT_EQ(mesh.corners(0)[2], Vec3(1, 1, 0));
    EXPECT_EQ(mesh.corners(1)[2], Vec3(0, 1, 0));
    for (const std::string face : {"f 1 2 5",
                                   "f 0 1 2",
                                   "f -5 1 2",
                                   "f 1 2 x",
                                   "f 1 2 3x",
                                   "f",
                                   "f 1 2 99999999999999999999"}) {
        EXPECT_THAT(error_of("far.obj", square + face + "\n"), HasSubstr("far.obj:5")) << face;
    }
}

TEST(ObjMesh, CoordinatesAreTheNearestDoubles) {
    const auto imported =
        import_text("a.obj", "v 2.675 .25 5.\nv 2675e-3 0 0\nv 0 1e-3 0\nf 1 2 3\n");
    const Mesh& mesh = mesh_of(imported);
    EXPECT_EQ(mesh.vertices()[0], Vec3(2.675, 0.25, 5));
    EXPECT_EQ(mesh.vertices()[1].x(), 2.675);
    EXPECT_EQ(mesh.precision(), Precision::Double);
    EXPECT_EQ(mesh_of(import_text("f.obj", square + "f 1 2 3")).precision(), Precision::Float);
}

TEST(ObjMesh, AVertexMayHaveAWeightOfOneOrAColour) {
    EXPECT_EQ(triangles_of("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nf 1 2 3\n"), 1u);
    EXPECT_THAT(error_of("w.obj", "v 0 0 0 2\n"), HasSubstr("w.obj:1"));
    EXPECT_THAT(error_of("two.obj", "v 0 0\n"), HasSubstr("a vertex of 2 numbers"));
    EXPECT_THAT(error_of("seven.obj", "v 1 0 0 1 1 1 1\n"), HasSubstr("a vertex of 7 numbers"));
    EXPECT_THAT(error_of("x.obj", "v 0 0 x\n"), HasSubstr("'x' is not a number"));
    EXPECT_THAT(error_of("inf.obj", "v 0 0 0\nv 0 0 inf\n"), HasSubstr("inf.obj:2"));
}

TEST(ObjMesh, NamesKeepTheirBlanks) {
    EXPECT_THAT(
        parts_of(square + "o front wheel\nf 1 2 3\no front door \nf 1 3 4\ng  a b\nf 1 2 4\n"),
        ElementsAre("front wheel 1", "front door 1", "a b 1"));
}

TEST(ObjMesh, ObjectsGroupsAndMaterialsBeginParts) {
    EXPECT_THAT(parts_of(square + "f 1 2 3\n"), ElementsAre("defaultobject 1"));
    EXPECT_THAT(parts_of(square + "o car\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\nusemtl blue\n"
                                  "f 1 2 4\n"),
                ElementsAre("car 1", "blue 2"));
    EXPECT_THAT(parts_of(square + "g body\nusemtl red\nf 1 2 3\ng body\nf 1 3 4\nusemtl blue\n"
                                  "f 1 2 4\ng\nf 2 3 4\n"),
                ElementsAre("body 2", "body#2 1", "mesh 1"));
    EXPECT_THAT(parts_of(square + "o a\nf 1 2 3\no b\nf 1 3 4\no a\nf 1 2 4\no empty\n"),
                ElementsAre("a 1", "b 1", "a#2 1"));
}

TEST(ObjMesh, PointsAndLinesAreCounted) {
    const auto imported = import_text("a.obj", square + "p 1 2\nl 1 2 3\nf 1 2\nf 1\nf 1 2 3\n");
    EXPECT_EQ(mesh_of(imported).triangles().size(), 1u);
    EXPECT_EQ(imported.value().points_skipped, 3u);
    EXPECT_EQ(imported.value().lines_skipped, 3u);
    EXPECT_THAT(error_of("far.obj", square + "l 1 9\nf 1 2 3\n"), HasSubstr("far.obj:5"));
}

TEST(ObjMesh, StatementsThatAreNotReadAreRefusedByName) {
    for (const std::string keyword : {"surf", "call", "curv", "parm", "end", "cstype", "F", "V"}) {
        EXPECT_THAT(error_of("odd.obj", square + keyword + " 1 2 3\nf 1 2 3\n"),
                    HasSubstr("odd.obj:5: '" + keyword + "'"));
    }
    EXPECT_EQ(triangles_of("mtllib a b.mtl\ns off\nmg 1 2\nvp 1\n" + square + "f 1 2 3\n"), 1u);
}

TEST(ObjMesh, PolygonsAreCutOrRefusedByLine) {
    EXPECT_EQ(triangles_of(square + "f 1 2 3 4\n"), 2u);
    EXPECT_THAT(error_of("tie.obj", square + "f 1 3 2 4\n"),
                HasSubstr("tie.obj:5: the face is a polygon of 4 corners that cannot be cut"));
}

TEST(ObjMesh, ManyPartsOfOneNameAreNumbered) {
    std::string text = square;
    for (int i = 0; i < 20'000; ++i) {
        text += "g a\nf 1 2 3\ng b\nf 1 3 4\n";
    }
    const auto imported = import_text("many.obj", text);
    EXPECT_EQ(mesh_of(imported).parts().back().name, "b#20000");
}

TEST(ObjMesh, TooLittleMemoryNamesTheFile) {
    if (!MemoryBound::is_enforced) {
        GTEST_SKIP() << "memory cannot be bounded under sanitizers";
    }
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 4'000'000; ++i) {
        text += "v 0 0 0\n";
    }
    write_text(folder / "large.obj", text + "f 1 2 3\n");
    const MemoryBound bound(text.size() + (32u << 20)); // The file, and a third of its vertices.
    const auto imported = import_mesh(folder / "large.obj", {});
    ASSERT_FALSE(imported);
    EXPECT_EQ(imported.error().detail,
              (folder / "large.obj").string() + ": too little memory to read it");
}

} // namespace cd::tests
