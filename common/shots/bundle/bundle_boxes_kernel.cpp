#include "common/shots/bundle/bundle_boxes_kernel.hpp"

#include "common/geometry/highway_targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_boxes_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/shots/bundle/bundle_lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using bundle::bits_of;

using Floats = hn::CappedTag<float, wide_children_max>;

HWY_INLINE hn::Vec<Floats> load_bytes(const WideNode::Bytes& bytes, std::size_t first) {
    const hn::Rebind<std::int32_t, Floats> whole;
    const hn::Rebind<std::uint8_t, Floats> small;
    return hn::ConvertTo(Floats(), hn::PromoteTo(whole, hn::LoadU(small, bytes.data() + first)));
}

/// Returns the places of coordinates from the middle.
HWY_INLINE hn::Vec<Floats>
place_of(const LinesAcross::Axis& axis, hn::Vec<Floats> coordinate, float slack) {
    const Floats d;
    return hn::Add(hn::Mul(coordinate, hn::Set(d, axis.per_length)),
                   hn::Set(d, axis.first_bin + slack));
}

/// Returns the places of coordinates from the middle, rounded to whole bins.
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, Floats>>
bin_of(const LinesAcross::Axis& axis, hn::Vec<Floats> coordinate, float slack) {
    const Floats d;
    const auto place = place_of(axis, coordinate, slack);
    const auto last = hn::Set(d, static_cast<float>(axis.last));
    return hn::ConvertTo(hn::Rebind<std::int32_t, Floats>(),
                         hn::Min(hn::Max(place, hn::Zero(d)), last));
}

/// Returns the children in whose interval on an axis some column or row of a grid may be.
HWY_INLINE hn::Mask<Floats>
holds_a_step(const LinesAcross::Axis& axis, hn::Vec<Floats> low, hn::Vec<Floats> high) {
    const Floats d;
    const auto first = hn::Max(hn::Ceil(place_of(axis, low, -axis.slack)), hn::Zero(d));
    const auto last = hn::Min(hn::Floor(place_of(axis, high, axis.slack)),
                              hn::Set(d, static_cast<float>(axis.last)));
    return hn::Le(first, last);
}

/// Returns the children of which some line has a coordinate in the interval on an axis.
HWY_INLINE hn::Mask<Floats>
holds_a_line(const LinesAcross::Axis& axis, hn::Vec<Floats> low, hn::Vec<Floats> high) {
    const Floats d;
    const hn::Rebind<std::int32_t, Floats> whole;
    const auto half = hn::Set(d, axis.half);
    const auto overlaps = hn::And(hn::Le(low, half), hn::Ge(high, hn::Neg(half)));
    const auto first = bin_of(axis, low, -axis.slack);
    const auto last = bin_of(axis, high, axis.slack);
    const auto is_below = hn::Le(low, hn::GatherIndex(d, axis.most, first));
    const auto is_above = hn::Ge(high, hn::GatherIndex(d, axis.least, last));
    const auto is_one = hn::RebindMask(d, hn::Eq(first, last));
    const auto is_between = hn::RebindMask(d, hn::Gt(hn::Sub(last, first), hn::Set(whole, 1)));
    const auto both = hn::And(is_below, is_above);
    const auto any = hn::Or(hn::Or(is_below, is_above), is_between);
    return hn::And(overlaps, hn::Or(hn::And(is_one, both), hn::AndNot(is_one, any)));
}

std::uint32_t children_with_lines_on(const WideNode* node,
                                     const NodeAcross* across,
                                     const LinesAcross* lines,
                                     ChildrenAcross* boxes) {
    const Floats d;
    std::uint32_t mask = 0;
    for (std::size_t first = 0; first < wide_children_max; first += hn::Lanes(d)) {
        auto held = hn::Eq(hn::Zero(d), hn::Zero(d));
        for (std::size_t which = 0; which < 2; ++which) {
            const NodeAcross::Axis& axis = across->axes[which];
            hn::Vec<Floats> low = hn::Set(d, axis.base - axis.margin);
            hn::Vec<Floats> high = hn::Set(d, axis.base + axis.margin);
            for (std::size_t k = 0; k < 3; ++k) {
                const bool rises = axis.steps[k] >= 0;
                const auto step = hn::Set(d, axis.steps[k]);
                const auto lesser = load_bytes(rises ? node->low[k] : node->high[k], first);
                const auto greater = load_bytes(rises ? node->high[k] : node->low[k], first);
                low = hn::Add(low, hn::Mul(step, lesser));
                high = hn::Add(high, hn::Mul(step, greater));
            }
            hn::Store(low, d, &boxes->low[which][first]);
            hn::Store(high, d, &boxes->high[which][first]);
            const LinesAcross::Axis& of = lines->axes[which];
            held = hn::And(
                held, lines->is_grid ? holds_a_step(of, low, high) : holds_a_line(of, low, high));
        }
        mask |= bits_of(d, held) << first;
    }
    return mask;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(children_with_lines_on);

/// With v = 2^-24 and n for the count of bins: places that count are within n of 0, so that their
/// product and sum err by at most 2 v n, and the coordinate, the middle's place and the factor by v
/// n each; places are clamped in the end. 16 v n has room.
LinesAcross lines_across(const ParallelLines& lines) {
    LinesAcross across;
    across.is_grid = lines.is_grid();
    const std::array<double, 2> middle = lines.middle();
    const std::array<float, 2> half = lines.half();
    for (std::size_t which = 0; which < 2; ++which) {
        const LineSteps& steps = lines.steps(which);
        LinesAcross::Axis& axis = across.axes[which];
        axis.half = half[which];
        const double per_length = across.is_grid ? steps.steps_per_length : steps.bins_per_length;
        axis.first_bin = static_cast<float>((middle[which] - lines.least()[which]) * per_length);
        axis.per_length = static_cast<float>(per_length);
        axis.slack = 0x1p-20F * static_cast<float>(steps.count()) +
                     (across.is_grid ? 1.01F * static_cast<float>(steps.slack) : 0);
        axis.last = static_cast<std::int32_t>(steps.count() - 1);
        axis.least = steps.least_from_middle.data();
        axis.most = steps.most_from_middle.data();
    }
    return across;
}

std::uint32_t children_with_lines(const WideNode& node,
                                  const NodeAcross& across,
                                  const LinesAcross& lines,
                                  ChildrenAcross& boxes) {
    return HWY_DYNAMIC_DISPATCH(children_with_lines_on)(&node, &across, &lines, &boxes);
}

} // namespace cd

#endif
