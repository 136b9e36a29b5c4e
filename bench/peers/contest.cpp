#include "bench/peers/contest.hpp"

#include "bench/accuracy/timing.hpp"
#include "bench/peers/turns.hpp"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace cd::bench {

namespace {

enum Turn : std::uint32_t {
    Load,
    Check, ///< Compare with the reference, untimed.
    Pass,  ///< Time all poses together.
    Each,  ///< Time each pose alone.
};

/// A child's report, in shared memory.
struct Told {
    double build_seconds;
    double pass_seconds;
    std::uint64_t memory_bytes;
    std::uint64_t resident_bytes;
    std::uint64_t pairs_found;
    std::uint64_t missing;
    std::uint64_t extra;
    std::uint64_t judged;
    std::uint64_t wrong_any;
};

/// Returns this process's anonymous memory after freed memory is returned to the system.
std::uint64_t memory_in_use() {
    ::malloc_trim(0);
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
        if (word == "RssAnon:") {
            std::uint64_t kilobytes = 0;
            file >> kilobytes;
            return kilobytes * 1024;
        }
    }
    return 0;
}

/// Returns the level at which an engine finds all pairs, or any; nothing if it cannot.
std::optional<Level> level_for(const Engine& engine, Level wanted) {
    for (const Level level : engine.levels) {
        if (wanted == Level::Any ? level == Level::Any : level >= wanted) {
            return level;
        }
    }
    return std::nullopt;
}

/// Runs an engine in the child process.
class Contestant {
  public:
    Contestant(const Scene& scene,
               const Reference& reference,
               const Engine& engine,
               Level level,
               Told& told,
               std::span<double> pose_seconds,
               std::span<Disagreement> judged)
        : scene_(scene),
          reference_(reference),
          engine_(engine),
          level_(level),
          told_(told),
          pose_seconds_(pose_seconds),
          judged_(judged) {}

    void take(std::uint32_t turn) {
        switch (static_cast<Turn>(turn)) {
        case Load:
            load();
            break;
        case Check:
            check();
            break;
        case Pass:
            told_.pass_seconds = seconds_of([&] {
                for (const PosePair& poses : scene_.poses) {
                    touches_ += meshes_->ask(poses, level_).touches ? 1u : 0u;
                }
            });
            break;
        case Each:
            time_each();
            break;
        }
        told_.resident_bytes = meshes_->resident_bytes();
        if (turn != Load && told_.memory_bytes == 0) {
            told_.memory_bytes = memory_in_use() - memory_before_;
        }
    }

  private:
    /// Loads copies of the meshes, so that an engine that keeps them is charged for them.
    void load() {
        memory_before_ = memory_in_use();
        const auto a = std::make_shared<const Mesh>(*scene_.a);
        const auto b = std::make_shared<const Mesh>(*scene_.b);
        meshes_ = engine_.make_meshes();
        told_.build_seconds = seconds_of([&] { meshes_->load(a, b); });
    }

    void check() {
        const std::size_t judged_a_pose =
            std::max<std::size_t>(1, judged_.size() / scene_.poses.size());
        for (std::size_t p = 0; p < scene_.poses.size(); ++p) {
            MeshAnswer answer = meshes_->ask(scene_.poses[p], level_);
            told_.wrong_any += answer.touches != (reference_.pair_count(p) > 0) ? 1u : 0u;
            if (level_ == Level::Any) {
                continue;
            }
            const PairSet found = pair_set(std::move(answer));
            told_.pairs_found += found.size();
            const std::vector<Disagreement> all = disagreements(reference_, p, found);
            for (std::size_t i = 0; i < all.size(); ++i) {
                (all[i].is_extra ? told_.extra : told_.missing) += 1;
                // Picks judged pairs evenly over a pose's pairs, and over the poses.
                const bool is_picked =
                    i * judged_a_pose / all.size() != (i + 1) * judged_a_pose / all.size() ||
                    all.size() <= judged_a_pose;
                if (is_picked && told_.judged < judged_.size()) {
                    judged_[told_.judged++] = all[i];
                }
            }
        }
    }

    void time_each() {
        for (std::size_t p = 0; p < scene_.poses.size(); ++p) {
            pose_seconds_[p] = seconds_of(
                [&] { touches_ += meshes_->ask(scene_.poses[p], level_).touches ? 1u : 0u; });
        }
    }

    const Scene& scene_;
    const Reference& reference_;
    const Engine& engine_;
    Level level_;
    Told& told_;
    std::span<double> pose_seconds_;
    std::span<Disagreement> judged_;
    std::unique_ptr<MeshEngine> meshes_;
    std::uint64_t memory_before_ = 0;
    std::uint64_t touches_ = 0;
};

/// Drives one engine in one series of turns, in the parent process.
class Lane {
  public:
    Lane(const Scene& scene,
         const Reference& reference,
         const Engine& engine,
         Level wanted,
         const ContestOptions& options)
        : poses_(scene.poses.size()),
          options_(options),
          told_(1),
          pose_seconds_(poses_),
          judged_(options.judged_max) {
        const auto level = level_for(engine, wanted);
        if (!level) {
            return;
        }
        heat_.took_part = true;
        heat_.pass_seconds = std::numeric_limits<double>::infinity();
        const auto contestant = std::make_shared<Contestant>(
            scene, reference, engine, *level, told_[0], pose_seconds_.values(), judged_.values());
        child_.emplace(options.cpu, [contestant](std::uint32_t turn) { contestant->take(turn); });
    }

    void take_turn(Turn turn) {
        if (child_) {
            heat_.ending = child_->take_turn(turn, options_.limit);
        }
    }

    /// Takes a timed turn, unless the budget is used up.
    void take_timed_turn(Turn turn) {
        if (!child_ || (spent_ > 0 && spent_ >= options_.budget_seconds)) {
            return;
        }
        take_turn(turn);
        if (heat_.ending != Ending::Done) {
            return;
        }
        if (turn == Pass) {
            spent_ += told_[0].pass_seconds;
            heat_.pass_seconds = std::min(heat_.pass_seconds, told_[0].pass_seconds);
            ++heat_.passes;
            return;
        }
        const auto seconds = pose_seconds_.values();
        rounds_.emplace_back(seconds.begin(), seconds.end());
        for (const double s : seconds) {
            spent_ += s;
        }
        ++heat_.rounds;
    }

    [[nodiscard]] Heat heat() const {
        Heat heat = heat_;
        for (std::size_t p = 0; p < poses_ && !rounds_.empty(); ++p) {
            std::vector<double> seconds;
            for (const std::vector<double>& round : rounds_) {
                seconds.push_back(round[p]);
            }
            heat.pose_seconds.push_back(median(seconds));
        }
        return heat;
    }

    [[nodiscard]] const Told& told() const { return told_[0]; }
    [[nodiscard]] std::span<const Disagreement> judged() const {
        return judged_.values().first(told().judged);
    }

  private:
    std::size_t poses_;
    const ContestOptions& options_;
    SharedArray<Told> told_;
    SharedArray<double> pose_seconds_;
    SharedArray<Disagreement> judged_;
    std::optional<TurnTaker> child_;
    Heat heat_;
    std::vector<std::vector<double>> rounds_;
    double spent_ = 0;
};

using Lanes = std::vector<std::unique_ptr<Lane>>;

Lanes make_lanes(const Scene& scene,
                 const Reference& reference,
                 std::span<const Engine> engines,
                 Level wanted,
                 const ContestOptions& options) {
    Lanes lanes;
    for (const Engine& engine : engines) {
        lanes.push_back(std::make_unique<Lane>(scene, reference, engine, wanted, options));
        lanes.back()->take_turn(Load);
    }
    return lanes;
}

/// Gives each engine `rounds` timed turns; each round starts with another engine.
void take_rounds(Lanes& lanes, Turn turn, std::size_t rounds) {
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            lanes[(round + i) % lanes.size()]->take_timed_turn(turn);
        }
    }
}

void find_all_pairs(const Scene& scene,
                    const Reference& reference,
                    std::span<const Engine> engines,
                    const ContestOptions& options,
                    std::vector<Outcome>& outcomes) {
    Lanes lanes = make_lanes(scene, reference, engines, Level::Pairs, options);
    for (const auto& lane : lanes) {
        lane->take_turn(Check);
    }
    take_rounds(lanes, Each, options.rounds);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const Told& told = lanes[i]->told();
        Outcome& outcome = outcomes[i];
        outcome.pairs = lanes[i]->heat();
        outcome.build_seconds = told.build_seconds;
        outcome.memory_bytes = told.memory_bytes;
        outcome.resident_bytes = told.resident_bytes;
        outcome.pairs_found = told.pairs_found;
        outcome.missing = told.missing;
        outcome.extra = told.extra;
        outcome.judged = told.judged;
        outcome.ours_wrong = ours_wrong(scene, lanes[i]->judged());
    }
}

void find_any(const Scene& scene,
              const Reference& reference,
              std::span<const Engine> engines,
              const ContestOptions& options,
              std::vector<Outcome>& outcomes) {
    Lanes lanes = make_lanes(scene, reference, engines, Level::Any, options);
    take_rounds(lanes, Pass, options.passes);
    for (const auto& lane : lanes) {
        lane->take_turn(Check);
    }
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const Told& told = lanes[i]->told();
        Outcome& outcome = outcomes[i];
        outcome.any = lanes[i]->heat();
        outcome.wrong_any = told.wrong_any;
        if (!outcome.pairs.took_part) {
            outcome.build_seconds = told.build_seconds;
            outcome.memory_bytes = told.memory_bytes;
            outcome.resident_bytes = told.resident_bytes;
        }
    }
}

} // namespace

std::vector<Outcome> run_contest(const Scene& scene,
                                 const Reference& reference,
                                 std::span<const Engine> engines,
                                 const ContestOptions& options) {
    std::vector<Outcome> outcomes(engines.size());
    for (std::size_t i = 0; i < engines.size(); ++i) {
        outcomes[i].engine = &engines[i];
    }
    find_all_pairs(scene, reference, engines, options, outcomes);
    find_any(scene, reference, engines, options, outcomes);
    return outcomes;
}

} // namespace cd::bench
