#include "common/tree/build/build_bins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval nothing{infinity, -infinity};

void extend_interval(Interval& whole, const Interval& part) {
    whole.low = std::min(whole.low, part.low);
    whole.high = std::max(whole.high, part.high);
}

} // namespace

BinScale::BinScale(const Interval& whole)
    : low_(whole.low), factor_(bin_count / (whole.high - whole.low)) {
    if (!std::isfinite(factor_)) {
        factor_ = 0;
    }
}

Bins::Bins(const Projection& whole)
    : scales_{BinScale(whole[0]), BinScale(whole[1]), BinScale(whole[2])}, whole_(whole) {
    for (Axis& axis : axes_) {
        axis.fill({nothing, 0});
    }
}

void Bins::add(std::span<const Projection> triangles) {
    for (const Projection& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            Bin& bin = axes_[k][scales_[k].bin_of(triangle[k])];
            extend_interval(bin.extent, triangle[k]);
            ++bin.count;
        }
    }
}

Bins& Bins::operator+=(const Bins& other) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < BinScale::bin_count; ++i) {
            extend_interval(axes_[k][i].extent, other.axes_[k][i].extent);
            axes_[k][i].count += other.axes_[k][i].count;
        }
    }
    return *this;
}

std::optional<Bins::Candidate> Bins::best(std::size_t axis, std::uint32_t side) const {
    if (!scales_[axis].is_valid()) {
        return std::nullopt;
    }
    const Axis& bins = axes_[axis];
    // low_from[i] is where the second child begins if the split is before bin i; `count` becomes
    // the number of all triangles.
    std::array<double, BinScale::bin_count> low_from{};
    double low = infinity;
    std::uint32_t count = 0;
    for (std::size_t i = BinScale::bin_count; i-- > 0;) {
        low = std::min(low, bins[i].extent.low);
        low_from[i] = low;
        count += bins[i].count;
    }
    const double length = whole_[axis].high - whole_[axis].low;
    std::optional<Candidate> best;
    Interval first = nothing;
    std::uint32_t left = 0;
    for (std::uint32_t i = 0; i + 1 < BinScale::bin_count; ++i) {
        extend_interval(first, bins[i].extent);
        left += bins[i].count;
        if (bins[i].count == 0 || left < side || count - left < side) {
            continue;
        }
        const double sum =
            ((first.high - first.low) + (whole_[axis].high - low_from[i + 1])) / length;
        if (!best || sum < best->sum) {
            best = {sum, i, left};
        }
    }
    return best;
}

} // namespace cd
