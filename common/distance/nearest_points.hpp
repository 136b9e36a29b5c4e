// The features of a pair of triangles and the points at which a pair is nearest.
#pragma once

#include "common/geometry/types.hpp"

#include <cstddef>
#include <cstdint>

namespace cd {

/// The features of a pair, in canonical order: a corner, edge or face of A and one of B, between
/// which the least distance of a pair is found. Edge k runs from corner k to the next one.
namespace feature {

inline constexpr std::size_t corner_corner = 0; ///< Plus 3 i + j, for corners i of A and j of B.
inline constexpr std::size_t corner_edge = 9;   ///< Plus 3 i + j, for corner i of A, edge j of B.
inline constexpr std::size_t edge_corner = 18;  ///< Plus 3 i + j, for edge i of A, corner j of B.
inline constexpr std::size_t corner_face = 27;  ///< Plus i, for corner i of A and the face of B.
inline constexpr std::size_t face_corner = 30;  ///< Plus j, for the face of A and corner j of B.
inline constexpr std::size_t edge_edge = 33;    ///< Plus 3 i + j, for edges i of A and j of B.
inline constexpr std::size_t count = 42;

} // namespace feature

/// The nearest points of two triangles that share no point. They are those of the first feature, in
/// canonical order, whose distance rounds to the pair's rounded distance. Each coordinate is
/// rounded once, to the nearest finite double (ties to even; see `nearest_double`).
struct NearestPoints {
    Vec3 origin; ///< The first corner of A in the world.
    Vec3 of_a;   ///< The exact point of A minus `origin`.
    Vec3 of_b;   ///< The exact point of B minus `origin`.
    std::uint8_t feature = 0;
};

} // namespace cd
