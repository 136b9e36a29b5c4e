// Solids on a small lattice, of which integers tell whether their interiors meet.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

using LatticePoint = std::array<int, 3>;

/// One of the 24 rotations that take axes to axes, then a translation. With `mirrors`, of the 48
/// that may also mirror.
struct LatticeMotion {
    std::array<int, 3> axis{0, 1, 2}; ///< Coordinate i comes from coordinate axis[i] ...
    std::array<int, 3> sign{1, 1, 1}; ///< ... times this.
    LatticePoint offset{0, 0, 0};

    [[nodiscard]] LatticePoint apply(const LatticePoint& point) const;
    /// The same in doubles, exactly, as a matrix.
    [[nodiscard]] Pose pose() const;
};

[[nodiscard]] LatticeMotion random_motion(std::mt19937_64& random, int reach, bool mirrors);

/// One that does not mirror, with an integer quaternion for its rotation.
struct LatticeTurn {
    LatticeMotion motion;
    Quaternion quaternion;
};

[[nodiscard]] LatticeTurn random_turn(std::mt19937_64& random, int reach);

/// A closed body of cubes of one size.
struct CubeSolid {
    std::vector<LatticePoint> cubes; ///< Lowest corners.
    int size = 1;
    Mesh mesh; ///< The faces between a cube and none, each of two triangles, outward or all inward.
};

/// A few cubes that hang together; not every one has a closed mesh of one component.
[[nodiscard]] CubeSolid random_cubes(std::mt19937_64& random, int count, int size);
[[nodiscard]] CubeSolid cubes_at(std::vector<LatticePoint> cubes, int size = 1);

/// True when two cubes of the moved solids share more than their surfaces.
[[nodiscard]] bool interiors_meet(const CubeSolid& a,
                                  const LatticeMotion& motion_a,
                                  const CubeSolid& b,
                                  const LatticeMotion& motion_b);

/// A tetrahedron.
struct Tetrahedron {
    std::vector<LatticePoint> corners;
    Mesh mesh;
};

/// With volume, wound outward or inward, in the cube from 0 to `reach`.
[[nodiscard]] Tetrahedron random_tetrahedron(std::mt19937_64& random, int reach);
/// Most of its corners are corners of the given one or middles of its edges, of which all
/// coordinates are even.
[[nodiscard]] Tetrahedron random_relative(std::mt19937_64& random, const Tetrahedron& of);

/// By separating planes: of faces, and along one edge of each.
[[nodiscard]] bool interiors_meet(const Tetrahedron& a,
                                  const LatticeMotion& motion_a,
                                  const Tetrahedron& b,
                                  const LatticeMotion& motion_b);

} // namespace cd::tests
