// Proves that entries of [bodies] become the bodies that they stand for: instances share a mesh,
// and the parts of a file are meshes of their own that together have all its triangles.
#include "client/scene/scene_bodies.hpp"

#include "client/scene/mesh_split.hpp"
#include "tests/client/scene/scene_of.hpp"
#include "tests/support/rounds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Meshes = std::vector<std::shared_ptr<const Mesh>>;

std::vector<std::string> names_of(const SceneBodies& scene) {
    std::vector<std::string> names;
    for (const NamedBody& body : scene.bodies) {
        names.push_back(body.name);
    }
    return names;
}

std::string problem_of(const SceneSpec& spec, const Meshes& meshes) {
    const auto made = expand_bodies(spec, meshes, "job.toml");
    return made ? "none" : made.error().detail;
}

/// The corners of all triangles, sorted.
std::vector<std::array<double, 9>> triangles_of(const Meshes& meshes) {
    std::vector<std::array<double, 9>> triangles;
    for (const auto& mesh : meshes) {
        for (std::uint32_t i = 0; i < mesh->triangles().size(); ++i) {
            std::array<double, 9> numbers{};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    numbers.at(3 * corner + axis) =
                        mesh->corners(i).at(corner)[static_cast<Eigen::Index>(axis)];
                }
            }
            triangles.push_back(numbers);
        }
    }
    std::ranges::sort(triangles);
    return triangles;
}

} // namespace

TEST(SceneBodies, AreInstancesPartsAndBodiesInTheOrderOfTheirEntries) {
    SceneSpec spec;
    spec.bodies = {body_entry("wall"), body_entry("car", "traffic"), body_entry("factory")};
    spec.bodies[1].count = 3;
    spec.bodies[2].is_split = true;
    const auto car = mesh_of_parts({{"hull", 2}});
    const Meshes meshes{mesh_of_parts({{"", 1}}), car, mesh_of_parts({{"door", 1}, {"roof", 2}})};
    const auto made = expand_bodies(spec, meshes, "job.toml");
    ASSERT_TRUE(made) << made.error().detail;
    const SceneBodies& scene = made.value();
    EXPECT_THAT(names_of(scene),
                ElementsAre("wall", "car.0", "car.1", "car.2", "factory.door", "factory.roof"));
    EXPECT_EQ(scene.meshes.size(), 4u);
    EXPECT_EQ(&scene.mesh_of(scene.bodies[1]), car.get());
    EXPECT_EQ(scene.bodies[3].mesh, scene.bodies[1].mesh);
    EXPECT_EQ(scene.bodies[2].group, "traffic");
    EXPECT_EQ(scene.bodies[2].entry, 1u);
    EXPECT_EQ(scene.mesh_of(scene.bodies[5]).triangles().size(), 2u);
}

TEST(SceneBodies, EntriesWithOneFileShareItsMesh) {
    SceneSpec spec;
    spec.bodies = {body_entry("left"), body_entry("right")};
    const auto mesh = mesh_of_parts({{"", 1}});
    const auto made = expand_bodies(spec, Meshes{mesh, mesh}, "job.toml");
    ASSERT_TRUE(made);
    EXPECT_EQ(made.value().meshes.size(), 1u);
}

TEST(SceneBodies, HaveDifferentNames) {
    SceneSpec spec;
    spec.bodies = {body_entry("car"), body_entry("car.1")};
    spec.bodies[0].count = 2;
    spec.bodies[0].line = 3;
    spec.bodies[1].line = 7;
    const auto mesh = mesh_of_parts({{"", 1}});
    EXPECT_EQ(problem_of(spec, {mesh, mesh}),
              "job.toml:7: [bodies] car.1: a body \"car.1\" exists already, of line 3; give one of "
              "them another name");
}

TEST(SceneBodies, AreAtLeastTwoAndNotTooMany) {
    SceneSpec spec;
    spec.bodies = {body_entry("car")};
    spec.bodies[0].line = 2;
    const auto mesh = mesh_of_parts({{"", 1}});
    EXPECT_THAT(problem_of(spec, {mesh}), HasSubstr("job.toml:2: [bodies] has one body, \"car\""));
    spec.bodies[0].count = 16384;
    EXPECT_EQ(problem_of(spec, {mesh}), "none");
    spec.bodies.push_back(body_entry("wall"));
    spec.bodies[1].line = 4;
    EXPECT_EQ(problem_of(spec, {mesh, mesh}),
              "job.toml:4: [bodies] wall: a job has at most 16 384 bodies; leave some out");
}

TEST(SceneBodies, HaveALimitOfMeshes) {
    SceneSpec spec;
    spec.bodies = {body_entry("assembly")};
    spec.bodies[0].is_split = true;
    std::vector<std::pair<std::string, std::uint32_t>> parts(4096, {"part", 1});
    EXPECT_EQ(problem_of(spec, {mesh_of_parts(parts)}), "none");
    parts.emplace_back("part", 1);
    EXPECT_THAT(problem_of(spec, {mesh_of_parts(parts)}),
                HasSubstr("[bodies] assembly: a job has at most 4 096 meshes"));
}

TEST(MeshSplit, KeepsEachTriangleOnce) {
    for (SeededRandom random : seeds(20)) {
        const Mesh soup = make_degenerate_soup(random, 60);
        MeshArrays arrays{soup.vertices(), soup.triangles(), {}, soup.precision()};
        std::uint32_t end = 0;
        for (int part = 0; part < 5; ++part) {
            const auto begin = end + static_cast<std::uint32_t>(random() % 5);
            end = begin + static_cast<std::uint32_t>(random() % 8);
            arrays.parts.push_back({"p", begin, end});
        }
        const auto mesh = share(Mesh::create(std::move(arrays)).value());
        const auto split = split_mesh(*mesh);
        ASSERT_TRUE(split);
        Meshes parts;
        for (const PartMesh& part : split.value()) {
            parts.push_back(part.mesh);
        }
        EXPECT_EQ(triangles_of(parts), triangles_of({mesh}));
    }
}

TEST(MeshSplit, NamesEachPartOnce) {
    const auto names_of_split = [](const std::shared_ptr<const Mesh>& mesh) {
        const auto split = split_mesh(*mesh);
        EXPECT_TRUE(split);
        std::string names;
        for (const PartMesh& part : split.value()) {
            names += part.name + " ";
        }
        return names;
    };
    EXPECT_EQ(names_of_split(mesh_of_parts({{"x", 1}, {"y", 1}, {"x", 1}, {"x#2", 1}})),
              "x y x#2 x#2#2 ");
    EXPECT_EQ(names_of_split(mesh_of_parts({{"x", 1}, {"", 2}})), "x others ");
    EXPECT_EQ(names_of_split(mesh_of_parts({{"others", 1}, {"", 2}})), "others others#2 ");
    EXPECT_EQ(names_of_split(mesh_of_parts({{"", 2}})), "whole ");
}

TEST(MeshSplit, UsesOnlyTheVerticesOfThePart) {
    const Mesh box = make_box(Vec3(1, 1, 1));
    MeshArrays arrays{box.vertices(), box.triangles(), {{"one", 3, 4}}, box.precision()};
    const auto split = split_mesh(Mesh::create(std::move(arrays)).value());
    ASSERT_TRUE(split);
    ASSERT_EQ(split.value().size(), 2u);
    const Mesh& one = *split.value()[0].mesh;
    EXPECT_EQ(one.vertices().size(), 3u);
    EXPECT_EQ(one.corners(0), box.corners(3));
    EXPECT_EQ(one.parts(), (std::vector<Part>{{"one", 0, 1}}));
    EXPECT_EQ(split.value()[1].mesh->triangles().size(), 11u);
}

} // namespace cd::tests
