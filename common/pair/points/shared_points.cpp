#include "common/pair/points/shared_points.hpp"

#include <algorithm>
#include <array>

namespace cd {

void SharedPoints::restart(const PosePair& poses) {
    poses_ = poses;
    together_.reset();
    fast_.reset();
    finder_.reset();
    exact_.reset();
    last_a_.reset();
    last_offset_.reset();
    statistics_ = {};
}

DoubleDoublePoints* SharedPoints::fast() {
    if (path_ == Path::Exact) {
        return nullptr;
    }
    if (!fast_) {
        fast_.emplace(poses_);
    }
    return &*fast_;
}

ExactPoints& SharedPoints::exact() {
    if (!exact_) {
        exact_.emplace(poses_);
    }
    return *exact_;
}

Vec3 SharedPoints::origin(const Corners& a) {
    if (last_a_ == a) {
        return last_origin_;
    }
    last_a_ = a;
    last_offset_.reset();
    if (const DoubleDoublePoints* const fast_path = fast()) {
        if (const auto origin = fast_path->origin(a)) {
            ++statistics_.origins_fast;
            return last_origin_ = *origin;
        }
    }
    ++statistics_.origins_exact;
    return last_origin_ = exact().origin(a);
}

Vec3 SharedPoints::offset() {
    if (!last_offset_) {
        last_offset_ = exact().offset(*last_a_, last_origin_);
    }
    return *last_offset_;
}

std::optional<std::span<const Vec3>>
SharedPoints::fast_points(const Corners& a, const Corners& b, const Vec3& origin) {
    DoubleDoublePoints* const fast_path = fast();
    if (fast_path == nullptr || !fast_path->take(a, b, origin)) {
        return std::nullopt;
    }
    if (const auto ends = fast_path->ends()) {
        return ends;
    }
    if (!finder_) {
        finder_.emplace(poses_);
    }
    const auto corners = finder_->find(a, b, fast_path->sides_of_a(), fast_path->sides_of_b());
    return corners ? fast_path->at(*corners, [this] { return offset(); }) : std::nullopt;
}

std::span<const Vec3> SharedPoints::points(const Corners& a, const Corners& b) {
    const Vec3 from = origin(a);
    if (const auto found = fast_points(a, b, from)) {
        ++statistics_.points_fast;
        return *found;
    }
    ++statistics_.points_exact;
    points_ = exact().points(a, b, from);
    return points_;
}

const CrossingPoints* SharedPoints::together(std::span<const PairCorners> pairs) {
    if (path_ == Path::Exact) {
        return nullptr;
    }
    if (!together_) {
        together_.emplace(poses_);
    }
    if (!together_->pays()) {
        return nullptr;
    }
    together_->compute(pairs);
    return &*together_;
}

void SharedPoints::for_each(std::span<const PairCorners> pairs, const Receiver& receive) {
    while (!pairs.empty()) {
        const auto now = pairs.first(std::min(pairs.size(), CrossingPoints::pairs_max));
        const CrossingPoints* const found = together(now);
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (found != nullptr && found->is_proven(i)) {
                ++statistics_.points_together;
                receive(found->origin(i), found->ends(i));
            } else {
                const Vec3 from = origin(now[i].a);
                receive(from, points(now[i].a, now[i].b));
            }
        }
        pairs = pairs.subspan(now.size());
    }
}

} // namespace cd
