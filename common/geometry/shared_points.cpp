#include "common/geometry/shared_points.hpp"

namespace cd {

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
    if (const DoubleDoublePoints* const fast_path = fast()) {
        if (const auto origin = fast_path->origin(a)) {
            ++statistics_.origins_fast;
            return last_origin_ = *origin;
        }
    }
    ++statistics_.origins_exact;
    return last_origin_ = exact().origin(a);
}

std::span<const Vec3> SharedPoints::points(const Corners& a, const Corners& b) {
    const Vec3 from = origin(a);
    if (DoubleDoublePoints* const fast_path = fast()) {
        if (const auto ends = fast_path->points(a, b, from)) {
            ++statistics_.points_fast;
            points_.assign(ends->begin(), ends->end());
            return points_;
        }
    }
    ++statistics_.points_exact;
    points_ = exact().points(a, b, from);
    return points_;
}

} // namespace cd
