// Proves that a COLLADA file is refused by line if the importer would read part of a number, read
// on without end, or take part of a text for the whole.
#include "client/import/foreign/collada_check.hpp"

#include "tests/client/import/import_text.hpp"

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// A triangle, in which a test replaces parts.
struct Document {
    std::string meter = "1";
    std::string count = "9";
    std::string positions = "0 0 0 1 0 0 0 1 0"; // Line 5.
    std::string offset = "0";
    std::string vcount = "3";
    std::string indices = "0 1 2";                                               // Line 11.
    std::string transforms = "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"; // Line 15.

    [[nodiscard]] std::string text() const {
        return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
               "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
               "version=\"1.4.1\">\n"
               "<asset><unit name='u' meter='" +
               meter +
               "'/><up_axis>Z_UP</up_axis></asset>\n"
               "<library_geometries><geometry id=\"g\"><mesh><source id=\"s\">\n"
               "<float_array id=\"a\" count=\"" +
               count + "\">" + positions +
               "</float_array>\n"
               "<technique_common><accessor source=\"#a\" count=\"3\" stride=\"3\">\n"
               "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
               "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
               "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>\n"
               "<polylist count=\"1\">\n<input semantic=\"VERTEX\" source=\"#v\" offset=\"" +
               offset + "\"/>\n<vcount>" + vcount + "</vcount><p>" + indices +
               "</p>\n"
               "</polylist></mesh></geometry></library_geometries>\n"
               "<library_visual_scenes><visual_scene id=\"vs\">\n"
               "<node id=\"n\">\n" +
               transforms +
               "\n<instance_geometry url=\"#g\"/></node>\n"
               "</visual_scene></library_visual_scenes>\n"
               "<scene><instance_visual_scene url=\"#vs\"/></scene>\n</COLLADA>\n";
    }
};

std::string error_with(std::string Document::*part, const std::string& text) {
    Document document;
    document.*part = text;
    return error_of("half.dae", document.text());
}

bool takes(std::string Document::*part, const std::string& text) {
    Document document;
    document.*part = text;
    const auto imported = import_text("good.dae", document.text());
    EXPECT_TRUE(imported) << imported.error().detail;
    return imported && imported.value().mesh->triangles().size() == 1;
}

const char* const bad_numbers[] = {"1d5", "0x10", "1,5", "five", "1.5.5", "&#53;"};

} // namespace

TEST(ColladaCheck, WhatIsSoundIsTaken) {
    EXPECT_TRUE(takes(&Document::meter, "0.0254"));
    EXPECT_TRUE(takes(&Document::positions, "\n 0 0 +0 1. -0.5\t1e-3\r\n0 .5 0\n"));
    EXPECT_TRUE(takes(&Document::positions, "<!-- x -->0 0 0 1 0 0 0 1 0<!-- y -->"));
    EXPECT_TRUE(takes(&Document::positions, "<![CDATA[0 0 0 1 0 0 0 1 0]]>"));
    EXPECT_TRUE(takes(&Document::transforms,
                      "<translate>1 2 3</translate><rotate>0 0 1 90</rotate><scale>1 2 1</scale>"
                      "<extra><technique profile=\"X\"><scale>wide</scale><p>-1</p></technique>"
                      "<p count=\"?\">x</p></extra>"));
}

TEST(ColladaCheck, CoordinatesReadHalfwayAreNamedByLine) {
    for (const std::string number : bad_numbers) {
        SCOPED_TRACE(number);
        EXPECT_THAT(error_with(&Document::positions, "0 0 0 1 0 0\n0 1 " + number),
                    HasSubstr("half.dae:6: in <float_array>"));
        EXPECT_THAT(error_with(&Document::positions, number + " 0 0 1 0 0\n0 1 0"),
                    HasSubstr("half.dae:5: "));
    }
    EXPECT_THAT(error_with(&Document::positions, "0 0 0 1 0 0 0 1 1.#INF"),
                HasSubstr("half.dae:5: "));
    // A coordinate that is not finite is reported by its face.
    EXPECT_THAT(error_with(&Document::positions, "0 0 0 1 0 0 0 1 NaN"), HasSubstr("face 0"));
    EXPECT_THAT(error_with(&Document::positions, "0 0 0 1 0 0 0 1 1e39"), HasSubstr("face 0"));
}

TEST(ColladaCheck, IndicesThatAreNoneAreNamedByLine) {
    // The importer would stop at a letter and fill the memory with zeros.
    for (const std::string index : {"2d", "x", "-2", "1.5", "0x2", "4294967298"}) {
        SCOPED_TRACE(index);
        EXPECT_THAT(error_with(&Document::indices, "0 1\n" + index),
                    HasSubstr("half.dae:12: in <p>, '" + index + "' is not an index"));
        EXPECT_THAT(error_with(&Document::vcount, index), HasSubstr("half.dae:11: in <vcount>"));
    }
    EXPECT_NE(error_with(&Document::indices, "0 1 7"), "was taken");
}

TEST(ColladaCheck, TransformsReadHalfwayAreNamedByLine) {
    for (const std::string number : bad_numbers) {
        SCOPED_TRACE(number);
        for (const std::string& transform : std::vector<std::string>{
                 "<matrix>1 0 0 0\n0 1 0 0 0 0 1 0 0 0 0 " + number + "</matrix>",
                 "<translate>0\n0 " + number + "</translate>",
                 "<rotate>0 0\n1 " + number + "</rotate>",
                 "<scale>1\n1 " + number + "</scale>",
                 "<lookat>0 0 0 1 1 1\n0 0 " + number + "</lookat>",
                 "<skew>0 0 0 1 1 1\n" + number + "</skew>"}) {
            EXPECT_THAT(error_with(&Document::transforms, transform),
                        HasSubstr("half.dae:16: in <"));
        }
    }
    EXPECT_THAT(error_with(&Document::transforms, "<translate>1 2 3 4</translate>"),
                HasSubstr("4 numbers in place of 3"));
    EXPECT_NE(error_with(&Document::transforms, "<translate>1 2</translate>"), "was taken");
}

TEST(ColladaCheck, UnitsCountsAndOffsetsThatAreNoNumbersAreNamedByLine) {
    for (const std::string number : bad_numbers) {
        SCOPED_TRACE(number);
        EXPECT_THAT(error_with(&Document::meter, number), HasSubstr("half.dae:3: meter is"));
        EXPECT_THAT(error_with(&Document::count, number), HasSubstr("half.dae:5: count is"));
        EXPECT_THAT(error_with(&Document::offset, number), HasSubstr("half.dae:10: offset is"));
    }
    EXPECT_THAT(error_with(&Document::count, "8"), HasSubstr("9 numbers in place of 8"));
}

TEST(ColladaCheck, AccessorsEndWithTheirArrays) {
    // The importer would read beyond the end.
    Document shorter;
    shorter.count = "6";
    shorter.positions = "0 0 0 1 0 0";
    EXPECT_THAT(error_of("short.dae", shorter.text()),
                HasSubstr("short.dae:6: an accessor of 9 numbers to an array that counts 6"));
    std::string uncounted = Document{}.text();
    uncounted.replace(uncounted.find(" count=\"9\""), 10, "");
    EXPECT_THAT(error_of("uncounted.dae", uncounted), HasSubstr("to an array that counts 0"));
    std::string wide = Document{}.text();
    wide.replace(wide.find("stride=\"3\""), 10, "stride=\"4\"");
    EXPECT_THAT(error_of("wide.dae", wide), HasSubstr("an accessor of 12 numbers"));
}

TEST(ColladaCheck, ATextOfWhichTheImporterTakesAPartIsRefused) {
    EXPECT_THAT(error_with(&Document::indices, "0 1 2 <!-- --> 0 1 2"), HasSubstr("half.dae:11: "));
    EXPECT_THAT(error_with(&Document::positions, "0 0 0 1 0 0 0 1 0<![CDATA[1 2 3]]>"),
                HasSubstr("half.dae:5: "));
    EXPECT_THAT(error_with(&Document::indices, "0 1 2 <b/> 0 1 2"), HasSubstr("half.dae:11: "));
}

TEST(ColladaCheck, NestingHasABound) {
    const auto nested = [](int depth) {
        std::string begin;
        std::string end;
        for (int i = 0; i < depth; ++i) {
            begin += "<node>";
            end += "</node>";
        }
        std::string text = Document{}.text();
        text.insert(text.find("<node id"), begin);
        text.insert(text.rfind("</node>"), end);
        return text;
    };
    EXPECT_TRUE(import_text("nested.dae", nested(900)));
    EXPECT_THAT(error_of("deep.dae", nested(100'000)), HasSubstr("deep.dae:14: elements nested"));
}

TEST(ColladaCheck, TheNameOfTheFileDoesNotMatter) {
    Document document;
    EXPECT_TRUE(import_text("good.model", document.text()));
    document.indices = "0 1 -2";
    for (const char* name : {"half.model", "half.xml", "half.DAE"}) {
        EXPECT_THAT(error_of(name, document.text()), HasSubstr(":11: in <p>"));
        EXPECT_THAT(error_of(name, "\xef\xbb\xbf \n" + document.text()), HasSubstr(":12: in <p>"));
    }
    EXPECT_THAT(error_of("half.zae", "PK\x03\x04 and more"), HasSubstr("unpack it"));
}

TEST(ColladaCheck, InstancesOfWhatIsNotThereAreNamedByLine) {
    const auto with = [](const std::string& instance) {
        std::string text = Document{}.text();
        const std::string sound = "<instance_geometry url=\"#g\"/>"; // Line 16.
        return text.replace(text.find(sound), sound.size(), sound + instance);
    };
    EXPECT_TRUE(import_text("good.dae", with("<instance_geometry url=\"#g\"/>")));
    EXPECT_THAT(error_of("a.dae", with("<instance_geometry url=\"#h\"/>")),
                HasSubstr("a.dae:16: instance_geometry names '#h', which is not in this file"));
    EXPECT_THAT(error_of("b.dae", with("<instance_node url=\"#h\"/>")),
                HasSubstr("b.dae:16: instance_node names '#h'"));
    EXPECT_THAT(error_of("c.dae", with("<instance_geometry url=\"other.dae#g\"/>")),
                HasSubstr("c.dae:16: instance_geometry names 'other.dae#g'"));
    EXPECT_THAT(error_of("d.dae", with("<instance_controller url=\"#skin\"/>")),
                HasSubstr("d.dae:16: a mesh deformed by a skin or a morph"));
}

TEST(ColladaCheck, AConvexHullIsNoMesh) {
    std::string text = Document{}.text();
    const std::string geometry = "<library_geometries>";
    text.replace(text.find(geometry),
                 geometry.size(),
                 geometry + "<geometry id=\"c\"><convex_mesh convex_hull_of=\"#g\"/></geometry>");
    EXPECT_TRUE(import_text("unused.dae", text));
    text.replace(text.find("url=\"#g\""), 8, "url=\"#c\"");
    EXPECT_THAT(error_of("hull.dae", text), HasSubstr("hull.dae:16: geometry 'c' is no mesh"));
}

TEST(ColladaCheck, WhatIsNotWellFormedIsNamedByLine) {
    std::string text = Document{}.text();
    text.replace(text.find("</node>"), 7, "</nod>");
    EXPECT_THAT(error_of("broken.dae", text), HasSubstr("broken.dae:16: is not well-formed XML"));
}

} // namespace cd::tests
