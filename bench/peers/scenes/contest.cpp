#include "bench/peers/scenes/contest.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/turns.hpp"
#include "bench/timed_work.hpp"

#include <algorithm>
#include <stdexcept>

namespace cd::bench {

namespace {

enum Turn : std::uint32_t { Check, Each };

/// What an engine tells the parent of all steps.
struct Told {
    std::uint64_t pairs = 0;
    std::uint64_t missing = 0;
};

/// Drives one engine in a process of its own.
class Lane {
  public:
    Lane(const CrowdScene& scene, const SweepEngine& engine, const SweepContestOptions& options)
        : options_(options),
          told_(1),
          seconds_(scene.steps.size()),
          broad_phase_(engine.make()),
          child_(options.cpu,
                 [this, &scene](std::uint32_t turn) { take(scene, static_cast<Turn>(turn)); }) {}

    void take_turn(Turn turn) {
        if (child_.take_turn(turn, options_.limit) == Ending::Done && turn == Each) {
            const auto seconds = seconds_.values();
            rounds_.emplace_back(seconds.begin(), seconds.end());
        }
    }

    [[nodiscard]] SweepOutcome outcome() const {
        SweepOutcome outcome{child_.ending(), {}, told_[0].pairs, told_[0].missing};
        for (std::size_t step = 0; step < seconds_.values().size() && !rounds_.empty(); ++step) {
            std::vector<double> seconds;
            for (const std::vector<double>& round : rounds_) {
                seconds.push_back(round[step]);
            }
            outcome.step_seconds.push_back(median(seconds));
        }
        return outcome;
    }

  private:
    /// Runs in the child.
    void take(const CrowdScene& scene, Turn turn) {
        broad_phase_->load(scene);
        for (std::size_t step = 0; step < scene.steps.size(); ++step) {
            const double start = processor_seconds();
            const std::vector<BodyPair>& pairs = broad_phase_->step(scene.steps[step]);
            seconds_[step] = processor_seconds() - start;
            if (turn == Check) {
                told_[0].pairs += pairs.size();
                if (step == 0 || step + 1 == scene.steps.size()) {
                    told_[0].missing +=
                        count_missing(all_overlapping_pairs(scene, scene.steps[step]), pairs);
                }
            }
        }
    }

    const SweepContestOptions& options_;
    SharedArray<Told> told_;
    SharedArray<double> seconds_;
    std::vector<std::vector<double>> rounds_;
    std::unique_ptr<BroadPhase> broad_phase_;
    TurnTaker child_;
};

bool share_a_point(const WorldBox& left, const WorldBox& right) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (left.high[axis] < right.low[axis] || right.high[axis] < left.low[axis]) {
            return false;
        }
    }
    return true;
}

} // namespace

std::vector<BodyPair> all_overlapping_pairs(const CrowdScene& scene,
                                            const std::vector<Pose>& poses) {
    std::vector<WorldBox> boxes;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        boxes.push_back(world_box(scene.boxes[i].box, poses[i]));
    }
    std::vector<BodyPair> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (share_a_point(boxes[i], boxes[j])) {
                pairs.push_back(pair_of(i, j));
            }
        }
    }
    return pairs;
}

std::uint64_t count_missing(std::span<const BodyPair> wanted, std::vector<BodyPair> found) {
    std::sort(found.begin(), found.end());
    return static_cast<std::uint64_t>(
        std::count_if(wanted.begin(), wanted.end(), [&](const BodyPair& pair) {
            return !std::binary_search(found.begin(), found.end(), pair);
        }));
}

std::vector<SweepOutcome> run_sweep_contest(const CrowdScene& scene,
                                            std::span<const SweepEngine> engines,
                                            const SweepContestOptions& options) {
    std::vector<std::unique_ptr<Lane>> lanes;
    for (const SweepEngine& engine : engines) {
        lanes.push_back(std::make_unique<Lane>(scene, engine, options));
        lanes.back()->take_turn(Check);
    }
    for (std::size_t round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            lanes[(round + i) % lanes.size()]->take_turn(Each);
        }
    }
    std::vector<SweepOutcome> outcomes;
    for (const auto& lane : lanes) {
        outcomes.push_back(lane->outcome());
    }
    if (outcomes.front().ending != Ending::Done) {
        throw std::runtime_error("our engine did not come through " + scene.name);
    }
    return outcomes;
}

} // namespace cd::bench
