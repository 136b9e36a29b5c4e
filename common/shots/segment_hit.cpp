#include "common/shots/segment_hit.hpp"

#include "common/pair/stages/double_double/double_double_triangle_pair.hpp"
#include "common/shots/hit_decision.hpp"
#include "common/shots/segment_length.hpp"
#include "common/shots/stages/double/double_hit.hpp"
#include "common/shots/stages/double_double/double_double_depth.hpp"
#include "common/shots/stages/exact/exact_hit.hpp"
#include "common/shots/stages/integer/integer_hit.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace cd {

std::string_view to_text(HitStage stage) {
    constexpr std::array<std::string_view, hit_stage_count> names{
        "double", "double-double", "integer", "exact"};
    return names[static_cast<std::size_t>(stage)];
}

HitStatistics& HitStatistics::operator+=(const HitStatistics& other) {
    for (std::size_t i = 0; i < hit_stage_count; ++i) {
        decisions[i] += other.decisions[i];
        depths[i] += other.depths[i];
    }
    ties += other.ties;
    return *this;
}

namespace {

/// The stages under one pair of poses. Each prepares the poses when first used.
struct HitStages {
    PosePair poses;
    HitStage first;
    std::optional<DoubleHit> in_double;
    std::optional<DoubleDoublePoses> in_double_double;
    std::optional<DoubleDoubleDepth> depth;
    std::optional<IntegerHit> in_integers;
    std::optional<ExactHit> exact;

    HitStages(const PosePair& given, HitStage first_stage) : poses(given), first(first_stage) {}

    [[nodiscard]] bool has(HitStage stage) const { return first <= stage; }

    template <class Stage>
    [[nodiscard]] Stage& made(std::optional<Stage>& stage) {
        return stage ? *stage : stage.emplace(poses);
    }
};

/// Proves the signs of one triangle and segment that doubles leave open. If no stage proves one,
/// `are_enough` is false from then on, and all answers are meaningless.
class LaterHitSigns {
  public:
    LaterHitSigns(HitStages& stages, const Corners& a, const Segment& line)
        : stages_(stages), a_(a), line_(line) {}

    [[nodiscard]] bool are_enough() const { return enough_; }
    /// Returns the highest stage used.
    [[nodiscard]] HitStage reached() const { return reached_; }

    [[nodiscard]] std::array<int, 2> sides() {
        if (const DoubleDoubleSigns* const signs = double_double()) {
            const PlaneSides sides = signs->sides({unknown_sign, unknown_sign, 0}, 0, 3);
            if (!is_any_unknown(sides)) {
                return {sides[0], sides[1]};
            }
        }
        const IntegerHitSigns* const signs = integers();
        return signs == nullptr ? std::array<int, 2>{1, 1} : signs->sides();
    }
    [[nodiscard]] int edge(std::size_t i) {
        if (const DoubleDoubleSigns* const signs = double_double()) {
            if (const int sign = signs->edge_side(3, 4, i, (i + 1) % 3); sign != unknown_sign) {
                return sign;
            }
        }
        const IntegerHitSigns* const signs = integers();
        return signs == nullptr ? 1 : signs->edge(i);
    }
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) {
        const IntegerHitSigns* const signs = integers();
        return signs == nullptr ? 1 : signs->tie(i, axis);
    }

  private:
    [[nodiscard]] const DoubleDoubleSigns* double_double() {
        if (!stages_.has(HitStage::DoubleDouble)) {
            return nullptr;
        }
        if (!double_double_) {
            double_double_.emplace(stages_.made(stages_.in_double_double), a_, line_.corners());
            reached_ = std::max(reached_, HitStage::DoubleDouble);
        }
        return &*double_double_;
    }
    [[nodiscard]] const IntegerHitSigns* integers() {
        if (!integers_ && enough_ && stages_.has(HitStage::Integer)) {
            integers_ = stages_.made(stages_.in_integers).place(a_, line_);
            reached_ = HitStage::Integer;
        }
        enough_ = integers_.has_value();
        return enough_ ? &*integers_ : nullptr;
    }

    HitStages& stages_;
    const Corners& a_;
    const Segment& line_;
    std::optional<DoubleDoubleSigns> double_double_;
    std::optional<IntegerHitSigns> integers_;
    bool enough_ = true;
    HitStage reached_ = HitStage::Double;
};

/// Proves no sign. Replaces the double stage where that is skipped.
struct NoHitSigns {
    [[nodiscard]] static std::array<int, 2> sides() { return {unknown_sign, unknown_sign}; }
    [[nodiscard]] static int edge(std::size_t) { return unknown_sign; }
    [[nodiscard]] static int tie(std::size_t, std::size_t) { return unknown_sign; }
};

/// Models HitSigns: asks doubles for a sign first, then the later stages.
template <class InDouble>
class CascadeHitSigns {
  public:
    CascadeHitSigns(const InDouble& in_double, LaterHitSigns& later)
        : in_double_(in_double), later_(later) {}

    [[nodiscard]] std::array<int, 2> sides() {
        const std::array<int, 2> sides = in_double_.sides();
        return sides[0] == unknown_sign || sides[1] == unknown_sign ? later_.sides() : sides;
    }
    [[nodiscard]] int edge(std::size_t i) {
        const int sign = in_double_.edge(i);
        return sign == unknown_sign ? later_.edge(i) : sign;
    }
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) {
        const int sign = in_double_.tie(i, axis);
        return sign == unknown_sign ? later_.tie(i, axis) : sign;
    }

  private:
    const InDouble& in_double_;
    LaterHitSigns& later_;
};

template <class InDouble>
HitDecision decide(const InDouble& in_double, LaterHitSigns& later) {
    CascadeHitSigns signs(in_double, later);
    return decide_hit(signs);
}

bool is_earlier_at_one_place(const LineHit& l, const LineHit& r) {
    return std::pair(order_at_one_depth(l.flags), l.triangle) <
           std::pair(order_at_one_depth(r.flags), r.triangle);
}

/// The corner or edge at which a line passes through a triangle: the ends of the edge, the
/// lexicographically lesser first, or the corner twice. A line meets an edge that it does not lie
/// in, and a corner, in one point, so hits at one border have one exact depth.
struct Border {
    Vec3 from;
    Vec3 to;

    friend bool operator==(const Border& l, const Border& r) {
        return l.from == r.from && l.to == r.to;
    }
};

/// Returns the border for `HitDecision::edges`; nothing for a point inside.
std::optional<Border> border_of(std::uint8_t edges, const Corners& a) {
    switch (edges) {
    case 0b011:
        return Border{a[1], a[1]};
    case 0b110:
        return Border{a[2], a[2]};
    case 0b101:
        return Border{a[0], a[0]};
    case 0b000:
        return std::nullopt;
    default:
        break;
    }
    const auto i = static_cast<std::size_t>(std::countr_zero(edges));
    const Vec3& from = a[i];
    const Vec3& to = a[(i + 1) % 3];
    const bool is_ordered =
        std::lexicographical_compare(from.begin(), from.end(), to.begin(), to.end());
    return is_ordered ? Border{from, to} : Border{to, from};
}

struct ExactlyHit {
    ExactShare share;
    LineHit hit;
};

bool is_exactly_earlier(const ExactlyHit& l, const ExactlyHit& r) {
    const int order = l.share.compare(r.share);
    return order != 0 ? order < 0 : is_earlier_at_one_place(l.hit, r.hit);
}

} // namespace

struct SegmentHit::State {
    HitStages stages;
    HitStatistics statistics;
    std::vector<LineHit> hits;    ///< Of the last line.
    std::vector<ExactlyHit> tied; ///< Hits of the last depth that several hits round to.
    std::vector<std::optional<Border>> borders; ///< By triangle; empty for other hits.

    State(const PosePair& poses, HitStage first) : stages(poses, first) {}

    /// Finds a hit in integers, and counts it for the given answers.
    std::optional<ExactHit::Found> find(const Corners& a,
                                        const Segment& line,
                                        std::array<std::uint64_t, hit_stage_count>& settled) {
        ++settled[static_cast<std::size_t>(HitStage::Exact)];
        return stages.made(stages.exact).find(a, line);
    }

    /// Returns the decision, and Apart or Through if a stage before Exact settles it; else nothing.
    std::optional<HitDecision> decision(const Corners& a, const Segment& line) {
        LaterHitSigns later(stages, a, line);
        const HitDecision made =
            stages.has(HitStage::Double)
                ? stages.made(stages.in_double)
                      .with_signs(a, line, [&](const auto& signs) { return decide(signs, later); })
                : decide(NoHitSigns(), later);
        if (!later.are_enough() || made.how == HitDecision::How::InPlane) {
            return std::nullopt;
        }
        ++statistics.decisions[static_cast<std::size_t>(later.reached())];
        return made;
    }

    /// Adds the hit of a triangle, if there is one.
    void add(std::uint32_t place, const Corners& a, const Segment& line, double length) {
        const std::optional<HitDecision> made = decision(a, line);
        if (!made) {
            if (const auto found = find(a, line, statistics.decisions)) {
                hits.push_back({place, found->flags, 0, rounded_depth(found->share, length)});
            }
        } else if (made->how == HitDecision::How::Through) {
            hits.push_back({place, made->flags, 0, depth(*made, a, line, length)});
            borders[place] = border_of(made->edges, a);
        }
    }

    double depth(const HitDecision& made, const Corners& a, const Segment& line, double length) {
        if (made.is_at_p || made.is_at_q) {
            return made.is_at_p ? 0 : length;
        }
        if (stages.has(HitStage::DoubleDouble)) {
            if (const auto rounded = stages.depth->depth(a)) {
                ++statistics.depths[static_cast<std::size_t>(HitStage::DoubleDouble)];
                return *rounded;
            }
        }
        return rounded_depth(find(a, line, statistics.depths)->share, length);
    }

    /// Returns whether hits are plainly at one exact depth: at one border, or on triangles with the
    /// same corners.
    [[nodiscard]] bool are_at_one_place(std::span<const LineHit> alike,
                                        std::span<const Corners> a) const {
        const std::uint32_t one = alike.front().triangle;
        const std::optional<Border>& border = borders[one];
        return std::ranges::all_of(alike, [&](const LineHit& hit) {
            return (border && borders[hit.triangle] == border) ||
                   are_coincident(a[hit.triangle], a[one]);
        });
    }

    /// Orders hits of one rounded depth by their exact shares, and ranks them.
    void order(std::span<LineHit> alike, std::span<const Corners> a, const Segment& line) {
        statistics.ties += alike.size();
        if (are_at_one_place(alike, a)) {
            std::sort(alike.begin(), alike.end(), is_earlier_at_one_place);
            return;
        }
        tied.clear();
        for (const LineHit& hit : alike) {
            auto found = stages.made(stages.exact).find(a[hit.triangle], line);
            tied.push_back({std::move(found->share), hit});
        }
        std::sort(tied.begin(), tied.end(), is_exactly_earlier);
        std::uint8_t rank = 0;
        for (std::size_t i = 0; i < tied.size(); ++i) {
            const bool is_more = i > 0 && tied[i - 1].share.compare(tied[i].share) != 0;
            rank += is_more && rank < hit_rank_most ? 1 : 0;
            alike[i] = tied[i].hit;
            alike[i].rank = rank;
        }
    }
};

SegmentHit::SegmentHit(const PosePair& poses, HitStage first)
    : state_(std::make_unique<State>(poses, first)) {}
SegmentHit::SegmentHit(SegmentHit&&) noexcept = default;
SegmentHit& SegmentHit::operator=(SegmentHit&&) noexcept = default;
SegmentHit::~SegmentHit() = default;

void SegmentHit::restart(const PosePair& poses) {
    state_->stages = HitStages(poses, state_->stages.first);
    state_->statistics = {};
}

std::optional<std::uint8_t> SegmentHit::flags(const Corners& a, const Segment& line) {
    State& s = *state_;
    if (const auto made = s.decision(a, line)) {
        return made->how == HitDecision::How::Through ? std::optional(made->flags) : std::nullopt;
    }
    const auto found = s.find(a, line, s.statistics.decisions);
    return found ? std::optional(found->flags) : std::nullopt;
}

std::span<const LineHit> SegmentHit::hits(std::span<const Corners> a, const Segment& line) {
    State& s = *state_;
    const double length = segment_length(line);
    s.stages.made(s.stages.depth).set_line(line, length);
    s.hits.clear();
    s.borders.assign(a.size(), std::nullopt);
    for (std::size_t i = 0; i < a.size(); ++i) {
        s.add(static_cast<std::uint32_t>(i), a[i], line, length);
    }
    std::sort(s.hits.begin(), s.hits.end(), [](const LineHit& l, const LineHit& r) {
        return l.depth < r.depth;
    });
    for (auto from = s.hits.begin(); from != s.hits.end();) {
        const auto to = std::find_if(
            from, s.hits.end(), [&](const LineHit& hit) { return hit.depth != from->depth; });
        if (to - from > 1) {
            s.order({from, to}, a, line);
        }
        from = to;
    }
    return s.hits;
}

const HitStatistics& SegmentHit::statistics() const {
    return state_->statistics;
}

} // namespace cd
