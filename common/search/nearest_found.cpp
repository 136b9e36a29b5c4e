#include "common/search/nearest_found.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace cd {

NearestFound::NearestFound(const PosePair& poses, DistanceStage first, double up_to)
    : distance_(poses, first), up_to_(up_to) {}

void NearestFound::restart(const PosePair& poses) {
    distance_.restart(poses);
    triangle_tests_ = 0;
    if (const auto last = std::exchange(best_, std::nullopt)) {
        add_pair(last->a, last->b, last->corners);
    }
}

double NearestFound::bound() const {
    // A distance that is a little larger than the best one may still round to it.
    const double best = best_ ? best_->distance : std::numeric_limits<double>::infinity();
    return std::min(up_to_, std::nextafter(best, std::numeric_limits<double>::infinity()));
}

void NearestFound::add_pair(std::uint32_t a, std::uint32_t b, const PairCorners& corners) {
    const double within = bound();
    if (std::isfinite(within) && !distance_.is_within(corners.a, corners.b, within)) {
        return;
    }
    const double distance = distance_.rounded(corners.a, corners.b);
    if (!best_ || std::tie(distance, a, b) < std::tie(best_->distance, best_->a, best_->b)) {
        best_ = NearestPair{distance, a, b, corners};
    }
}

template <class Triangles>
void NearestFound::add_pair(const Triangles& a,
                            std::span<const std::uint32_t> ids_a,
                            const Triangles& b,
                            std::span<const std::uint32_t> ids_b,
                            const Candidate& pair) {
    add_pair(ids_a[pair.a], ids_b[pair.b], {a.corners_at(pair.a), b.corners_at(pair.b)});
}

template <class Triangles>
void NearestFound::add(const Triangles& a,
                       std::span<const std::uint32_t> ids_a,
                       const Triangles& b,
                       std::span<const std::uint32_t> ids_b,
                       std::span<const Candidate> candidates) {
    triangle_tests_ += candidates.size();
    if (!std::isfinite(bound()) && !candidates.empty()) {
        add_pair(a, ids_a, b, ids_b, candidates.front());
        candidates = candidates.subspan(1);
    }
    const auto within = distance_.within(a, b, candidates, bound());
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (within[i] != 0) {
            add_pair(a, ids_a, b, ids_b, candidates[i]);
        }
    }
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
