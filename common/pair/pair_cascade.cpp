#include "common/pair/pair_cascade.hpp"

#include "common/pair/pair_decision.hpp"
#include "common/pair/poses/plain_poses.hpp"

#include <algorithm>

namespace cd {

/// Proves the signs of one pair in the stages after doubles. Each stage converts the corners when
/// it is first asked for a sign. If no stage proves a sign, `are_enough` is false from then on, and
/// all answers are meaningless; they end the decision quickly.
class LaterSigns {
  public:
    LaterSigns(PairCascade& stages, const Corners& a, const Corners& b)
        : stages_(stages), a_(a), b_(b) {}

    [[nodiscard]] bool are_enough() const { return enough_; }
    /// Returns the highest stage used.
    [[nodiscard]] PairStage reached() const { return reached_; }

    [[nodiscard]] PlaneSides sides(PlaneSides known, std::size_t plane, std::size_t corners) {
        if (const DoubleDoubleSigns* const signs = double_double()) {
            known = signs->sides(known, plane, corners);
            if (!is_any_unknown(known)) {
                return known;
            }
        }
        const IntegerCorners* const signs = integers();
        return signs == nullptr ? PlaneSides{1, 1, 1} : signs->sides(known, plane, corners);
    }
    [[nodiscard]] int edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) {
        return proven([&](const auto& signs) { return signs.edge_side(i, i_to, j, j_to); });
    }
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) {
        return proven([&](const auto& signs) { return signs.turn(i, j, k, axis); });
    }
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) {
        return proven([&](const auto& signs) { return signs.difference(i, j, axis); });
    }

  private:
    template <class Ask>
    int proven(const Ask& ask) {
        if (const DoubleDoubleSigns* const signs = double_double()) {
            if (const int sign = ask(*signs); sign != unknown_sign) {
                return sign;
            }
        }
        const IntegerCorners* const signs = integers();
        return signs == nullptr ? 1 : ask(*signs);
    }

    [[nodiscard]] const DoubleDoubleSigns* double_double() {
        if (!double_double_) {
            const DoubleDoublePoses* const poses = stages_.in_double_double();
            if (poses == nullptr) {
                return nullptr;
            }
            double_double_.emplace(*poses, a_, b_);
            reached_ = std::max(reached_, PairStage::DoubleDouble);
        }
        return &*double_double_;
    }

    [[nodiscard]] const IntegerCorners* integers() {
        if (!are_integers_placed_) {
            IntegerTrianglePair* const pair = stages_.in_integers();
            enough_ = enough_ && pair != nullptr && pair->place(a_, b_, integers_);
            if (!enough_) {
                return nullptr;
            }
            are_integers_placed_ = true;
            reached_ = std::max(reached_, pair->stage());
        }
        return &integers_;
    }

    PairCascade& stages_;
    const Corners& a_;
    const Corners& b_;
    std::optional<DoubleDoubleSigns> double_double_;
    IntegerCorners integers_;
    bool are_integers_placed_ = false;
    bool enough_ = true;
    PairStage reached_ = PairStage::Double;
};

namespace {

/// Proves no sign. Replaces the double stage in a cascade that skips that stage.
struct NoSigns {
    [[nodiscard]] static PlaneSides sides_of_a() { return unknown_sides; }
    [[nodiscard]] static PlaneSides sides_of_b() { return unknown_sides; }
    [[nodiscard]] static int edge_side(std::size_t, std::size_t, std::size_t, std::size_t) {
        return unknown_sign;
    }
    [[nodiscard]] static int turn(std::size_t, std::size_t, std::size_t, std::size_t) {
        return unknown_sign;
    }
    [[nodiscard]] static PlaneSides turns(std::size_t, std::size_t, std::size_t) {
        return unknown_sides;
    }
    [[nodiscard]] static int difference(std::size_t, std::size_t, std::size_t) {
        return unknown_sign;
    }
};

/// Models CornerSigns: asks doubles for a sign first, then the later stages.
template <class InDouble>
class CascadeSigns {
  public:
    CascadeSigns(const InDouble& in_double, LaterSigns& later)
        : in_double_(in_double), later_(later) {}

    [[nodiscard]] PlaneSides sides_of_a() {
        const PlaneSides of_a = in_double_.sides_of_a();
        if (!is_any_unknown(of_a)) {
            return of_a;
        }
        of_b_ = in_double_.sides_of_b();
        // If B lies strictly on one side of A's plane, the pair is Separate: `decide_pair`
        // concludes that from the sides of B as well as from those of A.
        if (pair_decision::is_one_sided(*of_b_)) {
            return *of_b_;
        }
        return later_.sides(of_a, 3, 0);
    }
    [[nodiscard]] PlaneSides sides_of_b() {
        const PlaneSides of_b = of_b_ ? *of_b_ : in_double_.sides_of_b();
        return is_any_unknown(of_b) ? later_.sides(of_b, 0, 3) : of_b;
    }
    [[nodiscard]] int edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) {
        const int sign = in_double_.edge_side(i, i_to, j, j_to);
        return sign == unknown_sign ? later_.edge_side(i, i_to, j, j_to) : sign;
    }
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) {
        const int sign = in_double_.turn(i, j, k, axis);
        return sign == unknown_sign ? later_.turn(i, j, k, axis) : sign;
    }
    [[nodiscard, gnu::always_inline]] PlaneSides
    turns(std::size_t i, std::size_t j, std::size_t axis, int enough) {
        PlaneSides turns = in_double_.turns(i, j, axis);
        if (is_any_unknown(turns)) {
            finish(turns, i, j, axis, enough);
        }
        return turns;
    }
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) {
        const int sign = in_double_.difference(i, j, axis);
        return sign == unknown_sign ? later_.difference(i, j, axis) : sign;
    }

  private:
    void finish(PlaneSides& turns, std::size_t i, std::size_t j, std::size_t axis, int enough) {
        const std::size_t others = i < 3 ? 3 : 0;
        for (std::size_t k = 0; k < 3 && !pair_decision::is_any(turns, enough); ++k) {
            if (turns[k] == unknown_sign) {
                turns[k] = later_.turn(i, j, others + k, axis);
            }
        }
    }

    const InDouble& in_double_;
    LaterSigns& later_;
    std::optional<PlaneSides> of_b_;
};

template <class InDouble>
PairClass decide(const InDouble& in_double, LaterSigns& later) {
    CascadeSigns signs(in_double, later);
    return decide_pair(signs);
}

} // namespace

PairCascade::PairCascade(const PosePair& poses, PairStage first)
    : given_(poses), plain_(plain_poses(poses)), first_(first), in_integers_(plain_, first) {}

PairCascade::Decision PairCascade::classify(const Corners& a, const Corners& b) {
    if (const auto decided = in_integers_.classify_short(a, b)) {
        return {*decided, PairStage::Lattice};
    }
    LaterSigns later(*this, a, b);
    PairClass kind{};
    if (first_ > PairStage::Double) {
        kind = decide(NoSigns(), later);
    } else {
        if (!in_double_) {
            in_double_.emplace(plain_);
        }
        kind = in_double_->with_signs(a, b, [&](const auto& s) { return decide(s, later); });
    }
    if (later.are_enough()) {
        return {kind, later.reached()};
    }
    if (!exact_) {
        exact_ = std::make_unique<ExactTrianglePair>(given_);
    }
    return {exact_->classify(a, b), PairStage::Arbitrary};
}

/// Returns null if the double-double stage is skipped: because of `first`, or because integers are
/// cheaper (no relative rotation, or both rotations consist of short whole numbers).
const DoubleDoublePoses* PairCascade::in_double_double() {
    if (!passes_over_double_double_) {
        passes_over_double_double_ = first_ > PairStage::DoubleDouble ||
                                     in_integers_.stage() == PairStage::Lattice ||
                                     (is_short(plain_.a) && is_short(plain_.b));
    }
    if (*passes_over_double_double_) {
        return nullptr;
    }
    if (!in_double_double_) {
        in_double_double_.emplace(plain_);
    }
    return &*in_double_double_;
}

IntegerTrianglePair* PairCascade::in_integers() {
    return first_ <= PairStage::WideInteger ? &in_integers_ : nullptr;
}

} // namespace cd
