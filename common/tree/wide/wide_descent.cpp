#include "common/tree/wide/wide_descent.hpp"

#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

/// The margins that wide_kernel.cpp derives hold only up to this rotation error and skew.
constexpr double pose_error_max = 0x1p-10;
/// The same for the reach: the factor is that of (9).
constexpr double wide_reach_max = 0x1p50;
constexpr double wide_reach_factor = 1 + 0x1p-17;
/// One call of `next` makes at most about this many visits, which take less than a millisecond.
constexpr std::uint32_t visits_at_once = 4096;
/// A search for a first contact sets this many pairs of leaves aside before it visits them, fewer
/// than a search for all contacts.
constexpr std::size_t leaves_for_first = 2 * wide_batch_max;

WideBody body_of(const WideView& tree) {
    const TriangleBlocks& triangles = tree.triangles;
    return {tree.nodes.data(),
            triangles.floats.empty() ? nullptr : triangles.floats.data(),
            triangles.doubles.empty() ? nullptr : triangles.doubles.data(),
            triangles.vertex_begin.data(),
            triangles.corners.data()};
}

} // namespace

WideDescent::WideDescent(const RelativePose& b_to_a, double error_scale)
    : margins_{error_scale, 0, 0} {
    // This call precedes the kernel's first one, so that a setting of the target takes effect.
    static_cast<void>(simd_target());
    walk_.waiting_room = 2 * wide_pairs_slack;
    waiting_ = std::make_unique_for_overwrite<WidePair[]>(walk_.waiting_room);
    restart(b_to_a);
}

void WideDescent::restart(const RelativePose& b_to_a, double reach) {
    b_to_a_ = b_to_a;
    margins_.reach = reach;
    pose_.along = {};
    pose_.along_in_b = {};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double entry = b_to_a.rotation(static_cast<int>(i), static_cast<int>(k));
            pose_.rotation[3 * i + k] = entry;
            pose_.columns[k][i] = static_cast<float>(entry);
            pose_.rows[i][k] = static_cast<float>(entry);
        }
        pose_.translation[i] = b_to_a.translation[static_cast<int>(i)];
    }
    const double error = b_to_a.rotation_error + b_to_a.skew;
    pose_.relative_margin =
        b_to_a.rotation_error <= pose_error_max && b_to_a.skew <= pose_error_max
            ? static_cast<float>(margins_.error_scale * 1.01 * (0x1p-17 + 6 * error))
            : std::numeric_limits<float>::infinity();
    walk_.waiting_count = 0;
    walk_.ranked.clear();
    planes_.clear();
    walk_.leaf_count = 0;
    walk_.box_tests = 0;
    walk_.visits = 0;
}

void WideDescent::set_margin() {
    // After NaN or overflow, no pair counts as apart.
    const double margin = margins_.absolute + wide_reach_factor * margins_.reach;
    pose_.absolute_margin = margin < 0x1p100 && margins_.reach < wide_reach_max
                                ? static_cast<float>(margin) + 0x1p-120F
                                : std::numeric_limits<float>::infinity();
    pose_.reach = static_cast<float>(std::min(margins_.reach, 0x1p100));
}

void WideDescent::set_reach(double reach) {
    margins_.reach = reach;
    set_margin();
    if (course_.has_planes) {
        planes_.set_reach(pose_.reach);
    }
}

void WideDescent::set_direction(const Vec3& direction) {
    const Vec3 in_b = b_to_a_.rotation.transpose() * direction;
    for (std::size_t i = 0; i < 3; ++i) {
        pose_.along[i] = static_cast<float>(direction[static_cast<int>(i)]);
        pose_.along_in_b[i] = static_cast<float>(in_b[static_cast<int>(i)]);
    }
}

void WideDescent::start(const WideView& a, const WideView& b, Aim aim) {
    const double reach = 3 * (a.extent + b.extent) + b_to_a_.translation.cwiseAbs().sum();
    margins_.absolute =
        margins_.error_scale * 4.1 *
        (3 * b_to_a_.rotation_error * b.extent + b_to_a_.translation_error + 0x1p-49 * reach);
    set_margin();
    last_.move_to(b_to_a_, a, b);
    if (aim == Aim::Any) {
        aim = last_.expects_contact() ? Aim::LikelyFirst : Aim::First;
    }
    walk_.a = body_of(a);
    walk_.b = body_of(b);
    walk_.waiting_count = 0;
    walk_.ranked.clear();
    walk_.leaf_count = 0;
    course_.is_for_all = aim == Aim::All || aim == Aim::AllUnlikely;
    walk_.leaves_at_once = course_.is_for_all ? wide_leaves_max - wide_batch_max : leaves_for_first;
    course_.is_nearest = aim == Aim::Nearest;
    const auto size = static_cast<float>(std::min(a.extent + b.extent, 0x1p50));
    pose_.rank_base =
        static_cast<std::int32_t>(std::bit_cast<std::uint32_t>(size * size) >> rank_shift) -
        (PairBuckets::count - 2);
    course_.has_planes = aim != Aim::All && !a.support.sets.empty() && !b.support.sets.empty();
    planes_.clear();
    if (course_.has_planes) {
        planes_.reset(
            plane_pose(b_to_a_, a.support, b.support, margins_.error_scale, margins_.reach),
            a,
            b,
            last_.is_near());
    }
    dive_ = {};
    if (course_.is_nearest) {
        walk_.ranked.push({0, 0}, 0);
        if (course_.has_planes) {
            const auto [x, y, z] = planes_.root_normal();
            set_direction({x, y, z});
        }
        return;
    }
    if (aim == Aim::LikelyFirst) {
        begin_dive();
    } else if (course_.has_planes) {
        planes_.push_roots();
    } else {
        waiting_[walk_.waiting_count++] = {0, 0};
    }
}

std::span<Candidate> WideDescent::next(std::size_t wanted) {
    if (candidates_room_ < wanted + wide_pairs_slack) {
        candidates_room_ = wanted + wide_pairs_slack;
        candidates_ = std::make_unique_for_overwrite<Candidate[]>(candidates_room_);
    }
    walk_.candidates = candidates_.get();
    walk_.candidate_count = 0;
    walk_.candidates_wanted = wanted;
    walk_.visits_left = visits_at_once;
    while (!is_done() && walk_.visits_left > 0 && walk_.candidate_count < wanted) {
        if (course_.is_nearest) {
            visit_nearest();
            continue;
        }
        if (dive_.visits_left > 0) {
            dive();
            continue;
        }
        if (planes_.size() > 0) {
            part();
            continue;
        }
        if (walk_.waiting_count + wide_pairs_slack > walk_.waiting_room) {
            grow();
        }
        walk_.waiting = waiting_.get();
        walk_wide(pose_, walk_);
    }
    return {candidates_.get(), walk_.candidate_count};
}

/// Visits the pair of nodes whose boxes are nearest, unless it is beyond the reach or a plane parts
/// it. The queue is not empty.
void WideDescent::visit_nearest() {
    // A rank is a lower bound of the distance of the pairs that have it.
    const std::int32_t rank = walk_.ranked.least_rank();
    if (rank > 0 && least_square_of(rank, pose_) > pose_.reach * pose_.reach) {
        walk_.ranked.clear();
        return;
    }
    const WidePair pair = walk_.ranked.pop();
    // No plane parts nodes by more than a reach without a limit.
    if (course_.has_planes && pose_.reach < wide_reach_max &&
        planes_.parts(pair, {pose_.along[0], pose_.along[1], pose_.along[2]})) {
        return;
    }
    const std::uint32_t visits_left = walk_.visits_left;
    walk_.visits_left = 1;
    walk_.ranked.push(pair, 0); // Of rank 0 the last one is visited next.
    walk_wide_nearest(pose_, walk_);
    walk_.visits_left = visits_left - 1;
}

/// Begins with the most promising pairs: those of the last contacts, or else the roots.
void WideDescent::begin_dive() {
    const auto places = last_.places();
    dive_.is_near_last = !places.empty();
    if (dive_.is_near_last) {
        dive_.visits_left = static_cast<std::uint32_t>(places.size()) * dive_visits_near_last;
        for (std::size_t i = places.size(); i > 0; --i) {
            walk_.ranked.push(places[i - 1], 0);
        }
    } else {
        dive_at_roots();
    }
}

void WideDescent::dive_at_roots() {
    walk_.ranked.clear();
    walk_.ranked.push({0, 0}, 0);
    dive_.visits_left = course_.has_planes ? dive_visits_before_planes : dive_visits;
    dive_.is_near_last = false;
}

/// Visits the most promising pairs.
void WideDescent::dive() {
    walk_.visits_left = dive_.visits_left;
    walk_wide_ranked(pose_, walk_);
    dive_.visits_left = walk_.visits_left;
    walk_.visits_left = visits_at_once;
    if (dive_.is_near_last) {
        if (dive_.visits_left == 0 || walk_.ranked.size() == 0) {
            dive_at_roots();
        }
    } else if (dive_.visits_left == 0) {
        end_dive();
    }
}

/// Begins again at the roots with planes, or without support points moves the remaining pairs to
/// `waiting_`, the most promising last.
void WideDescent::end_dive() {
    if (course_.has_planes) {
        walk_.ranked.clear();
        planes_.push_roots();
        return;
    }
    const std::size_t count = walk_.ranked.size();
    while (count > walk_.waiting_room) {
        grow();
    }
    for (std::size_t i = count; i > 0; --i) {
        waiting_[i - 1] = walk_.ranked.pop();
    }
    walk_.waiting_count = count;
}

/// Takes the next pair that no plane parts, and visits it: leaves together with others.
void WideDescent::part() {
    const std::optional<WidePair> pair = planes_.next();
    if (!pair) {
        return;
    }
    if (walk_.a.nodes[pair->a].is_leaf && walk_.b.nodes[pair->b].is_leaf) {
        walk_.leaves[walk_.leaf_count++] = *pair;
        if (walk_.leaf_count < wide_batch_max && planes_.size() > 0) {
            return;
        }
    } else {
        waiting_[walk_.waiting_count++] = *pair;
    }
    const std::uint32_t visits_left = walk_.visits_left;
    walk_.visits_left = 1;
    walk_.waiting = waiting_.get();
    walk_wide(pose_, walk_);
    planes_.push_children({waiting_.get(), walk_.waiting_count});
    walk_.waiting_count = 0;
    walk_.visits_left = visits_left - 1;
    if (course_.is_for_all && walk_.candidate_count > 0) {
        leave_planes();
    }
}

/// Moves all pairs that planes have not parted to `waiting_`.
void WideDescent::leave_planes() {
    while (planes_.size() + wide_pairs_slack > walk_.waiting_room) {
        grow();
    }
    while (planes_.size() > 0) {
        waiting_[walk_.waiting_count++] = planes_.pop();
    }
}

void WideDescent::grow() {
    auto larger = std::make_unique_for_overwrite<WidePair[]>(2 * walk_.waiting_room);
    std::copy_n(waiting_.get(), walk_.waiting_count, larger.get());
    waiting_ = std::move(larger);
    walk_.waiting_room *= 2;
}

} // namespace cd
