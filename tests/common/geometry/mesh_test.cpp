// Proves that every existing mesh is valid, that its canonical bytes depend only on its content and
// restore an equal mesh, and that no bytes make an invalid mesh.
#include "common/geometry/mesh.hpp"

#include "tests/support/damage.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

MeshArrays arrays() {
    MeshArrays made;
    made.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    made.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 1, 1}};
    made.parts = {{"hull", 0, 2}, {"point", 2, 3}};
    return made;
}

void expect_refused(MeshArrays given, const std::string& word) {
    const auto mesh = Mesh::create(std::move(given));
    ASSERT_FALSE(mesh.has_value()) << word;
    EXPECT_EQ(mesh.error().code, ErrorCode::BadInput);
    EXPECT_NE(mesh.error().detail.find(word), std::string::npos) << mesh.error().detail;
}

} // namespace

TEST(Mesh, KeepsWhatItWasGiven) {
    const auto mesh = Mesh::create(arrays());
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(mesh.value().triangles(), arrays().triangles); // Including the degenerate one.
    EXPECT_EQ(mesh.value().parts(), arrays().parts);
    EXPECT_EQ(mesh.value().corners(1)[2], Vec3(0, 0, 1));
}

TEST(Mesh, NamesWhatIsWrong) {
    MeshArrays bad = arrays();
    bad.triangles.clear();
    bad.parts.clear();
    expect_refused(bad, "no triangles");

    bad = arrays();
    bad.triangles[1][2] = 4;
    expect_refused(bad, "triangle 1");

    bad = arrays();
    bad.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    expect_refused(bad, "vertex 3");
    bad.vertices[3].y() = -std::numeric_limits<double>::infinity();
    expect_refused(bad, "vertex 3");

    bad = arrays();
    bad.precision = Precision::Float;
    bad.vertices[2].x() = 0.1;
    expect_refused(bad, "vertex 2");

    bad = arrays();
    bad.parts[1].triangles_end = 4;
    expect_refused(bad, "'point'");
    bad.parts[1] = {"point", 1, 3};
    expect_refused(bad, "'point'");
}

TEST(Mesh, CanonicalBytesComeBackAsTheSameMesh) {
    for (const Precision precision : {Precision::Double, Precision::Float}) {
        MeshArrays given = arrays();
        given.precision = precision;
        given.vertices[1].x() = precision == Precision::Double ? 0.1 : 0.5;
        const Mesh mesh = std::move(Mesh::create(given).value());
        const auto again = Mesh::from_canonical_bytes(mesh.canonical_bytes());

        ASSERT_TRUE(again.has_value());
        EXPECT_EQ(again.value().vertices(), mesh.vertices());
        EXPECT_EQ(again.value().triangles(), mesh.triangles());
        EXPECT_EQ(again.value().parts(), mesh.parts());
        EXPECT_EQ(again.value().precision(), precision);
        EXPECT_EQ(again.value().hash(), mesh.hash());
        EXPECT_EQ(mesh.hash(), sha256(mesh.canonical_bytes()));
    }
}

TEST(Mesh, HashTellsMeshesApartByContentAlone) {
    const Mesh mesh = std::move(Mesh::create(arrays()).value());
    MeshArrays other = arrays();
    other.vertices[0].x() = -0.0;
    EXPECT_EQ(Mesh::create(other).value().hash(), mesh.hash()); // The two are equal numbers.
    other.vertices[0].x() = 0x1p-1074;
    EXPECT_NE(Mesh::create(other).value().hash(), mesh.hash());
    other = arrays();
    other.parts[0].name = "hulk";
    EXPECT_NE(Mesh::create(other).value().hash(), mesh.hash());
    other = arrays();
    other.precision = Precision::Float;
    EXPECT_NE(Mesh::create(other).value().hash(), mesh.hash());
}

TEST(Mesh, BytesCutShortOrTooLongAreRefused) {
    expect_no_other_length(Mesh::create(arrays()).value().canonical_bytes(), [](auto bytes) {
        return Mesh::from_canonical_bytes(bytes).has_value();
    });
}

TEST(Mesh, DamagedBytesMakeAnErrorOrAValidMesh) {
    const Bytes bytes = Mesh::create(arrays()).value().canonical_bytes();
    std::size_t refused = 0;
    std::mt19937_64 random(1);
    for (std::size_t place = 0; place < bytes.size(); ++place) {
        for (int round = 0; round < 8; ++round) {
            Bytes damaged = bytes;
            damaged[place] ^= static_cast<std::byte>(1 + random() % 255);
            const auto mesh = Mesh::from_canonical_bytes(damaged);
            if (!mesh) {
                ++refused;
                continue;
            }
            for (const Vec3& vertex : mesh.value().vertices()) {
                ASSERT_TRUE(vertex.allFinite());
            }
            for (const Triangle& triangle : mesh.value().triangles()) {
                for (const std::uint32_t vertex : triangle) {
                    ASSERT_LT(vertex, mesh.value().vertices().size());
                }
            }
        }
    }
    EXPECT_GT(refused, 100u);
}

TEST(Mesh, CountsWithoutTheBytesToMatchAreRefused) {
    // The header of a mesh that claims 2^31 vertices and triangles, and nothing after it.
    ByteWriter out;
    const Bytes bytes = Mesh::create(arrays()).value().canonical_bytes();
    for (std::size_t i = 0; i < 9; ++i) {
        out.put(std::to_integer<std::uint8_t>(bytes[i])); // Magic number and precision.
    }
    out.put(std::uint64_t{1} << 31);
    out.put(std::uint64_t{1} << 31);
    out.put(std::uint32_t{0});
    EXPECT_FALSE(Mesh::from_canonical_bytes(out.bytes()).has_value());

    Bytes wraps = bytes;
    for (std::size_t i = 9; i < 25; ++i) {
        wraps[i] = std::byte{0xff}; // Counts whose product with the size of a vertex wraps around.
    }
    EXPECT_FALSE(Mesh::from_canonical_bytes(wraps).has_value());
}

} // namespace cd::tests
