// Error bounds, where e stands for `double_double_error`. The derivation omits factors of 1 +
// 2^-50.
//
// The bundle in A's coordinates: M = A' B for the rotations A and B, whose entries are at most 1
// and err by 10 e. The sizes in a row or column sum to at most 1.74, so that an entry of M, a sum
// of three products, errs by 2 * 10 e * 1.74 and the roundings, 8 e: below 45 e. The offset t_b -
// t_a is exact, of sizes that sum to D; A' times it errs by 10 e D, and by 6 e D for the roundings.
// Let R be the sum of D and of the largest coordinates of the lines on the three axes of B.
// Products of entries of M and coordinates err by 46 e times the coordinates, and three sums by e
// times at most R each: a start errs by less than 64 e R. Likewise -way errs by 45 e |way| and two
// roundings, less than 50 e |way|.
//
// The side of the line at (y, z) is s0 + y s1 + z s2, with s0 = n.(start - corner) for the line at
// (0, 0) and the scalar products s1, s2 of the normal n and the columns of M for y and z.
//
// Sides: that of a start is bounded as in DoubleDoubleDepth (double_double_depth.cpp), whose X, Z,
// W and h the kernel calls x, z, w and `start_error`: s0 errs by X^2 (8 h + 36 e W). A component of
// n is at most 2 X^2 and errs by 4 e X^2. Its product with an entry m of a column errs by 2 X^2
// 45 e + (4 + 2) e X^2 |m|, and the sizes |m| sum to at most 1.74: three products err by 281 e X^2,
// two sums by 7 e X^2. So s1 and s2 err by less than 300 e X^2, and with Y for the most that |y| +
// |z| can be, ds = X^2 (8 h + 36 e W + 300 e Y).
//
// Difference of the sides, n.(-way): with g for the error of -way, the product on axis k errs by
// 2 X^2 g + (4 + 2) e X^2 |way_k|, and the sizes |way_k| sum to at most 1.74 |way|: three products
// err by 6 X^2 g + 10.5 e X^2 |way|, and two sums by 7 e X^2 |way|. dd = X^2 (7 g + 24 e |way|) has
// room.
//
// Depth: |s / a - s' / a'| <= (ds + dd |s' / a'|) / |a| for the difference a and true values s',
// a', and the true share is between 0 and 1: (ds + dd) / |a|. The depth is the sum of three terms,
// si * (length / a) times 1, y or z. Each errs by 4 e, relatively, for a quotient and two products,
// and two sums err by 2 e T for the sum T of the terms' sizes. Rounding adds u^2 of the depth, 2
// times: below 8 e T in all. length * 1.2 (ds + dd) / |a| + 10 e T has room.
#include "common/shots/bundle/bundle_depths.hpp"

#include "common/pair/stages/double_double/double_double_local.hpp"
#include "common/pair/stages/double_double/double_double_rotation.hpp"
#include "common/shots/rigid_pose.hpp"
#include "common/shots/segment_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double e = double_double_error;

/// Returns A' v.
DoubleDoubleVec turned_back(const DoubleDoubleMatrix& a, const DoubleDoubleVec& v) {
    DoubleDoubleVec turned;
    for (std::size_t i = 0; i < 3; ++i) {
        turned[i] = a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2];
    }
    return turned;
}

DoubleDoubleVec column(const DoubleDoubleMatrix& m, std::size_t k) {
    return {m[0][k], m[1][k], m[2][k]};
}

DoubleDoubleVec times(const DoubleDoubleVec& v, const DoubleDouble& by) {
    return {v[0] * by, v[1] * by, v[2] * by};
}

/// Returns the only axis on which a vector is not 0, if it is exactly 1 or -1 there.
std::optional<std::size_t> unit_axis(const DoubleDoubleVec& v) {
    std::optional<std::size_t> axis;
    for (std::size_t k = 0; k < 3; ++k) {
        if (v[k].low != 0 || (v[k].high != 0 && (axis || std::abs(v[k].high) != 1))) {
            return std::nullopt;
        }
        if (v[k].high != 0) {
            axis = k;
        }
    }
    return axis;
}

double largest_across(const ParallelLines& lines, std::size_t which) {
    return std::max(std::abs(lines.least()[which]), std::abs(lines.most()[which]));
}

} // namespace

bool BundleDepths::suits(const PosePair& poses) {
    return is_rigid(poses.a) && is_rigid(poses.b);
}

BundleDepths::BundleDepths(double bound_scale)
    : bound_scale_(bound_scale), many_(std::make_unique<DepthsOfMany>()) {
    *many_ = {};
}

void BundleDepths::restart(const PosePair& poses, const ParallelLines& lines) {
    rows_ = lines.rows();
    aligned_ = aligned_axis(poses, lines);
    const DoubleDoubleMatrix a = double_double_rotation(poses.a);
    const DoubleDoubleMatrix b = double_double_rotation(poses.b);
    const Vec3& from = poses.a.translation();
    const Vec3& to = poses.b.translation();
    const DoubleDoubleVec offset{
        exact_sum(to.x(), -from.x()), exact_sum(to.y(), -from.y()), exact_sum(to.z(), -from.z())};
    const std::array<double, 2>& ends = lines.ends();
    const DoubleDoubleVec along = turned_back(a, column(b, lines.axis()));
    const DoubleDoubleVec moved = turned_back(a, offset);
    for (std::size_t k = 0; k < 3; ++k) {
        bundle_.start[k] = moved[k] + along[k] * ends[0];
    }
    for (std::size_t which = 0; which < 2; ++which) {
        bundle_.across[which] = turned_back(a, column(b, (lines.axis() + 1 + which) % 3));
    }
    const DoubleDouble back = exact_sum(ends[0], -ends[1]);
    bundle_.minus_way = times(along, back);
    bundle_.way_size = 1.01 * std::abs(back.high);
    bundle_.way_error = 50 * e * bundle_.way_size * bound_scale_;
    bundle_.across_size = 1.01 * (largest_across(lines, 0) + largest_across(lines, 1));
    const double reach = (to - from).cwiseAbs().sum() + std::abs(ends[0]) + bundle_.across_size;
    bundle_.start_error = 64 * e * reach * bound_scale_;
    Segment line{Vec3::Zero(), Vec3::Zero()};
    line.p.x() = ends[0];
    line.q.x() = ends[1];
    bundle_.length = segment_length(line);
    const auto is_fit = [](double size) {
        return size >= local_length_least && size <= local_length_most;
    };
    if (!(is_fit(reach) && is_fit(bundle_.way_size) && is_fit(bundle_.length))) {
        bundle_.start_error = std::numeric_limits<double>::infinity();
    }
}

/// With unit vectors for the lines' direction in the world and for an axis of A that is parallel to
/// it, the way from the start p to the coordinate x of that axis is a sum of four doubles, times
/// the direction of the way.
std::optional<BundleDepths::AlignedAxis> BundleDepths::aligned_axis(const PosePair& poses,
                                                                    const ParallelLines& lines) {
    const std::array<double, 2>& ends = lines.ends();
    const DoubleDouble way = exact_sum(ends[1], -ends[0]);
    const DoubleDoubleVec in_world = column(double_double_rotation(poses.b), lines.axis());
    const std::optional<std::size_t> world = unit_axis(in_world);
    if (!world || way.low != 0) {
        return std::nullopt;
    }
    const DoubleDoubleVec row = double_double_rotation(poses.a)[*world];
    const std::optional<std::size_t> axis = unit_axis(row);
    if (!axis) {
        return std::nullopt;
    }
    // The world's coordinate is `turn` times that along the lines, and `row` times that of A.
    const double turn = in_world[*world].high;
    const double onward = way.high > 0 ? 1 : -1;
    const auto k = static_cast<Eigen::Index>(*world);
    return AlignedAxis{*axis,
                       onward * turn * row[*axis].high,
                       {onward * turn * poses.a.translation()[k],
                        -onward * turn * poses.b.translation()[k],
                        -onward * ends[0]}};
}

/// Returns the depth of a triangle across the lines, which often lies midway between two doubles,
/// where no error bound proves the rounding.
std::optional<double> BundleDepths::aligned_depth(const Corners& corners) const {
    const auto axis = static_cast<Eigen::Index>(aligned_->axis);
    const double x = corners[0][axis];
    if (corners[1][axis] != x || corners[2][axis] != x) {
        return std::nullopt;
    }
    const auto& [a, b, c] = aligned_->terms;
    return nearest_sum<4>({aligned_->sign * x, a, b, c});
}

void BundleDepths::find(const TriangleBlocks& a,
                        std::span<const PassedTriangle> triangles,
                        std::span<const std::uint32_t> lines,
                        std::vector<double>& depths) {
    Taken taken;
    while (taken.lines < lines.size()) {
        const std::size_t before = taken.lines;
        take(triangles, lines, taken);
        if (!find_depths(bundle_, bound_scale_, a, rows_, *many_) && aligned_) {
            for (std::size_t triangle = 0; triangle < many_->count; ++triangle) {
                align(a, triangle);
            }
        }
        const auto found = std::span(many_->depths).first(taken.lines - before);
        depths.insert(depths.end(), found.begin(), found.end());
    }
}

/// Adds further triangles and lines to the batch while it has room. A triangle whose lines do not
/// all fit is added again to the next batch.
void BundleDepths::take(std::span<const PassedTriangle> triangles,
                        std::span<const std::uint32_t> lines,
                        Taken& taken) {
    constexpr std::uint32_t at_once = 4;
    static_assert(at_once <= DepthsOfMany::spare);
    DepthsOfMany& many = *many_;
    const std::size_t first = taken.lines;
    const std::size_t most = std::min(first + DepthsOfMany::lines_most, lines.size());
    many.count = 0;
    while (taken.lines < most && many.count < DepthsOfMany::triangles_most) {
        const std::size_t next = taken.triangles + 1;
        const std::size_t its_end = next < triangles.size() ? triangles[next].begin : lines.size();
        const std::size_t end = std::min(its_end, most);
        many.slots[many.count] = triangles[taken.triangles].slot;
        many.begins[many.count] = taken.lines - first;
        // Most triangles have few lines. Writing a fixed number of them avoids a branch for each.
        for (std::size_t i = taken.lines; i < end; i += at_once) {
            std::fill_n(
                &many.triangles[i - first], at_once, static_cast<std::uint32_t>(many.count));
        }
        ++many.count;
        taken.lines = end;
        taken.triangles = end == its_end ? next : taken.triangles;
    }
    const std::size_t count = taken.lines - first;
    many.begins[many.count] = count;
    std::ranges::copy(lines.subspan(first, count), many.lines.begin());
    std::fill_n(&many.lines[count], DepthsOfMany::spare, many.lines[0]);
    std::fill_n(&many.triangles[count], DepthsOfMany::spare, 0u);
    std::fill_n(&many.slots[many.count], DepthsOfMany::spare, many.slots[0]);
}

/// Finds depths of a triangle that bounds do not prove.
void BundleDepths::align(const TriangleBlocks& a, std::size_t triangle) {
    const std::span<double> depths =
        std::span(many_->depths)
            .subspan(many_->begins[triangle],
                     many_->begins[triangle + 1] - many_->begins[triangle]);
    if (std::ranges::any_of(depths, [](double depth) { return std::isnan(depth); })) {
        const double depth = aligned_depth(a.corners_at(many_->slots[triangle])).value_or(NAN);
        std::ranges::replace_if(
            depths, [](double each) { return std::isnan(each); }, depth);
    }
}

} // namespace cd
