// Pairs of bodies whose hulls touch or nearly touch, in categories that are hard for planes.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"

#include <cstddef>
#include <random>
#include <string>

namespace cd::tests {

struct TouchingBodies {
    Mesh a;
    Mesh b;
    PosePair poses;
    Vec3 outwards; ///< The direction from A to B in the world in which their hulls nearly touch.
};

inline constexpr std::size_t touching_categories = 20;

/// Returns the name of a category.
[[nodiscard]] std::string touching_category(std::size_t category);

/// Makes two bodies of a category, whose hulls overlap or are apart by at most a few units in the
/// last place of a coordinate.
[[nodiscard]] TouchingBodies make_touching(std::size_t category, std::mt19937_64& random);

} // namespace cd::tests
