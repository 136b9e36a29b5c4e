// Tells which pairs of subtrees are far apart, by spheres around them.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/search/subtree_pair.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Spheres around the subtrees of pairs. A motion has many pairs, of which a single pose needs
/// few. Testing a pair's spheres takes some nanoseconds, far less than searching its subtrees.
class PairSpheres {
  public:
    explicit PairSpheres(std::span<const SubtreePair> pairs);

    /// Moves the bodies. Pairs whose triangles are all farther apart than `distance` in the world
    /// may be left out from now on.
    void place(const PosePair& poses, double distance);
    /// False only for a pair that may be left out, by its index in the pairs of the constructor.
    [[nodiscard]] bool may_be_within(std::size_t pair) const {
        const Pair& spheres = pairs_[pair];
        const Vec3 between = places_[1][spheres.b] - places_[0][spheres.a];
        const double reach = spheres.reach + reach_;
        // If a number is NaN or infinite, nothing is proven.
        return !(between.squaredNorm() > reach * reach);
    }

  private:
    /// The subtrees of a pair in `centers_`, and how far apart their centres can be while the
    /// spheres meet.
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        double reach = 0;
    };

    std::vector<Pair> pairs_;
    std::array<std::vector<Vec3>, 2> centers_; ///< Of each subtree of A and of B, in the body.
    std::array<std::vector<Vec3>, 2> places_;  ///< The same in the world.
    double size_ = 0;                          ///< Largest coordinate of a centre.
    double reach_ = 0;
};

} // namespace cd
