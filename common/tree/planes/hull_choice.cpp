#include "common/tree/planes/hull_choice.hpp"

#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/planes/simplex.hpp"
#include "common/tree/planes/support_view.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace cd {

namespace {

/// Searches for a nearer combination at most this often.
constexpr int steps_max = 12;

/// Directions to the faces, edges and corners of a cube; each also means its opposite.
constexpr std::array<FloatPoint, 13> first_directions{{{1, 0, 0},
                                                       {0, 1, 0},
                                                       {0, 0, 1},
                                                       {1, 1, 0},
                                                       {1, -1, 0},
                                                       {1, 0, 1},
                                                       {1, 0, -1},
                                                       {0, 1, 1},
                                                       {0, 1, -1},
                                                       {1, 1, 1},
                                                       {1, 1, -1},
                                                       {1, -1, 1},
                                                       {-1, 1, 1}}};

Vec3 vector_of(const FloatPoint& point) {
    return {point[0], point[1], point[2]};
}

/// Returns the indices of the points that are farthest along the first directions, each once.
std::vector<std::uint32_t> extremes_of(std::span<const FloatPoint> points) {
    std::vector<std::uint32_t> found;
    for (const FloatPoint& direction : first_directions) {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        float least = std::numeric_limits<float>::infinity();
        float most = -least;
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const FloatPoint& at = points[i];
            const float reach = at[0] * direction[0] + at[1] * direction[1] + at[2] * direction[2];
            low = reach < least ? i : low;
            least = std::min(least, reach);
            high = reach > most ? i : high;
            most = std::max(most, reach);
        }
        found.push_back(low);
        found.push_back(high);
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

/// A point that is not chosen, with an upper bound on its distance from the hull.
struct Waiting {
    double bound;
    std::uint32_t number;

    friend bool operator<(const Waiting& left, const Waiting& right) {
        return left.bound != right.bound ? left.bound < right.bound : left.number > right.number;
    }
};

} // namespace

void HullDistance::clear(double radius) {
    count_ = 0;
    rounding_ = 0x1p-46 * radius; // Of a combination: its weights' sum, four products, three sums.
    simplex_.clear();
}

void HullDistance::add(const FloatPoint& point) {
    if (count_ == room_) {
        const std::uint32_t room = room_ == 0 ? 4 * support_padding : 2 * room_;
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
        const double distance = nearest.point.norm();
        if (!(distance < best)) {
            break; // Rounding keeps the search from getting nearer.
        }
        best = distance;
        if (best <= enough || best <= rounding_) {
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
    return best * (1 + 0x1p-40) + rounding_;
}

HullChoice choose_hull(std::span<const FloatPoint> points,
                       std::size_t count_max,
                       double eps_wanted,
                       double radius) {
    HullChoice choice;
    choice.numbers = extremes_of(points);
    HullDistance hull;
    hull.clear(radius);
    for (const std::uint32_t number : choice.numbers) {
        hull.add(points[number]);
    }
    // A rough bound suffices at first: most points never become the farthest one.
    std::vector<Waiting> waiting;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        waiting.push_back({hull.bound(points[i], 16 * eps_wanted), i});
    }
    std::priority_queue<Waiting> queue({}, std::move(waiting));
    while (queue.top().bound > eps_wanted) {
        const Waiting farthest = queue.top();
        queue.pop();
        const double bound = hull.bound(points[farthest.number], eps_wanted);
        if (!queue.empty() && bound < queue.top().bound) {
            queue.push({std::min(bound, farthest.bound), farthest.number});
            continue;
        }
        if (choice.numbers.size() >= count_max || bound <= eps_wanted) {
            queue.push({std::min(bound, farthest.bound), farthest.number});
            break;
        }
        choice.numbers.push_back(farthest.number);
        hull.add(points[farthest.number]);
        if (queue.empty()) {
            return choice;
        }
    }
    choice.eps = queue.top().bound;
    return choice;
}

} // namespace cd
