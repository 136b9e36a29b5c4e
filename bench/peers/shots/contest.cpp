#include "bench/peers/shots/contest.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/shots/judge.hpp"
#include "bench/peers/turns.hpp"
#include "bench/timed_work.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace cd::bench {

namespace {

constexpr std::size_t hits_of_line = 64; // Room for so many hits of a line on average.

enum Turn : std::uint32_t { Load, Check, Each };

/// What an engine tells the parent.
struct Shared {
    std::uint64_t hits = 0;
    double seconds = 0;
};

/// Drives one engine in a process of its own.
class Lane {
  public:
    Lane(const ShotScene& scene, const ShotEngine& engine, const ShotContestOptions& options)
        : options_(options),
          shared_(1),
          found_(hits_of_line * scene.line_count()),
          body_(engine.make_body()),
          child_(options.cpu,
                 [this, &scene](std::uint32_t turn) { take(scene, static_cast<Turn>(turn)); }) {}

    void take_turn(Turn turn) {
        if (child_.take_turn(turn, options_.limit) == Ending::Done && turn == Each) {
            seconds_.push_back(shared_[0].seconds);
        }
    }

    [[nodiscard]] Ending ending() const { return child_.ending(); }
    [[nodiscard]] double seconds() const { return ending() == Ending::Done ? median(seconds_) : 0; }
    [[nodiscard]] std::vector<ShotHit> hits() const {
        const auto found = found_.values().first(shared_[0].hits);
        return {found.begin(), found.end()};
    }

  private:
    /// Runs in the child.
    void take(const ShotScene& scene, Turn turn) {
        if (turn == Load) {
            body_->load(scene);
            return;
        }
        hits_.clear();
        const double start = processor_seconds();
        body_->shoot(hits_);
        shared_[0].seconds = processor_seconds() - start;
        if (turn == Check) {
            CD_CHECK(hits_.size() <= found_.values().size());
            std::copy(hits_.begin(), hits_.end(), found_.values().begin());
            shared_[0].hits = hits_.size();
        }
    }

    const ShotContestOptions& options_;
    SharedArray<Shared> shared_;
    SharedArray<ShotHit> found_;
    std::vector<double> seconds_;
    std::unique_ptr<ShotBody> body_;
    std::vector<ShotHit> hits_; ///< The child's; keeps its memory from turn to turn.
    TurnTaker child_;
};

/// Returns the crossings of ours as hits of an engine that has no others.
std::vector<ShotHit> crossings_of(const std::vector<ShotHit>& hits) {
    std::vector<ShotHit> crossings;
    std::copy_if(hits.begin(), hits.end(), std::back_inserter(crossings), [](const ShotHit& hit) {
        return (hit.flags & hit_flag::crosses) != 0;
    });
    return crossings;
}

/// Compares engines with ours on one scene.
class Referee {
  public:
    Referee(const ShotScene& scene, std::vector<ShotHit> ours, const ShotContestOptions& options)
        : mesh_(*scene.mesh),
          lines_(posed_lines(scene)),
          ours_(std::move(ours), scene.line_count()),
          judged_max_(options.judged_max) {}

    void judge(std::vector<ShotHit> hits, ShotOutcome& outcome) const {
        outcome.hits = hits.size();
        const HitsByLine theirs(std::move(hits), ours_.lines());
        for (std::uint32_t line = 0; line < theirs.lines(); ++line) {
            outcome.odd_lines += theirs.of(line).size() % 2;
            const HitErrors errors = compare_hits(ours_.of(line), theirs.of(line));
            outcome.missing += errors.missing;
            outcome.doubled += errors.doubled;
            if (!errors.is_none() && ++outcome.wrong_lines <= judged_max_) {
                ++outcome.judged;
                outcome.ours_wrong +=
                    is_right(mesh_, lines_[line], ours_.of(line), theirs.of(line)) ? 0u : 1u;
            }
        }
    }

  private:
    const Mesh& mesh_;
    std::vector<PosedLine> lines_;
    HitsByLine ours_;
    std::uint64_t judged_max_;
};

} // namespace

std::vector<ShotOutcome> run_shot_contest(const ShotScene& scene,
                                          std::span<const ShotEngine> engines,
                                          const ShotContestOptions& options) {
    std::vector<std::unique_ptr<Lane>> lanes;
    for (const ShotEngine& engine : engines) {
        lanes.push_back(std::make_unique<Lane>(scene, engine, options));
        lanes.back()->take_turn(Load);
        lanes.back()->take_turn(Check);
    }
    for (std::size_t round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            lanes[(round + i) % lanes.size()]->take_turn(Each);
        }
    }
    if (lanes.front()->ending() != Ending::Done) {
        throw std::runtime_error("our engine did not come through " + scene.body);
    }
    const Referee referee(scene, lanes.front()->hits(), options);
    std::vector<ShotOutcome> outcomes;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        ShotOutcome& outcome = outcomes.emplace_back();
        outcome.ending = lanes[i]->ending();
        outcome.seconds = lanes[i]->seconds();
        if (outcome.ending == Ending::Done) {
            referee.judge(engines[i].is_ours ? crossings_of(lanes[i]->hits()) : lanes[i]->hits(),
                          outcome);
        }
    }
    return outcomes;
}

} // namespace cd::bench
