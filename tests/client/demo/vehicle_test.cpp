// Proves that generated vehicles have named parts, and that their files hold the same triangles.
#include "client/demo/vehicle.hpp"

#include "client/demo/demo_vehicles.hpp"
#include "client/import/mesh_import.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cd::tests {

namespace {

using testing::IsSupersetOf;

std::vector<std::string> part_names(const Mesh& mesh) {
    std::vector<std::string> names;
    for (const Part& part : mesh.parts()) {
        names.push_back(part.name);
    }
    return names;
}

} // namespace

TEST(Vehicle, EachTriangleIsInOnePartAndEachPartHasAName) {
    for (const VehicleKind kind : {VehicleKind::Car, VehicleKind::Truck}) {
        for (const std::uint64_t triangles : {5'000u, 30'000u, 300'000u}) {
            const auto mesh = make_vehicle(kind, triangles);
            EXPECT_NEAR(static_cast<double>(mesh->triangles().size()),
                        static_cast<double>(triangles),
                        0.25 * static_cast<double>(triangles));
            std::uint32_t end = 0;
            for (const Part& part : mesh->parts()) {
                EXPECT_EQ(part.triangles_begin, end) << part.name;
                EXPECT_GT(part.triangles_end, part.triangles_begin) << part.name;
                end = part.triangles_end;
            }
            EXPECT_EQ(end, mesh->triangles().size());
            const auto names = part_names(*mesh);
            EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size())
                << "no name twice";
            EXPECT_EQ(std::count(names.begin(), names.end(), ""), 0);
        }
    }
}

TEST(Vehicle, PartsAreNamedAfterWhatTheyAre) {
    EXPECT_THAT(part_names(*make_vehicle(VehicleKind::Car, 30'000)),
                IsSupersetOf({"body", "engine", "wheel_front_left", "mirror_right", "grille"}));
    EXPECT_THAT(part_names(*make_vehicle(VehicleKind::Truck, 100'000)),
                IsSupersetOf({"cab", "box", "wheel_middle_right", "beam_left", "cross_members"}));
}

TEST(Vehicle, TheLeftMirrorIsOnTheSideOfPositiveY) {
    const auto car = make_vehicle(VehicleKind::Car, 30'000);
    for (const Part& part : car->parts()) {
        if (part.name == "mirror_left" || part.name == "mirror_right") {
            const double y = car->corners(part.triangles_begin)[0].y();
            EXPECT_GT(part.name == "mirror_left" ? y : -y, 0.8) << part.name;
        }
    }
}

TEST(Vehicle, ItsFileHoldsTheSameTrianglesAndParts) {
    const TemporaryFolder folder;
    const auto paths = write_vehicles(folder.path() / "new" / "folder");
    ASSERT_TRUE(paths) << paths.error().detail;
    const std::array<std::shared_ptr<const Mesh>, 2> made{make_vehicle(VehicleKind::Truck, 100'000),
                                                          make_vehicle(VehicleKind::Car, 30'000)};
    for (std::size_t i = 0; i < made.size(); ++i) {
        const auto read = import_mesh(paths.value()[i], {});
        ASSERT_TRUE(read) << read.error().detail;
        const Mesh& mesh = *read.value().mesh;
        EXPECT_EQ(mesh.precision(), Precision::Float);
        EXPECT_EQ(mesh.parts(), made[i]->parts());
        ASSERT_EQ(mesh.triangles().size(), made[i]->triangles().size());
        for (std::uint32_t k = 0; k < mesh.triangles().size(); ++k) {
            ASSERT_EQ(mesh.corners(k), made[i]->corners(k)) << paths.value()[i] << ", " << k;
        }
    }
}

} // namespace cd::tests
