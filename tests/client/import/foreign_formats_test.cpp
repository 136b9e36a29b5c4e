// Proves for formats read by assimp: a crash becomes a one-line error, units of the file are
// applied once and axes never, and transforms that are not rigid are refused.
#include "client/import/foreign/assimp_import.hpp"
#include "client/import/foreign/xml_frames.hpp"
#include "tests/client/import/import_text.hpp"

#include <zip.h>

#include <string>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string x3d(const std::string& indices) {
    return "<?xml version=\"1.0\"?><X3D version=\"3.0\"><Scene><Shape><IndexedFaceSet "
           "coordIndex=\"" +
           indices +
           "\"><Coordinate point=\"0 0 0 1 0 0 0 1 0\"/></IndexedFaceSet></Shape></Scene></X3D>";
}

std::string amf(const std::string& unit) {
    return "<?xml version=\"1.0\"?><amf" + unit +
           "><object id=\"0\"><mesh><vertices>"
           "<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex>"
           "<vertex><coordinates><x>2</x><y>0</y><z>0</z></coordinates></vertex>"
           "<vertex><coordinates><x>0</x><y>4</y><z>8</z></coordinates></vertex></vertices>"
           "<volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object>"
           "</amf>";
}

std::string collada(const std::string& asset) {
    return "<?xml version=\"1.0\"?>\n<COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\"><asset>" +
           asset +
           "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"s\">"
           "<float_array id=\"a\" count=\"9\">0 0 0 2 0 0 0 4 8</float_array><technique_common>"
           "<accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/>"
           "<param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
           "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
           "source=\"#s\"/></vertices><triangles count=\"1\"><input semantic=\"VERTEX\" "
           "source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles></mesh></geometry>"
           "</library_geometries><library_visual_scenes><visual_scene id=\"vs\"><node id=\"n\">"
           "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
           "<scene><instance_visual_scene url=\"#vs\"/></scene></COLLADA>";
}

std::string fbx(const std::string& scale) {
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n"
           "\tFBXVersion: 7400\n}\nGlobalSettings:  {\n\tVersion: 1000\n\tProperties70:  {\n"
           "\t\tP: \"UpAxis\", \"int\", \"Integer\", \"\",2\n"
           "\t\tP: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," +
           scale +
           "\n\t}\n}\nObjects:  {\n\tGeometry: 1001, \"Geometry::tri\", \"Mesh\" {\n"
           "\t\tVertices: *9 {\n\t\t\ta: 0,0,0,2,0,0,0,4,8\n\t\t}\n"
           "\t\tPolygonVertexIndex: *3 {\n\t\t\ta: 0,1,-3\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n"
           "\tModel: 2001, \"Model::thing\", \"Mesh\" {\n\t\tVersion: 232\n\t}\n}\n"
           "Connections:  {\n\tC: \"OO\",2001,0\n\tC: \"OO\",1001,2001\n}\n";
}

void write_3mf(const std::filesystem::path& path, const std::string& unit) {
    const std::string relations =
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    const std::string model =
        "<?xml version=\"1.0\"?><model" + unit +
        " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
        "<object id=\"1\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/>"
        "<vertex x=\"2\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"4\" z=\"8\"/></vertices><triangles>"
        "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object></resources><build>"
        "<item objectid=\"1\"/></build></model>";
    int code = 0;
    zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
    ASSERT_NE(archive, nullptr);
    for (const auto& [name, text] :
         {std::pair<const char*, const std::string&>("_rels/.rels", relations),
          {"3D/3dmodel.model", model}}) {
        zip_file_add(archive, name, zip_source_buffer(archive, text.data(), text.size(), 0), 0);
    }
    ASSERT_EQ(zip_close(archive), 0);
}

ImportedMesh imported_to(const std::string& unit, const std::filesystem::path& path) {
    ImportOptions options;
    options.declared_unit_to = unit;
    const auto imported = import_mesh(path, options);
    EXPECT_TRUE(imported) << imported.error().detail;
    return imported ? imported.value() : ImportedMesh{};
}

ImportedMesh
imported_to(const std::string& unit, const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    write_text(folder / name, text);
    return imported_to(unit, folder / name);
}

/// Returns the corner that is at (0, 4, 8) in the file.
Vec3 far_corner(const ImportedMesh& imported) {
    return imported.mesh ? imported.mesh->corners(0)[2] : Vec3::Zero();
}

Vec3 in_floats(double y, double z) {
    return Vec3(0, y, z).cast<float>().cast<double>();
}

} // namespace

TEST(ForeignFormats, ACrashOfTheReaderIsOneLine) {
    EXPECT_TRUE(import_text("sound.x3d", x3d("0 1 2 -1")));
    // The reader uses memory that it has freed, which crashes it unless a sanitizer keeps that
    // memory.
    const std::string error = error_of("twice.x3d", x3d("0 1 2 -1 -1"));
#ifdef __SANITIZE_THREAD__
    EXPECT_THAT(error, HasSubstr("twice.x3d: "));
#else
    EXPECT_THAT(error, HasSubstr("twice.x3d: the reader crashed (assimp "));
#endif
}

TEST(ForeignFormats, DamagedArchivesNeverEndTheProgram) {
    const TemporaryFolder folder;
    write_3mf(folder / "good.3mf", "");
    const std::string good = read_text(folder / "good.3mf");
    int refused = 0;
    for (std::size_t place = 0; place < good.size(); place += 29) {
        std::string bent = good;
        bent[place] = static_cast<char>(bent[place] ^ 0x41);
        write_text(folder / "bent.3mf", bent);
        const auto imported = import_mesh(folder / "bent.3mf", {});
        if (!imported) {
            ++refused;
            EXPECT_THAT(imported.error().detail, HasSubstr("bent.3mf: ")) << place;
        }
    }
    EXPECT_GT(refused, 0);
}

TEST(ForeignFormats, UnitsOfTheFileAreAppliedOnce) {
    EXPECT_EQ(far_corner(imported_to("mm", "inch.amf", amf(" unit=\"inch\""))),
              in_floats(101.6, 203.2));
    EXPECT_EQ(far_corner(imported_to("m", "none.amf", amf(""))), in_floats(0.004, 0.008));
    EXPECT_EQ(far_corner(imported_to("in", "inch.dae", collada("<unit meter='0.0254'/>"))),
              in_floats(4, 8));
    EXPECT_EQ(far_corner(imported_to("cm", "none.dae", collada(""))), in_floats(400, 800));
    EXPECT_EQ(far_corner(imported_to("in", "inch.fbx", fbx("2.54"))), in_floats(4, 8));
    EXPECT_EQ(far_corner(imported_to("m", "cm.fbx", fbx("1"))), in_floats(0.04, 0.08));
    const TemporaryFolder folder;
    write_3mf(folder / "foot.3mf", " unit=\"foot\"");
    EXPECT_EQ(far_corner(imported_to("ft", folder / "foot.3mf")), in_floats(4, 8));
    write_3mf(folder / "none.3mf", "");
    EXPECT_EQ(far_corner(imported_to("mm", folder / "none.3mf")), in_floats(4, 8));
}

TEST(ForeignFormats, AUnitThatIsAskedForStandsInPlaceOfTheFiles) {
    const TemporaryFolder folder;
    write_text(folder / "inch.dae", collada("<unit meter='0.0254'/>"));
    const auto imported = import_mesh(folder / "inch.dae", {0.001});
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(far_corner(imported.value()), in_floats(0.004, 0.008));
}

TEST(ForeignFormats, AUnitOfTheFileThatIsNotKnownIsRefusedUnlessTheJobSaysOne) {
    const TemporaryFolder folder;
    write_3mf(folder / "yard.3mf", " unit=\"yard\"");
    write_text(folder / "millimeters.amf", amf(" unit=\"millimeters\""));
    for (const char* name : {"yard.3mf", "millimeters.amf"}) {
        ImportOptions options;
        options.declared_unit_to = "m";
        const auto refused = import_mesh(folder / name, options);
        ASSERT_FALSE(refused) << name;
        EXPECT_THAT(refused.error().detail, HasSubstr("declares a unit that is not known")) << name;
        const auto asked = import_mesh(folder / name, {0.5});
        ASSERT_TRUE(asked) << asked.error().detail;
        EXPECT_EQ(far_corner(asked.value()), Vec3(0, 2, 4)) << name;
    }
}

TEST(ForeignFormats, TheUpAxisIsNamedAndNeverTurned) {
    for (const char* axis : {"X", "Y", "Z"}) {
        const auto imported =
            import_text("up.dae", collada(std::string("<up_axis>") + axis + "_UP</up_axis>"));
        ASSERT_TRUE(imported) << imported.error().detail;
        EXPECT_EQ(far_corner(imported.value()), Vec3(0, 4, 8));
        EXPECT_EQ(imported.value().declared.up, axis);
    }
    EXPECT_EQ(imported_to("cm", "up.fbx", fbx("1")).declared.up, "Z");
}

TEST(ForeignFormats, YIsTurnedToZWhereAsked) {
    ImportOptions options;
    options.is_y_up = true;
    const TemporaryFolder folder;
    for (const auto& [name, text] : {std::pair<std::string, std::string>("a.dae", collada("")),
                                     {"a.obj", "v 0 0 0\nv 2 0 0\nv 0 4 8\nf 1 2 3\n"}}) {
        write_text(folder / name, text);
        const auto imported = import_mesh(folder / name, options);
        ASSERT_TRUE(imported) << imported.error().detail;
        EXPECT_EQ(far_corner(imported.value()), Vec3(0, -8, 4)) << name;
    }
}

TEST(ForeignFormats, ASkinIsRefused) {
    const std::string skin = "SkinWeights { \"bone\"; 1; 0; 1.0; "
                             "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;; }";
    const auto direct_x = [](const std::string& more) {
        return "xof 0303txt 0032\nFrame bone {\nMesh m {\n3; 0.0;0.0;0.0;, 2.0;0.0;0.0;, "
               "0.0;4.0;8.0;;\n1; 3;0,1,2;;\n" +
               more + "}\n}\n";
    };
    EXPECT_EQ(mesh_of(import_text("plain.x", direct_x(""))).triangles().size(), 1u);
    EXPECT_THAT(error_of("skin.x", direct_x(skin)),
                HasSubstr("is deformed by a skin, and only rigid meshes are read"));
}

TEST(ForeignFormats, NotesSayWhatWasTaken) {
    const auto inch = import_text("inch.dae", collada("<unit name='inch' meter='0.0254'/>"));
    ASSERT_TRUE(inch) << inch.error().detail;
    EXPECT_THAT(import_notes(inch.value(), "", false),
                ElementsAre("unit inch, from the file",
                            "up axis Y, from the file; not turned",
                            "read by assimp: coordinates within one float step of the file's"));
    EXPECT_THAT(import_notes(inch.value(), "mm", true),
                ElementsAre("unit mm, as asked; the file says inch",
                            "turned from y up to z up",
                            "read by assimp: coordinates within one float step of the file's"));
}

} // namespace cd::tests
