#include "bench/peers/motions/contest.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/turns.hpp"
#include "bench/timed_work.hpp"

#include <memory>
#include <stdexcept>

namespace cd::bench {

namespace {

constexpr std::uint32_t failures_max = 3; // Crashes and hangs, after which an engine is out.

/// What an engine tells the parent of a path.
struct Told {
    double seconds = 0;
    Impact impact;
};

/// Drives one engine in processes of its own: a new one after each crash or hang. Turn 0 builds,
/// and turn p + 1 runs path p.
class Lane {
  public:
    Lane(const MotionScene& scene, const MotionEngine& engine, const MotionContestOptions& options)
        : scene_(scene),
          options_(options),
          told_(scene.paths.size()),
          seconds_(scene.paths.size()),
          bodies_(engine.make_bodies()),
          outcomes_(scene.paths.size()) {}

    void take_round() {
        for (std::size_t p = 0; p < scene_.paths.size(); ++p) {
            if (failures_ < failures_max && used_ <= options_.budget_seconds) {
                take_path(p);
            }
        }
    }

    [[nodiscard]] std::vector<PathOutcome> outcomes() {
        for (std::size_t p = 0; p < outcomes_.size(); ++p) {
            if (!seconds_[p].empty()) {
                outcomes_[p].seconds = median(seconds_[p]);
            }
        }
        return outcomes_;
    }

  private:
    void take_path(std::size_t p) {
        Ending ending = start();
        if (ending == Ending::Done) {
            ending = child_->take_turn(static_cast<std::uint32_t>(p + 1), options_.limit);
        }
        outcomes_[p].is_tried = true;
        outcomes_[p].ending = ending;
        if (ending == Ending::Done) {
            seconds_[p].push_back(told_[p].seconds);
            used_ += told_[p].seconds;
            outcomes_[p].impact = told_[p].impact;
        } else {
            ++failures_;
            child_.reset();
        }
    }

    /// Starts the child and lets it build, if there is none.
    Ending start() {
        if (child_) {
            return Ending::Done;
        }
        child_ =
            std::make_unique<TurnTaker>(options_.cpu, [this](std::uint32_t turn) { take(turn); });
        return child_->take_turn(0, options_.limit);
    }

    /// Runs in the child.
    void take(std::uint32_t turn) {
        if (turn == 0) {
            bodies_->load(scene_);
            return;
        }
        const std::size_t p = turn - 1;
        const double start = processor_seconds();
        const Impact impact = bodies_->find(scene_.paths[p]);
        told_[p] = {processor_seconds() - start, impact};
    }

    const MotionScene& scene_;
    const MotionContestOptions& options_;
    SharedArray<Told> told_;
    std::vector<std::vector<double>> seconds_; ///< By path and round.
    std::unique_ptr<MotionBodies> bodies_;
    std::vector<PathOutcome> outcomes_;
    std::unique_ptr<TurnTaker> child_;
    std::uint32_t failures_ = 0;
    double used_ = 0;
};

/// Returns by how much a time is outside of a bracket.
double off_bracket(double time, const Impact& bracket) {
    if (time < bracket.t0) {
        return time - bracket.t0;
    }
    return time > bracket.t1 ? time - bracket.t1 : 0;
}

} // namespace

std::vector<std::vector<PathOutcome>> run_motion_contest(const MotionScene& scene,
                                                         std::span<const MotionEngine> engines,
                                                         const MotionContestOptions& options) {
    std::vector<std::unique_ptr<Lane>> lanes;
    for (const MotionEngine& engine : engines) {
        lanes.push_back(std::make_unique<Lane>(scene, engine, options));
    }
    for (std::size_t round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            lanes[(round + i) % lanes.size()]->take_round();
        }
    }
    std::vector<std::vector<PathOutcome>> outcomes;
    for (const auto& lane : lanes) {
        outcomes.push_back(lane->outcomes());
    }
    for (const PathOutcome& ours : outcomes.front()) {
        if (!ours.is_tried || ours.ending != Ending::Done) {
            throw std::runtime_error("our engine did not come through " + scene.name);
        }
    }
    return outcomes;
}

ImpactErrors compare_impacts(std::span<const PathOutcome> ours,
                             std::span<const PathOutcome> theirs) {
    using Kind = Impact::Kind;
    ImpactErrors errors;
    for (std::size_t p = 0; p < ours.size(); ++p) {
        const Impact& proven = ours[p].impact;
        const Impact& told = theirs[p].impact;
        if (!theirs[p].is_tried) {
            continue;
        }
        if (theirs[p].ending != Ending::Done) {
            ++errors.unanswered;
        } else if (proven.kind == Kind::Found && told.kind == Kind::Found) {
            errors.shares_off.push_back(off_bracket(told.t1, proven));
        } else {
            errors.missed += proven.kind == Kind::Found ? 1u : 0u;
            errors.invented += proven.kind == Kind::None && told.kind == Kind::Found ? 1u : 0u;
        }
    }
    return errors;
}

} // namespace cd::bench
