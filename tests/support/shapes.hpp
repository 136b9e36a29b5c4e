// Meshes, poses and files for tests. Every random object is a function of its generator.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace cd::tests {

/// Returns a double in [low, high), identical on every standard library.
[[nodiscard]] double uniform(std::mt19937_64& random, double low, double high);
[[nodiscard]] Vec3 random_point(std::mt19937_64& random, double half_width);

/// Makes the mesh of these arrays, which must be valid.
[[nodiscard]] Mesh make_mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles);
[[nodiscard]] std::shared_ptr<const Mesh> share(Mesh mesh);
/// Adds the two triangles of a quadrilateral, corners counter-clockwise from outside.
void add_quad(std::vector<Triangle>& triangles, const std::array<std::uint32_t, 4>& corners);
/// Makes a mesh of triangles with unshared corners: each three points in order.
[[nodiscard]] Mesh make_soup(std::vector<Vec3> corners);

/// Makes `count` triangles of about `size` with unshared corners in the cube [-1, 1]^3.
[[nodiscard]] Mesh
make_triangle_soup(std::mt19937_64& random, std::uint32_t count, double size = 0.5);
/// Makes a closed sphere of radius 1, bit-identical with every compiler: an octahedron with
/// triangles split in four repeatedly.
[[nodiscard]] Mesh make_sphere(int subdivisions);
/// Makes a closed box of 12 triangles, centred on the origin.
[[nodiscard]] Mesh make_box(const Vec3& size);
/// Makes a closed box whose faces are grids of n x n cells.
[[nodiscard]] Mesh make_gridded_box(const Vec3& size, int n);
/// Makes a closed box whose faces are divided at these ascending coordinates, which its vertices
/// have exactly.
[[nodiscard]] Mesh make_ticked_box(const std::vector<double>& x,
                                   const std::vector<double>& y,
                                   const std::vector<double>& z);
[[nodiscard]] Mesh make_box_between(const Vec3& low, const Vec3& high);
/// Makes a closed torus around z.
[[nodiscard]] Mesh make_torus(double radius, double tube, int around, int across);
/// Makes a soup with repeated corners, segments, points, duplicates and small-lattice coordinates.
[[nodiscard]] Mesh make_degenerate_soup(std::mt19937_64& random, std::uint32_t count);
/// Makes triangles of growing size from one corner: every split of the bare rule peels one off.
[[nodiscard]] Mesh make_staircase(std::uint32_t count);
/// Returns one mesh with the triangles of all, in order.
[[nodiscard]] Mesh join(const std::vector<Mesh>& meshes);
/// Returns the mesh with every triangle wound the other way.
[[nodiscard]] Mesh reversed(const Mesh& mesh);
[[nodiscard]] Mesh mapped(const Mesh& mesh, const std::function<Vec3(const Vec3&)>& map);
/// Returns the mesh with separate corners for each triangle, as in an STL file.
[[nodiscard]] Mesh unshared(const Mesh& mesh);
[[nodiscard]] Mesh scaled(const Mesh& mesh, double factor);
/// Returns the mesh as a file of floats has it.
[[nodiscard]] Mesh as_floats(const Mesh& mesh);
/// Returns the mesh with every vertex moved by `offset` (rounded).
[[nodiscard]] Mesh translated(const Mesh& mesh, const Vec3& offset);

/// Makes a random pose: a quaternion of norm near 1, a translation in a cube of half width `reach`.
[[nodiscard]] Pose make_pose(std::mt19937_64& random, double reach);
/// Makes the pose of `make_pose` as a rounded matrix.
[[nodiscard]] Pose make_matrix_pose(std::mt19937_64& random, double reach);
[[nodiscard]] Pose translation_pose(double x, double y, double z);

/// Finds a real model in the models' folder (CMake setting and environment variable CD_MESHES).
[[nodiscard]] std::optional<std::filesystem::path> find_model(const std::string& name);

} // namespace cd::tests

/// Skips the test loudly if the real models are missing; fails if CI is "true".
#define CD_NEEDS_MODEL(model, name)                                                                \
    const auto model##_found = ::cd::tests::find_model(name);                                      \
    if (!model##_found) {                                                                          \
        if (::cd::tests::skips_are_failures()) {                                                   \
            FAIL() << "CI is set and the model is missing: " << (name);                            \
        }                                                                                          \
        GTEST_SKIP() << "no model " << (name) << "; set CD_MESHES to the folder of models";        \
    }                                                                                              \
    const std::filesystem::path& model = *model##_found

namespace cd::tests {
[[nodiscard]] bool skips_are_failures();
} // namespace cd::tests
