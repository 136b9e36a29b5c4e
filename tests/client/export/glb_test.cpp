// Proves that GLB files have the triangles of their meshes, coloured by contact, and keep to glTF.
#include "client/export/contact_scene.hpp"
#include "client/export/glb_file.hpp"
#include "client/export/result_writer.hpp"
#include "client/import/mesh_import.hpp"
#include "tests/support/near_results.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstring>
#include <set>

namespace cd::tests {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;
using Numbers = std::array<double, 9>;

/// Returns the triangles of a mesh, each from its least corner on, so that only the order of
/// corners around the triangle counts.
std::multiset<Numbers> triangles_of(const Mesh& mesh) {
    std::multiset<Numbers> all;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        Corners corners = mesh.corners(i);
        const auto less = [](const Vec3& left, const Vec3& right) {
            return std::lexicographical_compare(
                left.data(), left.data() + 3, right.data(), right.data() + 3);
        };
        std::rotate(
            corners.begin(), std::min_element(corners.begin(), corners.end(), less), corners.end());
        Numbers numbers{};
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            numbers[k] = corners[k / 3][static_cast<int>(k % 3)];
        }
        all.insert(numbers);
    }
    return all;
}

nlohmann::json json_of(const fs::path& path) {
    const std::string bytes = read_text(path);
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, sizeof size);
    return nlohmann::json::parse(bytes.substr(20, size));
}

class Glb : public testing::Test {
  protected:
    Glb() {
        context_.bodies = {{"a <b>\xff", "a.obj", share(as_floats(make_torus(2, 0.7, 20, 10)))},
                           {"b", "b.obj", share(as_floats(make_box({1, 2, 3})))}};
        context_.unit = "m";
    }

    [[nodiscard]] Result<ImportedMesh> read(const std::string& name, const char* unit = "m") const {
        ImportOptions options;
        options.declared_unit_to = unit;
        return import_mesh(folder_.path() / name, options);
    }

    /// Returns the numbers of triangles and of scenarios in A's map: 2^(i / 8) of triangle i.
    [[nodiscard]] ContactMap map() const {
        ContactMap map;
        for (std::uint32_t i = 0; i < 160; ++i) {
            map.bodies[0].push_back({i, 1ull << (i / 8)});
        }
        return map;
    }

    const TemporaryFolder folder_;
    ExportContext context_;
};

} // namespace

TEST_F(Glb, OurImporterReadsTheBodiesTriangles) {
    ASSERT_TRUE(write_glb_bodies(map(), 1'000'000, folder_.path(), context_));
    for (std::size_t i = 0; i < 2; ++i) {
        const auto imported = read(body_file_name(context_.bodies, i) + ".glb");
        ASSERT_TRUE(imported) << imported.error().detail;
        EXPECT_EQ(triangles_of(*imported.value().mesh), triangles_of(*context_.bodies[i].mesh));
        EXPECT_EQ(imported.value().mesh->precision(), Precision::Float);
    }
}

TEST_F(Glb, TrianglesAreSortedIntoSixteenMaterialsOnALogScale) {
    ASSERT_TRUE(write_glb_bodies(map(), 1'000'000, folder_.path(), context_));
    const auto json = json_of(folder_.path() / "a _b_\xef\xbf\xbd.glb");
    const auto& primitives = json["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), 16u);
    std::size_t indices = 0;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        EXPECT_EQ(primitives[i]["material"], i);
        indices += json["accessors"][primitives[i]["indices"].get<std::size_t>()]["count"]
                       .get<std::size_t>();
    }
    EXPECT_EQ(indices, 3 * context_.bodies[0].mesh->triangles().size());
    // 20 powers of two share 15 colours, so none has more than two of them.
    EXPECT_EQ(json["materials"][0]["name"], "never in contact");
    EXPECT_EQ(json["materials"][1]["name"], "1 of 1 000 000 scenarios");
    EXPECT_EQ(json["materials"][2]["name"], "2 to 4 of 1 000 000 scenarios");
    EXPECT_EQ(json["materials"][15]["name"], "524 288 of 1 000 000 scenarios");
    EXPECT_EQ(json["meshes"][0]["name"], "a <b>\xef\xbf\xbd");
    EXPECT_EQ(json["nodes"][0]["name"], "a <b>\xef\xbf\xbd");
}

TEST_F(Glb, AMapOfListedPairsSaysSoInItsLegend) {
    context_.listed.limit_pairs = 5;
    ContactMap map;
    map.bodies[1] = {{3, 7}};
    ASSERT_TRUE(write_glb_bodies(map, 10, folder_.path(), context_));
    const auto json = json_of(folder_.path() / "b.glb");
    EXPECT_EQ(json["materials"][1]["name"], "7 of 10 scenarios, of the first 5 pairs a scenario");
    EXPECT_EQ(json["materials"].size(), 2u);
}

TEST_F(Glb, OtherUnitsBecomeMetres) {
    context_.unit = "mm";
    ASSERT_TRUE(write_glb_bodies({}, 1, folder_.path(), context_));
    const auto metres = read("b.glb", "m");
    const auto millimetres = read("b.glb", "mm");
    ASSERT_TRUE(metres && millimetres);
    EXPECT_NEAR(metres.value().mesh->vertices()[0].norm(), std::sqrt(14.0) / 2e3, 1e-9);
    EXPECT_NEAR(millimetres.value().mesh->vertices()[0].norm(), std::sqrt(14.0) / 2, 1e-6);
}

TEST_F(Glb, AFarBodyKeepsItsDetails) {
    const Vec3 far(5e6 + 0.3, -4e5, 0.1);
    const Mesh box = make_box({1, 2, 3});
    context_.bodies[1].mesh = share(translated(box, far));
    ASSERT_TRUE(write_glb_bodies({}, 1, folder_.path(), context_));
    const auto json = json_of(folder_.path() / "b.glb");
    const auto& points = json["accessors"][0];
    EXPECT_EQ(points["count"], 8);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = points["max"][axis].get<double>() - points["min"][axis].get<double>();
        EXPECT_NEAR(size, 1.0 + static_cast<double>(axis), 1e-6);
        const double moved = json["nodes"][0]["translation"][axis];
        EXPECT_NEAR(moved + points["min"][axis].get<double>() + size / 2,
                    far[static_cast<int>(axis)],
                    1e-6);
    }
}

TEST_F(Glb, WhatFloatsDoNotReachIsRefused) {
    context_.bodies[1].mesh = share(scaled(make_box({1, 2, 3}), 1e200));
    const Status refused = write_glb_bodies({}, 1, folder_.path(), context_);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().detail, HasSubstr("b.glb: a glb file has floats"));
    EXPECT_FALSE(fs::exists(folder_.path() / "b.glb"));
}

TEST_F(Glb, AStopLeavesNoFile) {
    context_.stop = [] { return true; };
    const Status stopped = write_glb_bodies({}, 1, folder_.path(), context_);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Glb, ChunksHaveWholeWordsAndTrueLengths) {
    ASSERT_TRUE(write_glb_bodies(map(), 9, folder_.path(), context_));
    for (const char* name : {"a _b_\xef\xbf\xbd.glb", "b.glb"}) {
        const std::string bytes = read_text(folder_.path() / name);
        std::array<std::uint32_t, 5> head{};
        std::memcpy(head.data(), bytes.data(), sizeof head);
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(head[1], 2u);
        EXPECT_EQ(head[2], bytes.size());
        EXPECT_EQ(head[3] % 4, 0u);
        std::uint32_t binary = 0;
        std::memcpy(&binary, bytes.data() + 20 + head[3], sizeof binary);
        EXPECT_EQ(28 + head[3] + binary, bytes.size());
        EXPECT_EQ(json_of(folder_.path() / name)["buffers"][0]["byteLength"], binary);
    }
}

TEST_F(Glb, ASceneHasBothBodiesWhereTheyStand) {
    Scenario scenario;
    scenario.poses.b = translation_pose(0.5, 0, 0.25);
    ScenarioResult result;
    result.level = Level::Contacts;
    result.pairs = {
        {0, 5, PairClass::Touch}, {0, 6, PairClass::Proper}, {2, 7, PairClass::Coplanar}};
    result.point_origins = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    result.point_offsets = {0, 1, 3, 6};
    result.points = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto& [a, b] = std::tie(context_.bodies[0].mesh, context_.bodies[1].mesh);
    const ContactScene scene = make_contact_scene(
        {SceneBody{"a", a, {}, {}}, SceneBody{"b", b, {}, {}}}, scenario, result);
    EXPECT_EQ(scene.dots.size(), 1u);
    EXPECT_EQ(scene.segments.size(), 2u + 6u) << "a segment, and the outline of a triangle";
    ASSERT_EQ(scene.bodies[0].contacts.size(), 2u);
    EXPECT_EQ(scene.bodies[0].contacts[0].kind, PairClass::Proper);
    ASSERT_TRUE(write_scene_glb(scene, 1, folder_.path() / "s.glb", {}));

    const auto imported = read("s.glb");
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().lines_skipped, 4u);
    EXPECT_EQ(imported.value().points_skipped, 1u);
    const Mesh moved = translated(*b, {0.5, 0, 0.25});
    EXPECT_EQ(triangles_of(*imported.value().mesh), triangles_of(as_floats(join({*a, moved}))));
    const auto json = json_of(folder_.path() / "s.glb");
    std::vector<std::size_t> counts;
    for (const auto& primitive : json["meshes"][1]["primitives"]) {
        counts.push_back(json["accessors"][primitive["indices"].get<std::size_t>()]["count"]);
    }
    EXPECT_THAT(counts, testing::ElementsAre(27, 3, 6)) << "of B: 9 in peace, 1 proper, 2 touching";
}

TEST_F(Glb, AMapWithAClearanceCountsNearTriangles) {
    context_.clearance = 0.5;
    ASSERT_TRUE(write_glb_bodies({}, 10, folder_.path(), context_));
    const auto json = json_of(folder_.path() / "b.glb");
    EXPECT_EQ(json["materials"][0]["name"], "never near or in contact");
}

TEST_F(Glb, ASceneHasNearTrianglesAndGapsInAMaterialOfTheirOwn) {
    const auto box = context_.bodies[1].mesh;
    const ContactScene scene =
        make_contact_scene({SceneBody{"a", box, {}, {}}, SceneBody{"b", box, {}, {}}},
                           Scenario(),
                           near_results(Level::Contacts)[1]);
    ASSERT_TRUE(write_scene_glb(scene, 1, folder_.path() / "s.glb", {}));
    const auto json = json_of(folder_.path() / "s.glb");
    ASSERT_EQ(json["materials"].size(), 6u);
    EXPECT_EQ(json["materials"][5]["name"], "near");
    const auto& primitives = json["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), 2u) << "10 triangles in no pair, 2 near";
    EXPECT_EQ(primitives[1]["material"], 5);
    EXPECT_EQ(json["accessors"][primitives[1]["indices"].get<std::size_t>()]["count"], 6);
    const auto& gaps = json["meshes"].back();
    EXPECT_EQ(gaps["name"], "gaps");
    EXPECT_EQ(gaps["primitives"][0]["material"], 5);
    EXPECT_EQ(gaps["primitives"][0]["mode"], 1);
    EXPECT_EQ(json["accessors"][gaps["primitives"][0]["indices"].get<std::size_t>()]["count"], 4);
}

} // namespace cd::tests
