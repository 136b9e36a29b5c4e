#include "client/poses/nearness.hpp"

#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

constexpr std::uint64_t poses_at_once = 256;
/// Bodies farther apart than this many of their lengths probably have poses in another unit.
constexpr double lengths_of_another_unit = 10;

Aabb posed(const Aabb& box, const Pose& pose) {
    Aabb around;
    for (int corner = 0; corner < 8; ++corner) {
        around.add(pose.apply({(corner & 1) != 0 ? box.max.x() : box.min.x(),
                               (corner & 2) != 0 ? box.max.y() : box.min.y(),
                               (corner & 4) != 0 ? box.max.z() : box.min.z()}));
    }
    return around;
}

double distance(const Aabb& a, const Aabb& b) {
    const Vec3 gap = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(Vec3::Zero());
    return gap.stableNorm();
}

/// Formats a length, rounded down. Below 1 it has two digits behind its zeros.
std::string length_text(double length) {
    constexpr int digits_max = 9;
    int digits = 1;
    double tens = 10;
    while (digits < digits_max && tens * length < 10) {
        ++digits;
        tens *= 10;
    }
    return length < 100 ? fixed_text(std::floor(tens * length) / tens, digits)
                        : grouped(static_cast<std::uint64_t>(length));
}

} // namespace

std::optional<double>
least_distance(const Mesh& a, const Mesh& b, PoseSource& poses, const StopCheck& stop) {
    const Aabb box_a = bounding_box(a.vertices());
    const Aabb box_b = bounding_box(b.vertices());
    std::optional<double> least;
    for (std::uint64_t first = 0; first < poses.count(); first += poses_at_once) {
        if (stop && stop()) {
            return std::nullopt;
        }
        const auto run = poses.read(first, std::min(poses_at_once, poses.count() - first));
        if (!run) {
            return std::nullopt;
        }
        for (const Scenario& scenario : run.value()) {
            for (const PosePair& at : {scenario.poses, scenario.to.value_or(scenario.poses)}) {
                const double apart = distance(posed(box_a, at.a), posed(box_b, at.b));
                if (!(apart > 0)) {
                    return std::nullopt;
                }
                least = std::min(apart, least.value_or(apart));
            }
        }
    }
    return least;
}

Result<std::string> nearness_hint(const Mesh& a,
                                  const Mesh& b,
                                  PoseSource& poses,
                                  const std::string& unit,
                                  std::string_view pose,
                                  const StopCheck& stop) {
    const auto least = least_distance(a, b, poses, stop);
    if (stop && stop()) {
        return interrupted();
    }
    if (!least || !(*least < 1e15)) {
        return std::string();
    }
    const double length_a = bounding_box(a.vertices()).size().maxCoeff();
    const double length_b = bounding_box(b.vertices()).size().maxCoeff();
    const bool is_far = *least > lengths_of_another_unit * std::max(length_a, length_b);
    return "no " + std::string(pose) + " brings B within " + length_text(*least) + " " + unit +
           " of A (A is " + length_text(length_a) + " " + unit + " long)" +
           (is_far && unit != "mm" ? ": are the poses in mm? [poses] unit = \"mm\"" : "");
}

} // namespace cd
