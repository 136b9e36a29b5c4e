// Proves that an AC3D file is read exactly or refused by line: partly readable numbers, indices out
// of range, misplaced lines, unbounded counts and depths.
#include "client/import/foreign/ac3d_text.hpp"

#include "tests/client/import/import_text.hpp"

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::string head = "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 1 1 1  emis 0 0 0  spec 0 0 0  shi 0"
                         "  trans 0\nOBJECT world\nkids 1\n";
/// Starts at line 5; the vertices are on lines 8 to 10, the corners on 15 to 17.
const std::string body = "OBJECT poly\nname \"a\"\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\n"
                         "SURF 0x10\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";

/// Returns the triangle with one part of its text replaced.
std::string with(const std::string& part, const std::string& other) {
    std::string text = head + body;
    const std::size_t at = text.rfind(part);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, part.size(), other);
}

std::string with_line_ends(const std::string& end) {
    std::string text;
    for (const char c : head + body) {
        text += c == '\n' ? end : std::string(1, c);
    }
    return text;
}

} // namespace

TEST(Ac3dText, WhatIsSoundIsTaken) {
    for (const std::string& text : {head + body,
                                    "\xef\xbb\xbf" + head + body,
                                    with_line_ends("\r\n"),
                                    with_line_ends("\r"),
                                    with_line_ends("\n\n"),
                                    with("numvert", "loc 1 -2 3e1\nrot 1 0 0 0 1 0 0 0 1\nnumvert"),
                                    with("0 1 0\nnumsurf", "+1. -.5 1e-3 0 0 1\nnumsurf"),
                                    with("SURF 0x10\n", ""),
                                    with("0x10", "0x17")}) {
        const auto imported = import_text("good.ac", text);
        ASSERT_TRUE(imported) << imported.error().detail;
        EXPECT_EQ(imported.value().mesh->triangles().size(), 1u);
        EXPECT_EQ(imported.value().mesh->vertices().size(), 3u);
    }
}

TEST(Ac3dText, LinesAndStripsAreCountedAsTheImporterTakesThem) {
    const std::string four = "refs 4\n0 0 0\n1 0 0\n2 0 0\n0 0 0\nkids 0\n";
    const std::string three = body.substr(body.find("refs 3"));
    const auto strip = import_text("strip.ac", with("0x10\nmat 0\n" + three, "0x14\n" + four));
    ASSERT_TRUE(strip) << strip.error().detail;
    EXPECT_EQ(strip.value().mesh->triangles().size(), 2u);
    const auto line = import_text(
        "line.ac",
        with("numsurf 1\n", "numsurf 2\nSURF 0x12\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\n"));
    ASSERT_TRUE(line) << line.error().detail;
    EXPECT_EQ(line.value().mesh->triangles().size(), 1u);
    EXPECT_EQ(line.value().lines_skipped, 2u);
}

TEST(Ac3dText, NumbersReadHalfwayAreNamedByLine) {
    for (const std::string number : {"1d5", "0x10", "1,5", "1.#QNAN", "five", ""}) {
        SCOPED_TRACE(number);
        EXPECT_THAT(error_of("half.ac", with("0 1 0\nnum", "0 1 " + number + "\nnum")),
                    HasSubstr("half.ac:10"));
        EXPECT_THAT(error_of("half.ac", with("numvert", "loc 1 2 " + number + "\nnumvert")),
                    HasSubstr("half.ac:7"));
        EXPECT_THAT(
            error_of("half.ac",
                     with("numvert", "rot 1 0 0 0 1 0 " + number + " 0 " + number + "\nnumvert")),
            HasSubstr("half.ac:7"));
    }
}

TEST(Ac3dText, VerticesThatTheImporterTakesForTheListsEndAreNamedByLine) {
    for (const std::string line : {".5 1 0", "nan 1 0", "inf 1 0", "x", "  ", "numsurf 1"}) {
        SCOPED_TRACE(line);
        EXPECT_THAT(error_of("end.ac", with("0 1 0\nnum", line + "\nnum")), HasSubstr("end.ac:10"));
    }
    EXPECT_THAT(error_of("inside.ac", with("0 1 0\nnum", "0 nan 0\nnum")), HasSubstr("face 0"));
    EXPECT_THAT(error_of("large.ac", with("0 1 0\nnum", "1e39 1 0\nnum")), HasSubstr("face 0"));
}

TEST(Ac3dText, IndicesThatNameNoVertexAreNamedByLine) {
    for (const std::string index : {"3", "-1", "2d", "1.5", "4294967296", "99999999999999999999"}) {
        SCOPED_TRACE(index);
        EXPECT_THAT(error_of("far.ac", with("2 0 0\nkids", index + " 0 0\nkids")),
                    HasSubstr("far.ac:17: the surface names vertex '" + index + "' of 3"));
    }
    EXPECT_THAT(error_of("few.ac", with("numvert 3", "numvert 2")), HasSubstr("few.ac:17"));
    EXPECT_THAT(error_of("blank.ac", with("2 0 0\nkids", " \nkids")), HasSubstr("blank.ac:17"));
}

TEST(Ac3dText, CountsAreWholeNumbersOfWhatTheFileHas) {
    for (const std::string count : {"1d", "0x1", "-1", "4000000000", ""}) {
        SCOPED_TRACE(count);
        EXPECT_THAT(error_of("count.ac", with("numvert 3", "numvert " + count)),
                    HasSubstr("count.ac:7"));
        EXPECT_THAT(error_of("count.ac", with("numsurf 1", "numsurf " + count)),
                    HasSubstr("count.ac:11"));
        EXPECT_THAT(error_of("count.ac", with("refs 3", "refs " + count)),
                    HasSubstr("count.ac:14"));
        EXPECT_THAT(error_of("count.ac", with("kids 0", "kids " + count)),
                    HasSubstr("count.ac:18"));
    }
    EXPECT_THAT(error_of("more.ac", with("numvert 3", "numvert 4")), HasSubstr("more.ac:11"));
    EXPECT_THAT(error_of("cut.ac", head + body.substr(0, body.find("1 0 0"))),
                HasSubstr("ends before its vertices"));
    EXPECT_THAT(error_of("less.ac", with("kids 0", body.substr(body.find("SURF")))),
                HasSubstr("make 2 triangles, but the importer took 1"));
}

TEST(Ac3dText, SurfacesOfTooFewCornersAreRefused) {
    const std::string corners =
        body.substr(body.find("refs 3"), body.find("kids") - body.find("refs"));
    EXPECT_THAT(error_of("none.ac", with(corners, "refs 0\n")), HasSubstr("none.ac:14"));
    EXPECT_THAT(error_of("open.ac", with("0x10\nmat 0\n" + corners, "0x12\nmat 0\n")),
                HasSubstr("has no corners"));
    EXPECT_THAT(
        error_of("strip.ac", with("0x10\nmat 0\n" + corners, "0x14\nmat 0\nrefs 1\n0 0 0\n")),
        HasSubstr("strip.ac:14"));
    EXPECT_THAT(error_of("flags.ac", with("0x10", "0xg")), HasSubstr("flags.ac:12"));
}

TEST(Ac3dText, ObjectsOutOfPlaceAreNamedByLine) {
    // The importer would add the second object's vertices to the first.
    EXPECT_THAT(error_of("open.ac", head + body.substr(0, body.find("kids")) + body),
                HasSubstr("open.ac:18: 'OBJECT' before"));
    // The importer would omit the transforms of enclosing objects.
    EXPECT_THAT(error_of("far.ac", head + "crease 45\n" + body), HasSubstr("far.ac:5: 'OBJECT'"));
}

TEST(Ac3dText, NestingAndSubdivisionHaveABound) {
    std::string deep = head;
    for (int i = 0; i < 100'000; ++i) {
        deep += "OBJECT group\nkids 1\n";
    }
    EXPECT_THAT(error_of("deep.ac", deep + body), HasSubstr("nested more than"));
    std::string nested = head;
    for (int i = 0; i < 900; ++i) {
        nested += "OBJECT group\nkids 1\n";
    }
    EXPECT_TRUE(import_text("nested.ac", nested + body));
    EXPECT_TRUE(import_text("none.ac", with("numvert", "subdiv 0\nnumvert")));
    EXPECT_THAT(error_of("many.ac", with("numvert", "subdiv 30\nnumvert")),
                HasSubstr("many.ac:7: a surface to be subdivided"));
}

TEST(Ac3dText, TheNameOfTheFileDoesNotMatter) {
    EXPECT_TRUE(import_text("good.model", head + body));
    for (const char* name : {"far.model", "far.acc", "far.ac3d", "far.AC"}) {
        EXPECT_THAT(error_of(name, with("2 0 0\nkids", "7 0 0\nkids")), HasSubstr(":17: "));
    }
}

} // namespace cd::tests
