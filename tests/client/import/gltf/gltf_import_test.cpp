// Proves that a glTF file gives the triangles the specification prescribes, or is refused with the
// name of the invalid object.
#include "client/import/mesh_readers.hpp"
#include "tests/client/import/gltf_text.hpp"
#include "tests/client/import/import_text.hpp"
#include "tests/support/memory_bound.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/Geometry>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = GltfText::Json;

std::shared_ptr<const Mesh> taken(const std::string& text) {
    const auto imported = import_text("taken.gltf", text);
    EXPECT_TRUE(imported) << imported.error().detail;
    return imported ? imported.value().mesh : nullptr;
}

std::shared_ptr<const Mesh> taken(const GltfText& text) {
    return taken(text.text());
}

std::string refused(const GltfText& text) {
    return error_of("refused.gltf", text.text());
}

/// Makes one triangle of integers, each corner on another axis.
template <class T>
std::shared_ptr<const Mesh>
quantised(T at_x, T at_y, T at_z, int component_type, bool is_normalized) {
    GltfText text;
    const std::vector<T> values{at_x, 0, 0, 0, at_y, 0, 0, 0, at_z};
    text.primitive() = {
        {"attributes", {{"POSITION", text.add(values, component_type, "VEC3", is_normalized)}}}};
    text.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    return taken(text);
}

Vec3 diagonal(const std::shared_ptr<const Mesh>& mesh) {
    const Corners corners = mesh->corners(0);
    return corners[0] + corners[1] + corners[2];
}

double nearest_float(double value) {
    return static_cast<double>(static_cast<float>(value));
}

GltfText chain(int length) {
    GltfText text = GltfText::triangle();
    text.json["nodes"] = Json::array();
    for (int i = 1; i <= length; ++i) {
        text.json["nodes"].push_back({{"children", {i}}});
    }
    text.json["nodes"].push_back({{"mesh", 0}});
    return text;
}

} // namespace

TEST(GltfImport, IntegersArePositionsAsKhrMeshQuantizationHasThem) {
    EXPECT_EQ(diagonal(quantised<std::int8_t>(-128, 127, 5, 5120, false)), Vec3(-128, 127, 5));
    EXPECT_EQ(diagonal(quantised<std::uint8_t>(255, 1, 128, 5121, false)), Vec3(255, 1, 128));
    EXPECT_EQ(diagonal(quantised<std::int16_t>(-32768, 32767, 3, 5122, false)),
              Vec3(-32768, 32767, 3));
    EXPECT_EQ(diagonal(quantised<std::uint16_t>(65535, 1, 2, 5123, false)), Vec3(65535, 1, 2));
    EXPECT_EQ(diagonal(quantised<std::int8_t>(-128, 127, -127, 5120, true)), Vec3(-1, 1, -1));
    EXPECT_EQ(diagonal(quantised<std::uint8_t>(255, 51, 255, 5121, true)),
              Vec3(1, nearest_float(0.2), 1));
    EXPECT_EQ(diagonal(quantised<std::int16_t>(-32768, 32767, -32767, 5122, true)),
              Vec3(-1, 1, -1));
    EXPECT_EQ(diagonal(quantised<std::uint16_t>(65535, 1, 65535, 5123, true)),
              Vec3(1, nearest_float(1.0 / 65535), 1));
}

TEST(GltfImport, PositionsOfOtherTypesAreRefused) {
    GltfText wide;
    wide.primitive() = {
        {"attributes",
         {{"POSITION", wide.add(std::vector<std::uint32_t>(9, 1), 5125, "VEC3", false)}}}};
    EXPECT_THAT(refused(wide), HasSubstr("mesh 0, primitive 0: its POSITION is not three"));
    GltfText flat;
    flat.primitive() = {
        {"attributes", {{"POSITION", flat.add(std::vector<float>(12, 1), 5126, "VEC4", false)}}}};
    EXPECT_THAT(refused(flat), HasSubstr("its POSITION is not three"));
}

TEST(GltfImport, InterleavedElementsAreReadByTheirStride) {
    GltfText text;
    const auto view = text.add_view<float>({9, 9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0});
    text.json["bufferViews"][view]["byteStride"] = 20;
    text.json["accessors"].push_back({{"bufferView", view},
                                      {"byteOffset", 8},
                                      {"componentType", 5126},
                                      {"count", 3},
                                      {"type", "VEC3"}});
    text.primitive() = {{"attributes", {{"POSITION", 0}}}};
    EXPECT_EQ(diagonal(taken(text)), Vec3(1, 1, 0));

    text.json["accessors"][0]["count"] = 4;
    EXPECT_THAT(refused(text), HasSubstr("accessor 0: its 4 elements go beyond bufferView 0"));
    text.json["accessors"][0]["count"] = 3;
    text.json["bufferViews"][view]["byteStride"] = 8;
    EXPECT_THAT(refused(text), HasSubstr("byteStride of 8"));
    text.json["bufferViews"][view]["byteLength"] = std::numeric_limits<std::uint64_t>::max();
    EXPECT_THAT(refused(text), HasSubstr("bufferView 0 goes beyond buffer 0"));
}

TEST(GltfImport, SparseElementsReplaceOthers) {
    GltfText text = GltfText::triangle();
    const auto indices = text.add_view<std::uint8_t>({2});
    const auto values = text.add_view<float>({0, 5, 0});
    text.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    EXPECT_EQ(diagonal(taken(text)), Vec3(1, 5, 0));

    GltfText from_zeros = text;
    from_zeros.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(diagonal(taken(from_zeros)), Vec3(0, 5, 0));

    GltfText beyond = text;
    beyond.json["accessors"][0]["sparse"]["count"] = 2;
    EXPECT_THAT(refused(beyond), HasSubstr("accessor 0: its 2 elements go beyond bufferView 2"));
}

TEST(GltfImport, CountsAreNotBelievedBeyondTheBytesThatAreThere) {
    GltfText text = GltfText::triangle();
    const auto indices = text.add_view<std::uint8_t>({2});
    const auto values = text.add_view<float>({0, 5, 0});
    text.json["accessors"][0] = {{"componentType", 5126},
                                 {"type", "VEC3"},
                                 {"count", 900'000'000},
                                 {"sparse",
                                  {{"count", 1},
                                   {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                   {"values", {{"bufferView", values}}}}}};
    text.primitive().erase("indices");
    const TemporaryFolder folder;
    write_text(folder / "huge.gltf", text.text());
    const MemoryBound bound(256u << 20);
    const auto imported = import_mesh(folder / "huge.gltf", {});
    ASSERT_FALSE(imported);
    EXPECT_THAT(imported.error().detail, HasSubstr("accessor 0: it counts 900000000 elements"));
}

TEST(GltfImport, IndicesThatNameNoVertexAreNamed) {
    GltfText text = GltfText::triangle();
    text.primitive()["indices"] = text.add_indices({0, 1, 2, 0, 2, 3});
    EXPECT_THAT(refused(text),
                HasSubstr("node 0: mesh 0, primitive 0: index 5 names vertex 3 of 3"));
    for (const int mode : {5, 6}) {
        text.primitive()["mode"] = mode;
        EXPECT_THAT(refused(text), HasSubstr("index 5 names vertex 3 of 3"));
    }
    text.primitive()["indices"] = text.add_indices({0, 1, 65535});
    EXPECT_THAT(refused(text), HasSubstr("index 2 is 65535"));
    text.primitive()["indices"] = text.add(std::vector<float>{0, 1, 2}, 5126, "SCALAR", false);
    EXPECT_THAT(refused(text), HasSubstr("its indices are not unsigned integers"));
}

TEST(GltfImport, StripsAndFansFaceOneWay) {
    const std::vector<float> square{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    GltfText text;
    text.primitive() = {{"attributes", {{"POSITION", text.add_positions(square)}}}, {"mode", 5}};
    const auto strip = taken(text);
    ASSERT_EQ(strip->triangles().size(), 3u);
    for (std::uint32_t t = 0; t < 3; ++t) {
        const Corners c = strip->corners(t);
        EXPECT_GT((c[1] - c[0]).cross(c[2] - c[0]).z(), 0) << t;
    }
    text.primitive()["mode"] = 6;
    text.primitive()["indices"] = text.add_indices({0, 1, 3, 2});
    const auto fan = taken(text);
    ASSERT_EQ(fan->triangles().size(), 2u);
    EXPECT_EQ(fan->corners(1)[0], Vec3(0, 0, 0));
    EXPECT_EQ(fan->corners(1)[1], Vec3(1, 1, 0));
    EXPECT_EQ(fan->corners(1)[2], Vec3(0, 1, 0));
}

TEST(GltfImport, TrianglesThatAreNotWholeAreRefused) {
    GltfText text = GltfText::triangle();
    text.primitive()["indices"] = text.add_indices({0, 1, 2, 0});
    EXPECT_THAT(refused(text), HasSubstr("primitive 0: its 4 indices do not make whole"));
    text.primitive()["indices"] = text.add_indices({0, 1});
    text.primitive()["mode"] = 5;
    EXPECT_THAT(refused(text), HasSubstr("its 2 indices do not make whole"));
    text.primitive()["mode"] = 7;
    EXPECT_THAT(refused(text), HasSubstr("mode 7 is not known"));
}

TEST(GltfImport, PointsAndLinesAreCountedAndPassedOver) {
    GltfText text = GltfText::triangle();
    for (const int mode : {0, 1, 2, 3}) {
        Json other = text.primitive();
        other["mode"] = mode;
        if (mode == 1) {
            other["indices"] = text.add_indices({0, 1});
        }
        text.json["meshes"][0]["primitives"].push_back(other);
    }
    const auto imported = import_text("lines.gltf", text.text());
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().points_skipped, 3u);
    EXPECT_EQ(imported.value().lines_skipped, 1u + 3u + 2u);
    EXPECT_EQ(imported.value().mesh->triangles().size(), 1u);
}

TEST(GltfImport, InstancesArePlacedEach) {
    GltfText text = GltfText::triangle();
    const auto moved = text.add_positions({0, 0, 0, 10, 0, 0});
    const auto turned =
        text.add(std::vector<std::int16_t>{0, 0, 0, 32767, 0, 0, 23170, 23170}, 5122, "VEC4", true);
    const auto scaled = text.add_positions({1, 1, 1, 2, 2, 2});
    text.json["nodes"][0]["translation"] = {0, 0, 7};
    text.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", moved}, {"ROTATION", turned}, {"SCALE", scaled}};
    text.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const auto mesh = taken(text);
    ASSERT_EQ(mesh->triangles().size(), 2u);
    EXPECT_EQ(mesh->corners(0)[1], Vec3(1, 0, 7));
    EXPECT_EQ(mesh->corners(1)[0], Vec3(10, 0, 7));
    EXPECT_EQ(mesh->corners(1)[1], Vec3(10, 2, 7)); // x is turned to y, exactly.
    EXPECT_EQ(mesh->parts().size(), 2u);

    text.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
        text.add_positions({1, 1, 1});
    EXPECT_THAT(refused(text), HasSubstr("node 0: its EXT_mesh_gpu_instancing"));
}

TEST(GltfImport, ExtensionsThatAreRequiredAndUnknownAreNamed) {
    GltfText text = GltfText::triangle();
    text.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform"};
    EXPECT_TRUE(taken(text));
    text.json["extensionsRequired"].push_back("ACME_bends_space");
    EXPECT_THAT(refused(text), HasSubstr("requires the extension ACME_bends_space"));
    text.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    EXPECT_THAT(refused(text), HasSubstr("compressed by KHR_draco_mesh_compression"));
}

TEST(GltfImport, CompressedGeometryIsNamedAlsoWhereNotRequired) {
    GltfText draco = GltfText::triangle();
    draco.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
    EXPECT_THAT(refused(draco),
                HasSubstr("mesh 0, primitive 0: its geometry is compressed by KHR_draco"));
    GltfText meshopt = GltfText::triangle();
    meshopt.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
    EXPECT_THAT(refused(meshopt),
                HasSubstr("bufferView 0: its geometry is compressed by EXT_mesh"));
}

TEST(GltfImport, SkinsAndWeightsThatBendTheMeshAreRefused) {
    GltfText skin = GltfText::triangle();
    skin.json["nodes"].push_back({{"name", "joint"}});
    skin.json["skins"].push_back({{"joints", {1}}}); // inverseBindMatrices are optional.
    skin.json["nodes"][0]["skin"] = 0;
    EXPECT_THAT(refused(skin), HasSubstr("node 0: its mesh is deformed by skin 0"));

    GltfText morph = GltfText::triangle();
    morph.primitive()["targets"] = {{{"POSITION", 0}}};
    EXPECT_TRUE(taken(morph));
    morph.json["meshes"][0]["weights"] = {0.5};
    EXPECT_THAT(refused(morph), HasSubstr("node 0: its mesh is deformed by morph targets"));
    morph.json["nodes"][0]["weights"] = {0};
    EXPECT_TRUE(taken(morph));
}

TEST(GltfImport, TransformsAreComposedAndRoundedOnce) {
    GltfText text = GltfText::triangle();
    text.json["nodes"] = {{{"children", {1}}, {"translation", {0.1, 0, 0}}},
                          {{"children", {2}}, {"rotation", {0, 0, 0.70710677, 0.70710677}}},
                          {{"mesh", 0}, {"scale", {3, 1, 1}}, {"translation", {0.7, 0, 0}}}};
    const auto mesh = taken(text);
    const double moved = static_cast<double>(0.1f);
    EXPECT_EQ(mesh->corners(0)[0], Vec3(nearest_float(moved), nearest_float(0.7f), 0));
    EXPECT_EQ(mesh->corners(0)[1].y(), nearest_float(3 + static_cast<double>(0.7f)));

    GltfText matrix = GltfText::triangle();
    matrix.json["nodes"][0]["matrix"] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    EXPECT_EQ(taken(matrix)->corners(0)[1], Vec3(5, 8, 7));
    EXPECT_EQ(taken(matrix)->corners(0)[2], Vec3(4, 6, 7));
    matrix.json["nodes"][0]["matrix"][3] = 1;
    EXPECT_THAT(refused(matrix), HasSubstr("node 0: its matrix has a last row"));
}

TEST(GltfImport, TransformsThatAreNoNumbersAreNamedByNode) {
    GltfText text = GltfText::triangle();
    text.json["nodes"][0]["translation"] = {0, 0, nullptr};
    EXPECT_THAT(refused(text), HasSubstr("node 0: translation holds something other"));
    text.json["nodes"][0]["translation"] = {0, 0};
    EXPECT_THAT(refused(text), HasSubstr("node 0: translation has 2 numbers in place of 3"));
    text.json["nodes"][0]["translation"] = {0, 0, 1e39};
    EXPECT_THAT(refused(text), HasSubstr("not finite"));
    text.json["nodes"][0] = {{"mesh", 0}, {"rotation", {0, 0, 0, 0}}};
    EXPECT_THAT(refused(text), HasSubstr("node 0: its rotation is no quaternion"));
}

TEST(GltfImport, NestingHasABound) {
    EXPECT_TRUE(taken(chain(900)));
    EXPECT_THAT(refused(chain(100'000)), HasSubstr("node 1000: is nested more than"));
}

TEST(GltfImport, ANodeHasOneParent) {
    GltfText text = GltfText::triangle();
    text.json["nodes"] = {{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    EXPECT_THAT(refused(text), HasSubstr("node 2: is the child of two nodes"));
    text.json["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
    EXPECT_THAT(refused(text), HasSubstr("node 1: is the child of two nodes"));
    text.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
    EXPECT_THAT(refused(text), HasSubstr("node 0: is a root of the scene and the child"));
    text.json["nodes"] = {{{"mesh", 0}}};
    text.json["scenes"][0]["nodes"] = {0, 0};
    EXPECT_THAT(refused(text), HasSubstr("node 0: is a root of the scene twice"));
}

TEST(GltfImport, IndicesBetweenObjectsAreChecked) {
    GltfText text = GltfText::triangle();
    text.json["nodes"][0]["mesh"] = 3;
    EXPECT_THAT(refused(text), HasSubstr("node 0: mesh is 3, and there are 1"));
    text.json["nodes"][0]["mesh"] = -1;
    EXPECT_THAT(refused(text), HasSubstr("node 0: mesh is not an index"));
    text = GltfText::triangle();
    text.primitive()["attributes"]["POSITION"] = 9;
    EXPECT_THAT(refused(text),
                HasSubstr("mesh 0, primitive 0, attributes: POSITION is 9, and there are 2"));
}

TEST(GltfImport, PartsAreNodesAndPrimitivesInOrder) {
    GltfText text = GltfText::triangle();
    text.json["meshes"].push_back(
        {{"name", "pair"}, {"primitives", {text.primitive(), text.primitive()}}});
    text.json["nodes"] = {{{"mesh", 0}, {"name", "door"}, {"children", {1}}},
                          {{"mesh", 1}, {"name", "inner"}},
                          {{"mesh", 0}}};
    text.json["scenes"][0]["nodes"] = {2, 0};
    std::vector<std::string> names;
    const auto mesh = taken(text);
    for (const Part& part : mesh->parts()) {
        names.push_back(part.name);
    }
    EXPECT_THAT(names, ElementsAre("nodes[2]", "door", "pair-0", "pair-1"));
}

TEST(GltfImport, BuffersInFilesStandInTheFolder) {
    GltfText text = GltfText::triangle();
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "data");
    write_text(folder / "data/the bytes.bin",
               std::string(reinterpret_cast<const char*>(text.bytes.data()), text.bytes.size()));
    const auto with = [&](const std::string& uri, std::size_t bytes) {
        Json json = text.json;
        json["buffers"].push_back({{"byteLength", bytes}, {"uri", uri}});
        write_text(folder / "outer.gltf", json.dump());
        const auto imported = import_mesh(folder / "outer.gltf", {});
        return imported ? "was taken" : imported.error().detail;
    };
    EXPECT_EQ(with("data/the%20bytes.bin", text.bytes.size()), "was taken");
    EXPECT_THAT(with("data/the%20bytes.bin", 1u << 30),
                HasSubstr("buffer 0: it counts 1073741824"));
    EXPECT_THAT(with("nowhere.bin", 42), HasSubstr("nowhere.bin: No such file"));
    for (const std::string uri : {"../x.bin",
                                  "data/../../x.bin",
                                  "/etc/passwd",
                                  "%2e%2e/x.bin",
                                  "http://somewhere/x.bin",
                                  "file:x.bin",
                                  ""}) {
        SCOPED_TRACE(uri);
        EXPECT_THAT(with(uri, 42), HasSubstr("buffer 0: its uri is"));
    }
    EXPECT_THAT(with("data:;base64,AAA*", 3), HasSubstr("damaged base64"));
    EXPECT_THAT(with("data:,text", 3), HasSubstr("not in base64"));
}

TEST(GltfImport, AGlbIsTakenWholeWhateverItsName) {
    const std::string glb = GltfText::triangle().glb();
    for (const char* name : {"a.glb", "a.gltf", "a.vrm"}) {
        const auto imported = import_text(name, glb);
        ASSERT_TRUE(imported) << imported.error().detail;
        EXPECT_EQ(imported.value().mesh->triangles().size(), 1u);
    }
    std::string old = glb;
    old[4] = 1;
    EXPECT_THAT(error_of("old.glb", old), HasSubstr("version 1"));
    EXPECT_THAT(error_of("long.glb", glb + "x"), HasSubstr("the GLB counts"));
    std::string chunk = glb;
    chunk[15] = 1;
    EXPECT_THAT(error_of("chunk.glb", chunk), HasSubstr("a chunk of this GLB counts"));
    for (std::size_t size = 1; size < glb.size(); ++size) {
        EXPECT_NE(error_of("cut.glb", glb.substr(0, size)), "was taken") << size;
    }
}

TEST(GltfImport, FilesThatAreNotGltfSaySo) {
    EXPECT_THAT(error_of("text.glb", "this is no mesh"), HasSubstr("its JSON is damaged at byte"));
    EXPECT_THAT(error_of("list.gltf", "[]"), HasSubstr("not an object"));
    EXPECT_THAT(error_of("empty.gltf", "{}"), HasSubstr("no asset"));
    GltfText old = GltfText::triangle();
    old.json["asset"]["version"] = "1.0";
    EXPECT_THAT(refused(old), HasSubstr("glTF version '1.0'"));
    GltfText no_scene = GltfText::triangle();
    no_scene.json.erase("scenes");
    EXPECT_THAT(refused(no_scene), HasSubstr("has no scene"));
}

} // namespace cd::tests
