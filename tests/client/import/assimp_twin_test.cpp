// Proves that our readers take the same parts and triangles from real models as assimp, in the same
// order, up to assimp's rounding of decimals.
#include "client/import/foreign/assimp_import.hpp"
#include "client/import/mesh_import.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>
#include <string>

namespace cd::tests {

namespace {

struct Model {
    const char* file;
    bool is_text;
};

void PrintTo(const Model& model, std::ostream* out) {
    *out << model.file;
}

/// Numbers the floats in ascending order, both zeros as 0.
std::int64_t float_number(double value) {
    const auto bits = std::bit_cast<std::int32_t>(static_cast<float>(value));
    return bits < 0 ? -(bits & std::numeric_limits<std::int32_t>::max()) : bits;
}

/// Returns the largest distance, in float steps, between two corners' coordinates.
std::int64_t steps_between(const Vec3& left, const Vec3& right) {
    std::int64_t steps = 0;
    for (int axis = 0; axis < 3; ++axis) {
        steps = std::max(steps, std::abs(float_number(left[axis]) - float_number(right[axis])));
    }
    return steps;
}

void expect_twins(const std::filesystem::path& path, bool is_text) {
    const auto own = import_mesh(path, {});
    ASSERT_TRUE(own) << own.error().detail;
    const auto twin = import_with_assimp(path, {});
    ASSERT_TRUE(twin) << twin.error().detail;
    const Mesh& left = *own.value().mesh;
    const Mesh& right = *twin.value().mesh;

    EXPECT_EQ(left.parts(), right.parts());
    ASSERT_EQ(left.triangles().size(), right.triangles().size());
    const std::int64_t steps_max = is_text ? 1 : 0;
    std::uint64_t far_apart = 0;
    for (std::uint32_t i = 0; i < left.triangles().size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t steps = steps_between(left.corners(i)[k], right.corners(i)[k]);
            far_apart += steps > steps_max ? 1 : 0;
        }
    }
    EXPECT_EQ(far_apart, 0u);
    if (!is_text) {
        EXPECT_EQ(left.hash(), right.hash());
    }
}

class AssimpTwin : public testing::TestWithParam<Model> {};

} // namespace

TEST_P(AssimpTwin, HasTheSamePartsAndTriangles) {
    CD_NEEDS_MODEL(path, GetParam().file);
    expect_twins(path, GetParam().is_text);
}

TEST(AssimpTwinOfOurs, HasTheSamePartsAndTriangles) {
    const TemporaryFolder folder;
    write_obj(folder / "torus.obj", make_torus(1, 0.4, 24, 12));
    expect_twins(folder / "torus.obj", true);
}

INSTANTIATE_TEST_SUITE_P(All,
                         AssimpTwin,
                         testing::Values(Model{"audi_body.obj", true},
                                         Model{"curiosity_rover.stl", false},
                                         Model{"drivaer_fastback.ply", false},
                                         Model{"hatchback.obj", true},
                                         Model{"jet_fighter.obj", true},
                                         Model{"lugged_wheel.obj", true},
                                         Model{"m113_apc.glb", false},
                                         Model{"man_kat1_8x8.glb", false},
                                         Model{"motorbike.ply", false},
                                         Model{"sedan.obj", true},
                                         Model{"stanford_bunny.ply", true},
                                         Model{"toy_truck.glb", false}),
                         [](const auto& param) {
                             std::string name = param.param.file;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

} // namespace cd::tests
