// The verb `verify`: repeats a sample of a run's scenarios here, in integers.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/folder/opened_run.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <cstdio>
#include <random>
#include <set>
#include <vector>

namespace cd {

namespace {

/// Draws `count` distinct numbers below `total` from the seed (Floyd); returns them ascending.
std::vector<std::uint64_t> sample(std::uint64_t total, std::uint64_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    count = std::min(count, total);
    std::set<std::uint64_t> taken;
    for (std::uint64_t top = total - count; top < total; ++top) {
        const std::uint64_t number = random() % (top + 1);
        taken.insert(taken.contains(number) ? top : number);
    }
    return {taken.begin(), taken.end()};
}

constexpr std::uint64_t differences_shown_max = 10;

struct Counts {
    std::uint64_t same = 0;
    std::uint64_t different = 0;
    std::uint64_t not_run = 0; ///< Scenarios without a record, or that failed in the run.
};

enum class Outcome : std::uint8_t { Same, Different, NotRun };

/// Runs a scenario again and compares its record with the run's record.
Result<Outcome>
compare(OpenedRun& run, PreparedJob& job, const ScenarioRunner& runner, std::uint64_t index) {
    const auto kept = CD_TRY(run.records().find(index));
    if (!kept || kept->result.kind == ScenarioClass::Failed) {
        return Outcome::NotRun;
    }
    const auto scenario = CD_TRY(job.poses->read(index, 1));
    const ScenarioRun again = runner.run(scenario.front());
    return encode_result(again.result) == kept->bytes ? Outcome::Same : Outcome::Different;
}

Result<Counts>
compare_all(OpenedRun& run, PreparedJob& job, const std::vector<std::uint64_t>& indices) {
    // Integers decide every candidate: a wrong bound of the faster stages cannot repeat itself.
    const ScenarioRunner runner(*job.trees[0], *job.trees[1], job.query, PairStage::WideInteger);
    Counts counts;
    for (const std::uint64_t index : indices) {
        const auto outcome = CD_TRY(compare(run, job, runner, index));
        if (outcome == Outcome::Different && counts.different < differences_shown_max) {
            std::printf("scenario %llu differs\n", static_cast<unsigned long long>(index));
        }
        counts.same += outcome == Outcome::Same ? 1 : 0;
        counts.different += outcome == Outcome::Different ? 1 : 0;
        counts.not_run += outcome == Outcome::NotRun ? 1 : 0;
    }
    return counts;
}

} // namespace

Result<int> perform(const VerifyCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    ThreadPool pool(command.threads);
    auto [run, job, map] = CD_TRY(open_run_at_hand(
        command.run, command.master, command.tree_cache, {.trees = Trees::Always}, pool));
    CD_TRY(check_exact(run.manifest()));
    const auto indices = sample(job.poses->count(), command.sample, command.seed);
    const auto [same, different, not_run] = CD_TRY(compare_all(run, job, indices));
    std::printf("%s of %s run again: %s the same, %s different, %s could not be run\n",
                grouped(indices.size()).c_str(),
                counted(job.poses->count(), "scenario").c_str(),
                grouped(same).c_str(),
                grouped(different).c_str(),
                grouped(not_run).c_str());
    if (different != 0) {
        return exit_contacts;
    }
    return not_run == 0 ? exit_done : exit_incomplete;
}

} // namespace cd
