#include "common/tree/planes/hull_distance.hpp"

#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/planes/simplex.hpp"
#include "common/tree/planes/support_view.hpp"

#include <algorithm>
#include <limits>

namespace cd {

namespace {

/// Searches for a nearer combination at most this often.
constexpr int steps_max = 12;

} // namespace

void HullDistance::add(const FloatPoint& point) {
    if (count_ == room_) {
        const std::uint32_t room = room_ == 0 ? 5 * support_padding : 2 * room_;
        std::vector<float> columns(3 * std::size_t{room});
        for (std::size_t k = 0; k < 3; ++k) {
            std::copy_n(columns_.begin() + static_cast<std::ptrdiff_t>(k * room_),
                        count_,
                        columns.begin() + static_cast<std::ptrdiff_t>(k * room));
        }
        columns_ = std::move(columns);
        room_ = room;
    }
    // Copies of the new point replace the padding.
    for (std::size_t k = 0; k < 3; ++k) {
        std::fill(columns_.begin() + static_cast<std::ptrdiff_t>(k * room_ + count_),
                  columns_.begin() + static_cast<std::ptrdiff_t>((k + 1) * room_),
                  point[k]);
    }
    ++count_;
}

Vec3 HullDistance::at(std::uint32_t number) const {
    return {columns_[number], columns_[room_ + number], columns_[2 * std::size_t{room_} + number]};
}

double HullDistance::bound(const FloatPoint& point, double enough) {
    const Vec3 from = vector_of(point);
    if (simplex_.empty()) {
        simplex_.push_back(0);
    }
    double best = std::numeric_limits<double>::infinity();
    for (int step = 0; step < steps_max; ++step) {
        std::array<Vec3, 4> corners;
        for (std::size_t i = 0; i < simplex_.size(); ++i) {
            corners[i] = at(simplex_[i]) - from;
        }
        const NearestOfSimplex nearest = nearest_of_simplex(corners, simplex_.size());
        const double bound = distance_bound(nearest, radius_);
        if (!(bound < best)) {
            break; // Rounding keeps the search from getting nearer.
        }
        best = bound;
        const double distance = nearest.point.norm();
        if (best <= enough || distance <= distance_rounding * radius_) {
            break;
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < simplex_.size(); ++i) {
            if (nearest.weights[i] > 0) {
                simplex_[kept++] = simplex_[i];
            }
        }
        simplex_.resize(kept);
        const Vec3 towards = -nearest.point / distance;
        const std::uint32_t next = farthest_point(columns_.data(),
                                                  room_,
                                                  {static_cast<float>(towards[0]),
                                                   static_cast<float>(towards[1]),
                                                   static_cast<float>(towards[2])});
        const double gain = towards.dot(at(next) - from) + distance;
        if (gain <= 0x1p-20 * distance || std::ranges::find(simplex_, next) != simplex_.end() ||
            simplex_.size() == 4) {
            break; // No point of the hull is nearer.
        }
        simplex_.push_back(next);
    }
    return best;
}

} // namespace cd
