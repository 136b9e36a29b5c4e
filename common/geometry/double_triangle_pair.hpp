// The double stage of the decision: signs with error bounds. It proves an answer or gives none.
#pragma once

#include "common/geometry/pair_decision.hpp"
#include "common/geometry/triangle_pair.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// A pose's linear part in doubles, with what its use costs in exactness.
struct RoundedRotation {
    Mat3 matrix;
    double entry_error = 0;   ///< Bounds the error of each entry.
    double entry_largest = 0; ///< Bounds each entry, rounded or true.
    bool is_identity = false; ///< Then using it rounds nothing.

    explicit RoundedRotation(const Pose& pose);
};

/// Two poses in doubles.
struct RoundedPoses {
    RoundedRotation a;
    RoundedRotation b;
    Vec3 translation_a;
    Vec3 translation_b;
    Vec3 offset;                ///< ta - tb, rounded once.
    bool are_unrotated = false; ///< A not at all, and B but for its axes' order and directions.
    bool are_unmoved = false;   ///< Nor moved against each other.

    explicit RoundedPoses(const PosePair& poses);
};

/// A vector in doubles; `size` bounds its components and, in units of 2.01 * 2^-53, their errors.
struct RoundedVec {
    Vec3 value;
    Vec3 size;
};

/// The signs of one pair that doubles prove; `unknown_sign` for the others. Refers to its
/// arguments.
class DoubleSigns {
  public:
    DoubleSigns(const RoundedPoses& poses, const Corners& a, const Corners& b, double bound_scale);

    [[nodiscard]] PlaneSides sides_of_a() const;
    [[nodiscard]] PlaneSides sides_of_b() const;
    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const;
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const;
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const;

  private:
    [[nodiscard]] const Vec3& corner(std::size_t i) const { return i < 3 ? a_[i] : b_[i - 3]; }
    /// x_to - x_from.
    [[nodiscard]] RoundedVec between(std::size_t from, std::size_t to) const;
    [[nodiscard]] RoundedVec between_posed(std::size_t from, std::size_t to) const;
    [[nodiscard]] RoundedVec between_moved(std::size_t from, std::size_t to) const;
    void rotate();

    struct Rotated {
        Vec3 value;
        double error = 0; ///< Bounds the error of each component.
    };
    [[nodiscard]] static Rotated
    rotated(const RoundedRotation& rotation, const Vec3& x, double relative);

    const RoundedPoses& poses_;
    const Corners& a_;
    Corners b_; ///< With their axes as A's if the bodies are unrotated.
    double scale_;
    std::array<Rotated, 6>
        from_first_; ///< Of rotated bodies: each corner from its triangle's first.
    Rotated apart_;  ///< And B's first from A's.
};

class DoubleTrianglePair {
  public:
    /// All error bounds are multiplied by `bound_scale`, for tests that these have teeth.
    explicit DoubleTrianglePair(const PosePair& poses, double bound_scale = 1);

    /// What is proven of the pair under the exact poses; nothing where rounding leaves it open.
    /// Never allocates.
    [[nodiscard]] std::optional<PairClass> classify(const Corners& a, const Corners& b) const;

    /// The proven signs of one pair.
    [[nodiscard]] DoubleSigns signs(const Corners& a, const Corners& b) const;

  private:
    RoundedPoses poses_;
    double bound_scale_;
};

/// Models CornerSigns from what `signs` has proven, until an unproven sign is asked for: then the
/// answers mean nothing any more, and lead to a quick end.
template <class Signs>
class ProvenSigns {
  public:
    explicit ProvenSigns(const Signs& signs) : signs_(signs) {}

    [[nodiscard]] bool are_enough() const { return enough_; }
    /// As far as they have been asked for and are proven.
    [[nodiscard]] const PlaneSides& known_of_a() const { return of_a_; }
    [[nodiscard]] const PlaneSides& known_of_b() const { return of_b_; }

    [[nodiscard]] PlaneSides sides_of_a() { return proven(of_a_ = signs_.sides_of_a()); }
    [[nodiscard]] PlaneSides sides_of_b() { return proven(of_b_ = signs_.sides_of_b()); }
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
    PlaneSides of_a_ = unknown_sides;
    PlaneSides of_b_ = unknown_sides;
};

} // namespace cd
