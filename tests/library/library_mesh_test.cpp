// Proves that meshes of the library are those of the engine, and that wrong arrays are refused.
#include "tests/library/bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::vector<double> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::uint32_t> faces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

} // namespace

TEST(LibraryMesh, KeepsArraysAndPartsAndHasTheIdentityOfItsBytes) {
    const std::vector<cdcluster::Part> parts{{"base", 0, 1}, {"sides", 1, 4}};
    const auto mesh = cdcluster::Mesh::from_arrays(corners, faces, parts);
    EXPECT_EQ(mesh.vertex_count(), 4u);
    EXPECT_EQ(mesh.triangle_count(), 4u);
    EXPECT_TRUE(mesh.is_closed());
    EXPECT_EQ(std::vector<double>(mesh.xyz().begin(), mesh.xyz().end()), corners);
    EXPECT_EQ(std::vector<std::uint32_t>(mesh.triangles().begin(), mesh.triangles().end()), faces);
    ASSERT_EQ(mesh.parts().size(), 2u);
    EXPECT_EQ(mesh.parts()[1].name, "sides");
    EXPECT_EQ(mesh.parts()[1].end, 4u);
    const auto bytes = mesh.canonical_bytes();
    const auto again = cdcluster::Mesh::from_canonical_bytes(bytes);
    EXPECT_EQ(again.sha256(), mesh.sha256());
    EXPECT_EQ(again.sha256(), to_hex(sha256(bytes)));
    EXPECT_FALSE(cdcluster::Mesh::from_arrays(corners, std::span(faces).first(9)).is_closed());
}

TEST(LibraryMesh, ReadsFilesAsThePrograms) {
    const TemporaryFolder folder;
    write_text(folder / "b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n");
    const auto mesh = cdcluster::Mesh::load(folder / "b.obj", 2);
    EXPECT_EQ(mesh.triangle_count(), 2u);
    EXPECT_EQ(mesh.xyz()[3], 0.0);
    EXPECT_EQ(mesh.xyz()[4], 2.0); // The second vertex is the file's third.
    EXPECT_THAT(error_of([&] { return cdcluster::Mesh::load(folder / "no.obj"); }),
                HasSubstr("no.obj"));
    write_text(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    EXPECT_THAT(error_of([&] { return cdcluster::Mesh::load(folder / "bad.obj"); }),
                HasSubstr("bad.obj:2"));
    EXPECT_THAT(error_of([&] { return cdcluster::Mesh::load(folder / "b.obj", -1); }),
                HasSubstr("factor"));
}

TEST(LibraryMesh, RefusesWrongArrays) {
    const auto made = [&](std::vector<double> xyz, std::vector<std::uint32_t> triangles) {
        return error_of([&] { return cdcluster::Mesh::from_arrays(xyz, triangles); });
    };
    EXPECT_THAT(made({0, 0}, faces), HasSubstr("xyz have 2 numbers"));
    EXPECT_THAT(made(corners, {0, 1}), HasSubstr("triangles have 2 numbers"));
    EXPECT_THAT(made(corners, {0, 1, 9}), HasSubstr("triangle 0"));
    EXPECT_THAT(made(corners, {}), HasSubstr("triangle"));
    std::vector<double> bad = corners;
    bad[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(made(bad, faces), HasSubstr("vertex 1"));
    EXPECT_FALSE(error_of([] {
                     return cdcluster::Mesh::from_canonical_bytes(std::vector<std::byte>(7));
                 }).empty());
    auto moved = cdcluster::Mesh::from_arrays(corners, faces);
    const auto taken = std::move(moved);
    EXPECT_THAT(error_of([&] { return moved.triangle_count(); }), HasSubstr("moved from"));
    EXPECT_EQ(taken.triangle_count(), 4u);
}

} // namespace cd::tests
