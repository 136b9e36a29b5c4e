// Proves that an STL file, text or binary, is read completely, each coordinate as the double
// nearest to its text, or refused by line or facet.
#include "client/import/mesh_readers.hpp"
#include "tests/client/import/import_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

std::string facet(const std::string& third = "0 1 0") {
    return "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex " + third +
           "\nendloop\nendfacet\n";
}

std::string solid(const std::string& facets, const std::string& name = "a") {
    return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

/// Makes a binary file of so many facets, the last corner at `last`.
std::string binary(std::uint32_t counted,
                   std::uint32_t facets,
                   const std::string& header = "made",
                   float last = 1) {
    std::string bytes = header;
    bytes.resize(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&counted), 4);
    const std::array<float, 12> values{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, last, 0};
    for (std::uint32_t i = 0; i < facets; ++i) {
        bytes.append(reinterpret_cast<const char*>(values.data()), sizeof values);
        bytes.append(2, '\0');
    }
    return bytes;
}

} // namespace

TEST(StlMesh, TextIsTheNearestDoubleHoweverItIsSpelled) {
    for (const std::string text : {"2.675", "2675e-3", "+2.675", "0.2675E+1", "267.5e-2"}) {
        const auto imported = import_text("a.stl", solid(facet("0 1 " + text)));
        EXPECT_EQ(mesh_of(imported).corners(0)[2].z(), 2.675) << text;
        EXPECT_EQ(mesh_of(imported).precision(), Precision::Double);
    }
    const auto digits = import_text("a.stl", solid(facet("0 1 123456789012345678901234567890.5")));
    EXPECT_EQ(mesh_of(digits).corners(0)[2].z(), 123456789012345678901234567890.5);
    EXPECT_EQ(mesh_of(import_text("a.stl", solid(facet("0 1 0.5")))).precision(), Precision::Float);
}

TEST(StlMesh, SolidsArePartsAndTextBetweenThemIsPassed) {
    const auto imported =
        import_text("two.stl",
                    "\xef\xbb\xbf" + solid(facet() + facet(), "front wheel") + "made by hand\n\n" +
                        solid(facet(), "front door") + "that was all\n");
    const Mesh& mesh = mesh_of(imported);
    ASSERT_EQ(mesh.parts().size(), 2u);
    EXPECT_EQ(mesh.parts()[0], (Part{"front wheel", 0, 2}));
    EXPECT_EQ(mesh.parts()[1], (Part{"front door", 2, 3}));
}

TEST(StlMesh, KeywordsMayBeInUpperCaseAndLinesMayEndAnyhow) {
    std::string upper = "Solid a\r\n" + facet() + "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\n" +
                        "VERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nEndSolid\n";
    EXPECT_EQ(mesh_of(import_text("upper.stl", upper)).triangles().size(), 2u);
    std::string returns = solid(facet());
    std::replace(returns.begin(), returns.end(), '\n', '\r');
    EXPECT_EQ(mesh_of(import_text("returns.stl", returns)).triangles().size(), 1u);
    std::string one_line = solid(facet() + facet());
    std::replace(one_line.begin(), one_line.end(), '\n', ' ');
    const auto imported = import_text("line.stl", one_line);
    EXPECT_EQ(mesh_of(imported).triangles().size(), 2u);
    EXPECT_EQ(mesh_of(imported).parts()[0].name, "a");
}

TEST(StlMesh, NormalsAreNotRead) {
    std::string text = solid(facet());
    text.replace(text.find("0 0 1"), 5, "nan -nan(ind) x");
    EXPECT_EQ(mesh_of(import_text("normal.stl", text)).triangles().size(), 1u);
}

TEST(StlMesh, TextThatIsNoFacetIsRefusedByLine) {
    EXPECT_THAT(error_of("four.stl", solid(facet("0 1 0\nvertex 1 1 0"))), HasSubstr("four.stl:7"));
    EXPECT_THAT(error_of("two.stl", solid(facet("0 1 0").erase(40, 13))),
                HasSubstr("two.stl:6: a facet without three"));
    EXPECT_THAT(error_of("outside.stl", solid(facet()) + facet()), HasSubstr("outside.stl:10"));
    EXPECT_THAT(error_of("same.stl", "solid a\nendsolid a " + facet()), HasSubstr("outside"));
    EXPECT_THAT(error_of("word.stl", solid("fact\n" + facet())), HasSubstr("word.stl:2: 'fact'"));
    EXPECT_THAT(error_of("cut.stl", "solid a\n" + facet()), HasSubstr("without 'endsolid'"));
    EXPECT_THAT(error_of("nested.stl", "solid a\n" + facet() + solid(facet())),
                HasSubstr("nested.stl:9"));
    EXPECT_THAT(error_of("normal.stl", solid("facet\n" + facet())), HasSubstr("outer loop"));
}

TEST(StlMesh, InvalidAndInfiniteNumbersAreRefusedByLine) {
    for (const std::string number : {"0x10", "1d5", "1,5", "1.#QNAN", "+-1", "e5", "1e"}) {
        EXPECT_THAT(error_of("half.stl", solid(facet("0 1 " + number))), HasSubstr("half.stl:6"))
            << number;
    }
    EXPECT_THAT(error_of("cut.stl", solid(facet("0 1"))), HasSubstr("cut.stl:7: "));
    for (const std::string number : {"nan", "inf", "-Infinity", "1e400"}) {
        EXPECT_THAT(error_of("nan.stl", solid(facet("0 1 " + number))),
                    HasSubstr("nan.stl:6: a vertex with a coordinate that is not finite"))
            << number;
    }
    EXPECT_EQ(mesh_of(import_text("small.stl", solid(facet("0 1 1e-400")))).corners(0)[2].z(), 0);
}

TEST(StlMesh, BinaryMayBeginWithSolid) {
    const auto imported = import_text("solid.stl", binary(3, 3, "solid made"));
    EXPECT_EQ(mesh_of(imported).triangles().size(), 3u);
    EXPECT_EQ(mesh_of(imported).precision(), Precision::Float);
    EXPECT_TRUE(imported.value().warnings.empty());
}

TEST(StlMesh, BinaryMayHaveBytesBehindItsFacets) {
    for (const std::string& after : {std::string("end"), std::string(512, '\0')}) {
        for (const std::string header : {"made", "solid made"}) {
            const auto imported = import_text("after.stl", binary(2, 2, header) + after);
            EXPECT_EQ(mesh_of(imported).triangles().size(), 2u);
            ASSERT_EQ(imported.value().warnings.size(), 1u);
            EXPECT_THAT(imported.value().warnings[0],
                        HasSubstr(std::to_string(after.size()) + " bytes after the 2 facets"));
        }
    }
    EXPECT_THAT(error_of("more.stl", binary(2, 3)), HasSubstr("50 bytes after the 2 facets"));
}

TEST(StlMesh, BinaryThatIsCutOrDamagedIsRefused) {
    EXPECT_THAT(error_of("cut.stl", binary(4'000'000'000, 2)),
                HasSubstr("counts 4000000000 facets and holds 2"));
    EXPECT_THAT(error_of("nan.stl", binary(1, 1, "made", std::numeric_limits<float>::infinity())),
                HasSubstr("facet 0 (byte 84)"));
    EXPECT_THAT(error_of("none.stl", binary(0, 0)), HasSubstr("no triangles"));
    EXPECT_THAT(error_of("short.stl", "made"), HasSubstr("is no STL file"));
}

} // namespace cd::tests
