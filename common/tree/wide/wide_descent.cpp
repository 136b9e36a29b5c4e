#include "common/tree/wide/wide_descent.hpp"

#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace cd {

namespace {

/// The margins that wide_kernel.cpp derives hold only up to this rotation error and skew.
constexpr double pose_error_max = 0x1p-10;
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
    : error_scale_(error_scale) {
    // This call precedes the kernel's first one, so that a setting of the target takes effect.
    static_cast<void>(simd_target());
    state_.waiting_room = 2 * wide_pairs_slack;
    waiting_ = std::make_unique_for_overwrite<WidePair[]>(state_.waiting_room);
    restart(b_to_a);
}

void WideDescent::restart(const RelativePose& b_to_a) {
    b_to_a_ = b_to_a;
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
    pose_.relative_margin = b_to_a.rotation_error <= pose_error_max && b_to_a.skew <= pose_error_max
                                ? static_cast<float>(error_scale_ * 1.01 * (0x1p-17 + 6 * error))
                                : std::numeric_limits<float>::infinity();
    state_.waiting_count = 0;
    state_.ranked.clear();
    state_.leaf_count = 0;
    state_.box_tests = 0;
    state_.visits = 0;
}

void WideDescent::start(const WideView& a, const WideView& b, Aim aim) {
    const double reach = 3 * (a.extent + b.extent) + b_to_a_.translation.cwiseAbs().sum();
    const double absolute =
        error_scale_ * 4.1 *
        (3 * b_to_a_.rotation_error * b.extent + b_to_a_.translation_error + 0x1p-49 * reach);
    // After NaN or overflow, no pair counts as apart.
    pose_.absolute_margin = absolute < 0x1p100 ? static_cast<float>(absolute) + 0x1p-120F
                                               : std::numeric_limits<float>::infinity();
    state_.a = body_of(a);
    state_.b = body_of(b);
    state_.waiting_count = 0;
    state_.ranked.clear();
    state_.leaf_count = 0;
    state_.leaves_at_once = aim == Aim::All ? wide_leaves_max - wide_batch_max : leaves_for_first;
    dive_visits_left_ = aim == Aim::LikelyFirst ? dive_visits : 0;
    if (dive_visits_left_ > 0) {
        state_.ranked.push({0, 0}, 0);
    } else {
        waiting_[state_.waiting_count++] = {0, 0};
    }
}

std::span<Candidate> WideDescent::next(std::size_t wanted) {
    if (candidates_room_ < wanted + wide_pairs_slack) {
        candidates_room_ = wanted + wide_pairs_slack;
        candidates_ = std::make_unique_for_overwrite<Candidate[]>(candidates_room_);
    }
    state_.candidates = candidates_.get();
    state_.candidate_count = 0;
    state_.candidates_wanted = wanted;
    state_.visits_left = visits_at_once;
    while (!is_done() && state_.visits_left > 0 && state_.candidate_count < wanted) {
        if (dive_visits_left_ > 0) {
            dive();
            continue;
        }
        if (state_.waiting_count + wide_pairs_slack > state_.waiting_room) {
            grow();
        }
        state_.waiting = waiting_.get();
        descend_wide(pose_, state_);
    }
    return {candidates_.get(), state_.candidate_count};
}

/// Visits the most promising pairs, then moves the remaining ones to `waiting_`, the most promising
/// last.
void WideDescent::dive() {
    state_.visits_left = dive_visits_left_;
    descend_wide_ranked(pose_, state_);
    dive_visits_left_ = state_.visits_left;
    state_.visits_left = visits_at_once;
    if (dive_visits_left_ > 0) {
        return;
    }
    const std::size_t count = state_.ranked.size();
    while (count > state_.waiting_room) {
        grow();
    }
    for (std::size_t i = count; i > 0; --i) {
        waiting_[i - 1] = state_.ranked.pop();
    }
    state_.waiting_count = count;
}

void WideDescent::grow() {
    auto larger = std::make_unique_for_overwrite<WidePair[]>(2 * state_.waiting_room);
    std::copy_n(waiting_.get(), state_.waiting_count, larger.get());
    waiting_ = std::move(larger);
    state_.waiting_room *= 2;
}

} // namespace cd
