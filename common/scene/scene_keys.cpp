#include "common/scene/scene_keys.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/motion/motion.hpp"
#include "common/motion/motion_keys.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cd {

namespace {

/// Covers the roundings by which the sum of two bounds may be less than M of their motion.
constexpr double more_than_roundings = 1 + 0x1p-39;

/// The two largest of some numbers that are not negative.
struct TwoLargest {
    double first = 0;
    double second = 0;

    void add(double number) {
        second = std::max(second, std::min(first, number));
        first = std::max(first, number);
    }
};

} // namespace

Result<std::unique_ptr<SceneKeys>> SceneKeys::create(std::unique_ptr<StepPoses> given,
                                                     std::vector<PlacedBody> bodies,
                                                     double resolution,
                                                     const StopCheck& stop) {
    CD_CHECK(resolution > 0);
    std::unique_ptr<SceneKeys> made(new SceneKeys(std::move(given), std::move(bodies), resolution));
    const Status found = made->find_grid(stop);
    return found ? Result(std::move(made)) : found.error();
}

Status SceneKeys::find_grid(const StopCheck& stop) {
    Needs needs = CD_TRY(find_needs(stop));
    grid_ = KeyGrid{needs.bits, needs.exponent};
    // Rounding may change the halvings again, but hardly ever does; the rounds end at the largest
    // depth.
    needs = CD_TRY(find_needs(stop));
    while (needs.bits > grid_->bits) {
        grid_->bits = needs.bits;
        needs = CD_TRY(find_needs(stop));
    }
    moved_ = needs.moved;
    return Done{};
}

/// Finds what the keys need of a grid, on the grid that is known so far.
Result<SceneKeys::Needs> SceneKeys::find_needs(const StopCheck& stop) {
    Needs needs;
    PosesOfStep before;
    for (std::uint64_t step = 0; step < steps(); ++step) {
        if (stop && stop()) {
            return interrupted();
        }
        const PosesOfStep given = CD_TRY(given_->read(step));
        PosesOfStep keys = CD_TRY(keys_of(step, given));
        add_needs(given, keys, needs);
        if (step > 0) {
            needs.bits = std::max(needs.bits, CD_TRY(bits_between(step - 1, before, keys)));
        }
        before = std::move(keys);
    }
    return needs;
}

void SceneKeys::add_needs(const PosesOfStep& given, const PosesOfStep& keys, Needs& needs) const {
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        if (keys[body]) {
            needs.exponent = std::max(needs.exponent, grid_exponent(keys[body]->translation()));
            needs.moved = std::max(needs.moved,
                                   moved_at_most(*given[body], *keys[body], bodies_[body].radius));
        }
    }
}

Result<unsigned>
SceneKeys::bits_between(std::uint64_t step, const PosesOfStep& from, const PosesOfStep& to) const {
    TwoLargest movements;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
        if (from[body] && to[body]) {
            const auto path = path_between(*from[body], *to[body]);
            if (!path) {
                return error_at(step, body, path.error());
            }
            movements.add(movement_bound(path.value(), bodies_[body].radius));
        }
    }
    const double bound = more_than_roundings * (movements.first + movements.second);
    const auto depth = depth_for(bound, resolution_);
    return 1 + (depth ? depth.value() : limits::motion_depth_max);
}

Error SceneKeys::error_at(std::uint64_t step, std::size_t body, const Error& error) const {
    return {error.code,
            "step " + std::to_string(step) + ": " + bodies_[body].name + ": " + error.detail};
}

Result<PosesOfStep> SceneKeys::read(std::uint64_t step) {
    return keys_of(step, CD_TRY(given_->read(step)));
}

double SceneKeys::moved_between() const {
    double radius = 0;
    for (const PlacedBody& body : bodies_) {
        radius = std::max(radius, body.radius);
    }
    return moved_ + std::ldexp(radius, static_cast<int>(grid_->bits) - 50);
}

/// Rounds the poses of a step to the grid; while there is none, to quaternions of norm 1 alone.
Result<PosesOfStep> SceneKeys::keys_of(std::uint64_t step, const PosesOfStep& given) const {
    CD_CHECK(given.size() == bodies_.size());
    PosesOfStep keys(given.size());
    for (std::size_t body = 0; body < given.size(); ++body) {
        if (given[body]) {
            const auto key = unit_key(*given[body]);
            if (!key) {
                return error_at(step, body, key.error());
            }
            keys[body] = grid_ ? grid_->rounded(key.value()) : key.value();
        }
    }
    return keys;
}

} // namespace cd
