#include "common/search/nearest_found.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace

NearestFound::NearestFound(const PosePair& poses, DistanceStage first, double up_to)
    : distance_(poses, first), up_to_(up_to) {}

void NearestFound::restart(const PosePair& poses) {
    distance_.restart(poses);
    triangle_tests_ = 0;
    upper_ = infinity;
    displacement_ = Vec3::Zero();
    open_.clear();
    if (const auto last = std::exchange(best_, std::nullopt)) {
        decide(*last);
        displacement_ = distance_.displacement(last->corners.a, last->corners.b);
    }
}

void NearestFound::forget_ignored(std::span<const IgnoredRange> ignored) {
    if (best_ && is_ignored(ignored, best_->a, best_->b)) {
        best_.reset();
    }
}

double NearestFound::bound() const {
    // A distance that is a little larger than the best one may still round to it.
    const double best = std::min(upper_, best_ ? best_->distance : infinity);
    return std::min(up_to_, std::nextafter(best, infinity));
}

/// Makes the pair the best one if it is.
void NearestFound::decide(const NearestPair& pair) {
    const double within = bound();
    const Corners& a = pair.corners.a;
    const Corners& b = pair.corners.b;
    if (std::isfinite(within) && !distance_.is_within(a, b, within)) {
        return;
    }
    const double distance = distance_.rounded(a, b);
    if (!best_ ||
        std::tie(distance, pair.a, pair.b) < std::tie(best_->distance, best_->a, best_->b)) {
        best_ = pair;
        best_->distance = distance;
    }
}

template <class Triangles>
void NearestFound::add(const Triangles& a,
                       std::span<const std::uint32_t> ids_a,
                       const Triangles& b,
                       std::span<const std::uint32_t> ids_b,
                       std::span<const Candidate> candidates) {
    triangle_tests_ += candidates.size();
    const auto [lower, upper] = distance_.bounds(a, b, candidates);
    const auto least = std::ranges::min_element(upper);
    if (least != upper.end() && double{*least} < upper_) {
        upper_ = double{*least};
        const Candidate& pair = candidates[static_cast<std::size_t>(least - upper.begin())];
        displacement_ = distance_.displacement(a.corners_at(pair.a), b.corners_at(pair.b));
    }
    double within = bound();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& pair = candidates[i];
        if (double{lower[i]} > within) {
            continue;
        }
        open_.push_back({double{lower[i]},
                         ids_a[pair.a],
                         ids_b[pair.b],
                         {a.corners_at(pair.a), b.corners_at(pair.b)}});
        if (upper[i] == std::numeric_limits<float>::infinity()) {
            decide(open_.back());
            open_.pop_back();
            within = bound();
        }
    }
}

void NearestFound::settle() {
    std::ranges::sort(open_, std::ranges::less(), &NearestPair::distance);
    for (const NearestPair& pair : open_) {
        if (pair.distance > bound()) {
            break;
        }
        decide(pair);
    }
    open_.clear();
}

template void NearestFound::add(const TriangleSpan&,
                                std::span<const std::uint32_t>,
                                const TriangleSpan&,
                                std::span<const std::uint32_t>,
                                std::span<const Candidate>);
template void NearestFound::add(const TriangleBlocks&,
                                std::span<const std::uint32_t>,
                                const TriangleBlocks&,
                                std::span<const std::uint32_t>,
                                std::span<const Candidate>);

} // namespace cd
