// Decides how a segment meets a triangle from the signs of a few determinants. All stages share
// this procedure.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/shots/line_hit.hpp"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace cd {

/// Provides signs (-1, 0, 1) of a triangle with corners v_0 to v_2 and a segment from p to q, in
/// the world, with d = q - p and n for the triangle's normal.
template <class T>
concept HitSigns = requires(T signs, std::size_t i) {
    /// The signs of n.(p - v_0) and n.(q - v_0).
    { signs.sides() } -> std::same_as<std::array<int, 2>>;
    /// The sign of det(d, v_i - p, v_i+1 - p).
    { signs.edge(i) } -> std::same_as<int>;
    /// The sign of a component of d x (v_i+1 - v_i).
    { signs.tie(i, i) } -> std::same_as<int>;
};

/// How a segment meets a triangle.
struct HitDecision {
    enum class How : std::uint8_t {
        Apart,   ///< Shares no point.
        Through, ///< Shares one point with a triangle whose plane does not contain the segment.
        InPlane, ///< Lies in the triangle's plane, or the triangle has no area; they may be apart.
    };
    How how = How::Apart;
    std::uint8_t flags = 0; ///< Set if Through.
    bool is_at_p = false;   ///< True if Through, and p is the shared point.
    bool is_at_q = false;   ///< True if Through, and q is the shared point.
    /// Bit i is set if Through, and the shared point is on the line through v_i and v_i+1: two bits
    /// for a corner.
    std::uint8_t edges = 0;
};

/// Returns the side on which an edge passes a line that meets it, once the line is moved by (eps,
/// eps^2, eps^3). The determinant det(d, v_i - p, v_j - p) then grows by that vector's scalar
/// product with d x (v_j - v_i), and its first component other than 0 decides. There is one, as a
/// line that passes through the plane is not parallel to an edge in it.
template <HitSigns Signs>
[[nodiscard]] int moved_side(Signs& signs, std::size_t edge) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (const int sign = signs.tie(edge, axis); sign != 0) {
            return sign;
        }
    }
    return 0;
}

/// Decides by simulation of simplicity (Edelsbrunner and Muecke, Simulation of Simplicity, 1990).
template <HitSigns Signs>
[[nodiscard]] HitDecision decide_hit(Signs& signs) {
    const auto [side_p, side_q] = signs.sides();
    if (side_p == 0 && side_q == 0) {
        return {HitDecision::How::InPlane};
    }
    if (side_p == side_q) {
        return {};
    }
    // The sum of the three edges' determinants is d.n, which is the difference of the sides.
    const int facing = side_q > side_p ? 1 : -1;
    std::array<int, 3> sides{};
    std::uint8_t edges = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sides[i] = signs.edge(i) * facing;
        if (sides[i] < 0) {
            return {};
        }
        edges |= sides[i] == 0 ? 1u << i : 0u;
    }
    HitDecision decision{HitDecision::How::Through, 0, side_p == 0, side_q == 0, edges};
    decision.flags = facing > 0 ? hit_flag::back : hit_flag::front;
    const int zeros = std::popcount(edges);
    decision.flags |= zeros == 0 ? 0 : zeros == 1 ? hit_flag::edge : hit_flag::corner;
    bool crosses = side_q != 0;
    for (std::size_t i = 0; i < 3 && crosses; ++i) {
        crosses = sides[i] > 0 || moved_side(signs, i) * facing > 0;
    }
    decision.flags |= crosses ? hit_flag::crosses : 0;
    return decision;
}

/// Models HitSigns with the signs that `Signs` proves. Once an unproven sign is asked for,
/// `are_enough` is false, and all answers are meaningless; they end the decision quickly.
template <class Signs>
class ProvenHitSigns {
  public:
    explicit ProvenHitSigns(const Signs& signs) : signs_(signs) {}

    [[nodiscard]] bool are_enough() const { return enough_; }

    [[nodiscard]] std::array<int, 2> sides() {
        const std::array<int, 2> sides = signs_.sides();
        enough_ = sides[0] != unknown_sign && sides[1] != unknown_sign;
        return enough_ ? sides : std::array<int, 2>{1, 1};
    }
    [[nodiscard]] int edge(std::size_t i) { return proven(signs_.edge(i)); }
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) { return proven(signs_.tie(i, axis)); }

  private:
    [[nodiscard]] int proven(int sign) {
        enough_ = enough_ && sign != unknown_sign;
        return enough_ ? sign : 1;
    }

    const Signs& signs_;
    bool enough_ = true;
};

} // namespace cd
