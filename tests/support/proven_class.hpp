// Decides pairs by one stage of the product alone.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/pair/poses/plain_poses.hpp"
#include "common/pair/stages/double/double_triangle_pair.hpp"
#include "common/pair/stages/double_double/double_double_signs.hpp"
#include "common/pair/stages/integer/integer_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"

#include <cstddef>
#include <optional>

namespace cd::tests {

/// Models CornerSigns with the signs that `signs` proves. Once an unproven sign is asked for,
/// `are_enough` is false, and all answers are meaningless; they end the decision quickly.
template <class Signs>
class ProvenSigns {
  public:
    explicit ProvenSigns(const Signs& signs) : signs_(signs) {}

    [[nodiscard]] bool are_enough() const { return enough_; }

    [[nodiscard]] PlaneSides sides_of_a() { return proven(signs_.sides_of_a()); }
    [[nodiscard]] PlaneSides sides_of_b() { return proven(signs_.sides_of_b()); }
    [[nodiscard]] int edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) {
        return proven(signs_.edge_side(i, i_to, j, j_to));
    }
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) {
        return proven(signs_.turn(i, j, k, axis));
    }
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) {
        return proven(signs_.difference(i, j, axis));
    }

  private:
    [[nodiscard]] int proven(int sign) {
        enough_ = enough_ && sign != unknown_sign;
        return sign;
    }
    [[nodiscard]] PlaneSides proven(const PlaneSides& sides) {
        enough_ = enough_ && !is_any_unknown(sides);
        return enough_ ? sides : PlaneSides{1, 1, 1};
    }

    const Signs& signs_;
    bool enough_ = true;
};

/// Returns the class that the signs prove; nothing if one that is needed is unproven.
template <class Signs>
std::optional<PairClass> proven_class(const Signs& signs) {
    ProvenSigns proven(signs);
    const PairClass kind = decide_pair(proven);
    return proven.are_enough() ? std::optional(kind) : std::nullopt;
}

inline std::optional<PairClass>
proven_class(const DoubleTrianglePair& stage, const Corners& a, const Corners& b) {
    return stage.with_signs(a, b, [](const auto& signs) { return proven_class(signs); });
}

inline std::optional<PairClass> proven_in_double(const PosePair& poses,
                                                 const Corners& a,
                                                 const Corners& b,
                                                 double bound_scale = 1) {
    return proven_class(DoubleTrianglePair(plain_poses(poses), bound_scale), a, b);
}

inline std::optional<PairClass> proven_in_double_double(const PosePair& poses,
                                                        const Corners& a,
                                                        const Corners& b,
                                                        double bound_scale = 1) {
    const DoubleDoublePoses plain(plain_poses(poses));
    return proven_class(DoubleDoubleSigns(plain, a, b, bound_scale));
}

/// Returns nothing if the range of the corners exceeds sixteen words.
inline std::optional<PairClass>
decided_in_integers(const PosePair& poses, const Corners& a, const Corners& b) {
    IntegerTrianglePair stage(plain_poses(poses));
    if (const auto decided = stage.classify_short(a, b)) {
        return decided;
    }
    IntegerCorners corners;
    return stage.place(a, b, corners) ? std::optional(decide_pair(corners)) : std::nullopt;
}

} // namespace cd::tests
