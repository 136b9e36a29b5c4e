// Solids on a small lattice; integers decide whether their interiors meet.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cd::tests {

using LatticePoint = std::array<int, 3>;

/// One of the 24 axis-permuting rotations, then a translation. With `mirrors`, one of all 48
/// symmetries.
struct LatticeMotion {
    std::array<int, 3> axis{0, 1, 2}; ///< Coordinate i comes from coordinate axis[i].
    std::array<int, 3> sign{1, 1, 1}; ///< Factor of coordinate i.
    LatticePoint offset{0, 0, 0};

    [[nodiscard]] LatticePoint apply(const LatticePoint& point) const;
    /// Returns the motion exactly as a matrix pose.
    [[nodiscard]] Pose pose() const;
};

[[nodiscard]] LatticeMotion random_motion(std::mt19937_64& random, int reach, bool mirrors);

/// A motion without mirroring; an integer quaternion gives its rotation.
struct LatticeTurn {
    LatticeMotion motion;
    Quaternion quaternion;
};

[[nodiscard]] LatticeTurn random_turn(std::mt19937_64& random, int reach);

/// A closed body of cubes of one size.
struct CubeSolid {
    std::vector<LatticePoint> cubes; ///< Lowest corners.
    int size = 1;
    Mesh mesh; ///< Faces on empty space, two triangles each; all outward or all inward.
};

/// Makes a few connected cubes; their mesh may be open or have several components.
[[nodiscard]] CubeSolid random_cubes(std::mt19937_64& random, int count, int size);
[[nodiscard]] CubeSolid cubes_at(std::vector<LatticePoint> cubes, int size = 1);

/// True if two cubes of the moved solids share more than their surfaces.
[[nodiscard]] bool interiors_meet(const CubeSolid& a,
                                  const LatticeMotion& motion_a,
                                  const CubeSolid& b,
                                  const LatticeMotion& motion_b);

struct Tetrahedron {
    std::vector<LatticePoint> corners;
    Mesh mesh;
};

/// Makes one with volume, wound outward or inward, in the cube from 0 to `reach`.
[[nodiscard]] Tetrahedron random_tetrahedron(std::mt19937_64& random, int reach);
/// Makes one whose corners are mostly corners of `of` or midpoints of its edges; all coordinates of
/// `of` are even.
[[nodiscard]] Tetrahedron random_relative(std::mt19937_64& random, const Tetrahedron& of);

/// Decides by separating planes: the faces, and planes spanned by one edge of each.
[[nodiscard]] bool interiors_meet(const Tetrahedron& a,
                                  const LatticeMotion& motion_a,
                                  const Tetrahedron& b,
                                  const LatticeMotion& motion_b);

} // namespace cd::tests
