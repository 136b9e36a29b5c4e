#include "client/curves/step_curves.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/motion/motion_keys.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cd {

namespace {

/// The share of `off_max` that each of the two bodies of a pair may use between its keys.
constexpr double share_of_body = (1 - grid_share - gap_share) / 2;

/// Returns into how many equal parts the turn of a straight path is cut at least, if it is cut at
/// all. Each of the two errors gets half of what is allowed.
double parts_of_turn(const BodyPath& path, double radius, double allowed) {
    const double product = std::min(1.0, dot(path.q0, path.q1));
    const double k = 2 * std::sqrt((1 - product) / (1 + product));
    return std::ceil(std::max(std::sqrt(2 * 0.1624 * k * k * radius / allowed),
                              std::cbrt(2 * 0.04 * k * k * k * radius / allowed)));
}

/// Bounds how far roundings move a point of a body on a straight path.
double rounding_on(const BodyPath& path, double radius) {
    return 0x1p-47 * (path.c0.norm() + path.c1.norm() + radius);
}

} // namespace

CurvedSteps::CurvedSteps(std::unique_ptr<StepPoses> given,
                         std::vector<StepRates> rates,
                         std::vector<PlacedBody> bodies,
                         double off_max)
    : given_(std::move(given)),
      rates_(std::move(rates)),
      bodies_(std::move(bodies)),
      off_max_(off_max),
      sources_(bodies_.size()),
      times_(given_->times()) {
    for (const StepRates& of_file : rates_) {
        for (const BodyColumn& column : of_file.bodies) {
            sources_[column.body] = {&of_file, column.column};
        }
    }
    for (std::uint64_t step = times_.size(); step < given_->steps(); ++step) {
        times_.push_back(static_cast<double>(step));
    }
}

Result<std::unique_ptr<CurvedSteps>> CurvedSteps::create(std::unique_ptr<StepPoses> given,
                                                         std::vector<StepRates> rates,
                                                         std::vector<PlacedBody> bodies,
                                                         double off_max,
                                                         const StopCheck& stop) {
    std::unique_ptr<CurvedSteps> made(
        new CurvedSteps(std::move(given), std::move(rates), std::move(bodies), off_max));
    CD_TRY(made->find_keys(stop));
    return made;
}

Status CurvedSteps::find_keys(const StopCheck& stop) {
    Span span;
    span.to = CD_TRY(given_->read(0));
    begins_.push_back(0);
    for (; span.step + 1 < given_->steps(); ++span.step) {
        if (stop && stop()) {
            return interrupted();
        }
        span.from = std::move(span.to);
        span.to = CD_TRY(given_->read(span.step + 1));
        const double parts = CD_TRY(parts_of(span));
        if (!(parts + static_cast<double>(begins_.back()) < curve_keys_max)) {
            const Error error = too_many_keys(off_max_);
            return Error{error.code, "step " + std::to_string(span.step) + ": " + error.detail};
        }
        begins_.push_back(begins_.back() + static_cast<std::uint64_t>(parts));
    }
    return Done{};
}

/// Returns into how many parts a step is cut.
Result<double> CurvedSteps::parts_of(const Span& span) const {
    double parts = 1;
    std::vector<std::uint32_t> straight;
    for (std::uint32_t body = 0; body < bodies_.size(); ++body) {
        if (!span.from[body] || !span.to[body]) {
            continue;
        }
        if (sources_[body].rates != nullptr) {
            parts = std::max(parts, CD_TRY(curve_parts(span, body)));
        } else if (!bodies_[body].is_fixed) {
            static_cast<void>(CD_TRY(straight_path(span, body)));
            straight.push_back(body);
        }
    }
    for (const std::uint32_t body : parts > 1 ? straight : std::vector<std::uint32_t>()) {
        parts = std::max(parts, CD_TRY(straight_parts(span, body)));
    }
    return parts;
}

Result<double> CurvedSteps::curve_parts(const Span& span, std::uint32_t body) const {
    const double radius = bodies_[body].radius;
    const std::string here = name(span.step, body) + ": ";
    if (!(seconds(span.step) > 0)) {
        return bad_input(name(span.step + 1, body) + ": the time " +
                         exact_text(times_[span.step + 1]) + " is not after " +
                         exact_text(times_[span.step]) + " of the step before");
    }
    const auto phase = CD_TRY(within(here, curve(span, body)));
    const double gap = CD_TRY(within(here, gap_of(phase, *span.to[body], radius)));
    CD_TRY(within(name(span.step + 1, body) + ": ", check_gap(gap, 0.5, off_max_)));
    return within(here, key_parts(phase, radius, off_max_, share_of_body));
}

Result<BodyPath> CurvedSteps::straight_path(const Span& span, std::uint32_t body) const {
    const std::string here = name(span.step, body) + ": ";
    const Pose from = CD_TRY(within(here, unit_key(*span.from[body])));
    const Pose to = CD_TRY(within(here, unit_key(*span.to[body])));
    return within(here, path_between(from, to));
}

Result<double> CurvedSteps::straight_parts(const Span& span, std::uint32_t body) const {
    const BodyPath path = CD_TRY(straight_path(span, body));
    const double radius = bodies_[body].radius;
    const double rounding = rounding_on(path, radius);
    const double allowed = share_of_body * off_max_;
    if (!(rounding <= allowed / 6)) {
        return bad_input(name(span.step, body) +
                         ": numbers of 64 bits do not tell the path within " +
                         exact_text(off_max_) + "; allow at least " +
                         exact_text(rounding * (6 / share_of_body)));
    }
    return parts_of_turn(path, radius, allowed - rounding);
}

Result<CurvePhase> CurvedSteps::curve(const Span& span, std::uint32_t body) const {
    const auto& [of_file, column] = sources_[body];
    return curve_of(*span.from[body],
                    of_file->rates[span.step * of_file->columns + column],
                    seconds(span.step));
}

/// Returns where a body is between two steps that both have it.
Result<Pose> CurvedSteps::pose_in(const Span& span, std::uint32_t body, double share) const {
    if (bodies_[body].is_fixed) {
        return *span.from[body];
    }
    if (sources_[body].rates != nullptr) {
        const auto phase = CD_TRY(curve(span, body));
        return phase.at(phase.seconds * share);
    }
    const BodyPath path = CD_TRY(straight_path(span, body));
    return pose_at(path, share);
}

std::vector<double> CurvedSteps::times() const {
    std::vector<double> times;
    times.reserve(steps());
    for (std::uint64_t step = 0; step + 1 < begins_.size(); ++step) {
        const std::uint64_t parts = begins_[step + 1] - begins_[step];
        for (std::uint64_t i = 0; i < parts; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(parts);
            times.push_back(times_[step] + seconds(step) * share);
        }
    }
    times.push_back(times_.back());
    return times;
}

Result<PosesOfStep> CurvedSteps::read(std::uint64_t step) {
    const auto next = std::ranges::upper_bound(begins_, step);
    const auto given = static_cast<std::uint64_t>(next - begins_.begin() - 1);
    const std::uint64_t part = step - begins_[given];
    if (part == 0) {
        return given_->read(given);
    }
    if (!kept_ || kept_->step != given) {
        Span span{given, CD_TRY(given_->read(given)), CD_TRY(given_->read(given + 1))};
        kept_ = std::move(span);
    }
    const double share =
        static_cast<double>(part) / static_cast<double>(begins_[given + 1] - begins_[given]);
    PosesOfStep poses(bodies_.size());
    for (std::uint32_t body = 0; body < poses.size(); ++body) {
        if (kept_->from[body] && kept_->to[body]) {
            poses[body] = CD_TRY(pose_in(*kept_, body, share));
        }
    }
    return poses;
}

/// Names a body's pose at a step for errors.
std::string CurvedSteps::name(std::uint64_t step, std::uint32_t body) const {
    const auto& [of_file, column] = sources_[body];
    return of_file != nullptr ? of_file->name(step, column)
                              : "step " + std::to_string(step) + ": " + bodies_[body].name;
}

} // namespace cd
