// Proves that a PLY file, text or binary, is read completely or refused by line or byte, and that
// no count in its header is trusted.
#include "client/import/mesh_readers.hpp"
#include "tests/client/import/import_text.hpp"
#include "tests/support/memory_bound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::string positions = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "property list uchar int vertex_indices\n";
const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string elements(const std::string& vertex, const std::string& face) {
    return "element vertex 4\n" + vertex + "element face 1\n" + face;
}

std::string text(const std::string& described, const std::string& data) {
    return "ply\nformat ascii 1.0\ncomment made\n" + described + "end_header\n" + data;
}

/// Bytes of numbers in a given byte order.
class Data {
  public:
    explicit Data(bool is_big_endian) : is_big_endian_(is_big_endian) {}

    template <class T>
    Data& put(std::initializer_list<T> values) {
        for (const T value : values) {
            std::array<char, sizeof(T)> bytes;
            std::memcpy(bytes.data(), &value, sizeof(T));
            if (is_big_endian_) {
                std::reverse(bytes.begin(), bytes.end());
            }
            bytes_.append(bytes.data(), bytes.size());
        }
        return *this;
    }

    [[nodiscard]] std::string file(const std::string& described) const {
        const std::string order = is_big_endian_ ? "big" : "little";
        return "ply\nformat binary_" + order + "_endian 1.0\n" + described + "end_header\n" +
               bytes_;
    }

  private:
    bool is_big_endian_;
    std::string bytes_;
};

Data square(bool is_big_endian) {
    Data data(is_big_endian);
    data.put<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    return data;
}

} // namespace

TEST(PlyMesh, TextIsTheNearestDouble) {
    const auto imported = import_text(
        "a.ply",
        text(elements(positions, indices), "2.675 0 0\n2675e-3 1 0\n+1.5 1 0\n0 1 0\n3 0 1 2\n"));
    EXPECT_EQ(mesh_of(imported).vertices()[0].x(), 2.675);
    EXPECT_EQ(mesh_of(imported).vertices()[1].x(), 2.675);
    EXPECT_EQ(mesh_of(imported).precision(), Precision::Double);
}

TEST(PlyMesh, BinaryInBothByteOrdersAndOfAnyType) {
    for (const bool is_big_endian : {false, true}) {
        const std::string plain = square(is_big_endian)
                                      .put<std::uint8_t>({4})
                                      .put<std::int32_t>({0, 1, 2, 3})
                                      .file(elements(positions, indices));
        EXPECT_EQ(mesh_of(import_text("a.ply", plain)).triangles().size(), 2u);
        const std::string types = "property double x\nproperty short flags\nproperty uchar y\n"
                                  "property list ushort double extra\nproperty int8 z\n";
        Data odd(is_big_endian);
        for (const double x : {0.1, 1.0, 1.0, 0.0}) {
            odd.put<double>({x}).put<std::int16_t>({7}).put<std::uint8_t>({200});
            odd.put<std::uint16_t>({2}).put<double>({1, 2}).put<std::int8_t>({-3});
        }
        odd.put<std::uint32_t>({3}).put<std::uint16_t>({0, 1, 2}).put<float>({1});
        const auto imported = import_text(
            "b.ply",
            odd.file(
                elements(types, "property list uint32 ushort vertex_index\nproperty float q\n")));
        EXPECT_EQ(mesh_of(imported).vertices()[0], Vec3(0.1, 200, -3));
    }
}

TEST(PlyMesh, DataMayBeginWithALineFeed) {
    std::string file = Data(false)
                           .put<std::uint8_t>({'\n', 0, 0, 1, 2, 0, 0, 2, 1, 3, 3, 3, 3, 0, 1, 2})
                           .file(elements("property uchar x\nproperty uchar y\nproperty uchar z\n",
                                          "property list uchar uchar vertex_indices\n"));
    EXPECT_EQ(mesh_of(import_text("feed.ply", file)).vertices()[0], Vec3(10, 0, 0));
    std::string returns = file.substr(0, file.find("end_header"));
    std::replace(returns.begin(), returns.end(), '\n', '\r');
    const std::string rest = file.substr(returns.size() + 11);
    EXPECT_EQ(mesh_of(import_text("r.ply", returns + "end_header\r" + rest)).vertices()[0],
              Vec3(10, 0, 0));
}

TEST(PlyMesh, OtherElementsAndPropertiesArePassed) {
    const std::string described =
        "obj_info scan\nelement range_grid 2\nproperty list uchar int v\n" +
        elements(positions + "property list uchar float n\n",
                 "property list uchar int foo\n" + indices +
                     "property list uchar float texcoord\n") +
        "element edge 1\nproperty int v1\nproperty int v2\n";
    const std::string data = "1 5\n0\n0 0 0 1 0.5\n1 0 0 0\n1 1 0 2 nan 1\n0 1 0 0\n\n"
                             "2 8 9 3 0 1 2 6 0 0 0 0 0 0\n0 1\n";
    EXPECT_EQ(mesh_of(import_text("a.ply", text(described, data))).triangles().size(), 1u);
}

TEST(PlyMesh, TriangleStripsAreTriangles) {
    const std::string described = "element vertex 4\n" + positions +
                                  "element tristrips 1\nproperty list int int vertex_indices\n";
    const auto imported =
        import_text("a.ply", text(described, vertices + "10 0 1 2 3 -1 3 2 1 -1 0\n"));
    const Mesh& mesh = mesh_of(imported);
    ASSERT_EQ(mesh.triangles().size(), 3u);
    EXPECT_EQ(mesh.triangles()[0], (Triangle{0, 1, 2}));
    EXPECT_EQ(mesh.triangles()[1], (Triangle{2, 1, 3}));
    EXPECT_EQ(mesh.triangles()[2], (Triangle{3, 2, 1}));
    EXPECT_THAT(error_of("far.ply", text(described, vertices + "3 0 1 4\n")),
                HasSubstr("far.ply:15: tristrips 0 names vertex 4 of 4"));
}

TEST(PlyMesh, HeadersThatDescribeNoMeshAreRefused) {
    EXPECT_THAT(error_of("a.ply",
                         text(elements(positions, indices) + "element face 1\n" + indices,
                              vertices + "3 0 1 2\n3 0 1 2\n")),
                HasSubstr("two elements 'face'"));
    EXPECT_THAT(error_of("a.ply",
                         text(elements("property float x\nproperty float y\n", indices),
                              "0 0\n1 0\n1 1\n0 1\n3 0 1 2\n")),
                HasSubstr("one property z"));
    EXPECT_THAT(error_of("a.ply", text(elements(positions + "property float x\n", indices), "")),
                HasSubstr("one property x"));
    EXPECT_THAT(error_of("a.ply", text(elements(positions, "property list uchar int i\n"), "")),
                HasSubstr("vertex_indices"));
    EXPECT_THAT(error_of("a.ply",
                         text(elements(positions, "property list uchar float vertex_index\n"), "")),
                HasSubstr("whole numbers"));
    EXPECT_THAT(error_of("a.ply", text("element face 0\n" + indices, "")), HasSubstr("before"));
    EXPECT_THAT(error_of("a.ply", text("element vertex 4\n" + positions, vertices)),
                HasSubstr("no triangles"));
}

TEST(PlyMesh, HeadersThatAreCutOrMisspeltAreRefused) {
    EXPECT_THAT(error_of("cut.ply", "ply\nformat ascii 1.0"), HasSubstr("end_header"));
    EXPECT_THAT(error_of("cut.ply", "ply\n"), HasSubstr("end_header"));
    EXPECT_THAT(error_of("a.ply", "plx\n"), HasSubstr("first line"));
    std::string misspelt = text(elements(positions, indices), vertices + "3 0 1 2\n");
    misspelt.replace(misspelt.find("end_header"), 10, "end_haeder");
    EXPECT_THAT(error_of("a.ply", misspelt), HasSubstr("a.ply:10: 'end_haeder'"));
    for (const std::string line : {"format ascii 2.0",
                                   "format utf8 1.0",
                                   "element vertex",
                                   "element vertex -1",
                                   "property float",
                                   "property list float int i",
                                   "property half h"}) {
        EXPECT_THAT(error_of("a.ply", "ply\nelement a 1\n" + line + "\nend_header\n"),
                    HasSubstr("a.ply:3"))
            << line;
    }
    EXPECT_THAT(error_of("a.ply", "ply\nproperty int x\n"), HasSubstr("a.ply:2"));
    EXPECT_THAT(error_of("a.ply", "ply\nend_header\n"), HasSubstr("no format"));
}

TEST(PlyMesh, DataThatDoNotFitTheHeaderAreRefusedByPlace) {
    const std::string described = elements(positions, indices);
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "3 0 1 7\n")),
                HasSubstr("a.ply:15: face 0 names vertex 7 of 4"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "4 0 1 2 1000000\n")),
                HasSubstr("face 0 names vertex 1000000 of 4"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices)), HasSubstr("cut short"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "3 0 1\n")),
                HasSubstr("fewer numbers"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "3 0 1 1.5\n")), HasSubstr("'1.5'"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "3 0 1 2 3\n")),
                HasSubstr("more numbers"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "-3 0 1 2\n")), HasSubstr("face 0"));
    EXPECT_THAT(error_of("a.ply", text(described, vertices + "3 0 1 2\n3 0 1 2\n")),
                HasSubstr("a.ply:16: has data after"));
    EXPECT_THAT(error_of("a.ply", text(described, "0 0 nan\n" + vertices + "3 0 1 2\n")),
                HasSubstr("a.ply:11: vertex 0 has a coordinate that is not finite"));
    EXPECT_THAT(error_of("a.ply", text(described, "0 0 0x1\n" + vertices + "3 0 1 2\n")),
                HasSubstr("a.ply:11"));
    const std::string whole =
        square(false).put<std::uint8_t>({3}).put<std::int32_t>({0, 1, 2}).file(described);
    EXPECT_TRUE(import_text("a.ply", whole));
    EXPECT_TRUE(import_text("a.ply", whole + std::string(100, '\0') + "\n"));
    EXPECT_THAT(error_of("a.ply", whole + "x"), HasSubstr("has data after"));
    EXPECT_THAT(error_of("a.ply", whole.substr(0, whole.size() - 1)), HasSubstr("cut short"));
    const std::string far =
        square(false).put<std::uint8_t>({3}).put<std::int32_t>({0, 1, -1}).file(described);
    EXPECT_THAT(error_of("a.ply", far), HasSubstr("face 0 names vertex -1 of 4 (byte "));
}

TEST(PlyMesh, CountsAreNotBelieved) {
    const MemoryBound bound(64u << 20);
    const std::string positions_of_many = "element vertex 40000000\n" + positions;
    for (const std::string& face : {"element face 1\n" + indices, std::string()}) {
        EXPECT_THAT(error_of("a.ply", square(false).file(positions_of_many + face)),
                    HasSubstr("its header counts 40000000 of 'vertex'"));
        EXPECT_THAT(error_of("a.ply", text(positions_of_many + face, vertices)),
                    HasSubstr("its header counts 40000000 of 'vertex'"));
    }
    const std::string longest =
        square(false)
            .put<std::uint32_t>({4'000'000'000})
            .put<std::int32_t>({0, 1, 2})
            .file(elements(positions, "property list uint int vertex_index\n"));
    EXPECT_THAT(error_of("a.ply", longest), HasSubstr("cut short"));
    const std::string empty = "element nothing 18446744073709551615\n";
    EXPECT_TRUE(
        import_text("a.ply", text(empty + elements(positions, indices), vertices + "3 0 1 2\n")));
}

} // namespace cd::tests
