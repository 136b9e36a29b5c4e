// The verb `verify`: repeats a sample of a run's scenarios here.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/words.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/folder/opened_run.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// `count` distinct numbers below `total`, ascending, drawn from the seed (Floyd).
std::vector<std::uint64_t> sample(std::uint64_t total, std::uint64_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<std::uint64_t> drawn;
    count = std::min(count, total);
    if (count == total) {
        for (std::uint64_t i = 0; i < total; ++i) {
            drawn.push_back(i);
        }
        return drawn;
    }
    std::set<std::uint64_t> taken;
    for (std::uint64_t top = total - count; top < total; ++top) {
        const std::uint64_t number = random() % (top + 1);
        taken.insert(taken.contains(number) ? top : number);
    }
    return {taken.begin(), taken.end()};
}

struct Counts {
    std::uint64_t same = 0;
    std::uint64_t different = 0;
    std::uint64_t not_run = 0; ///< Scenarios without a record, or that failed in the run.
};

enum class Outcome : std::uint8_t { Same, Different, NotRun };

/// Runs a scenario again and compares its record with the one in the folder.
Result<Outcome>
compare(OpenedRun& run, PreparedJob& job, const ScenarioRunner& runner, std::uint64_t index) {
    const auto kept = run.records().find(index);
    if (!kept) {
        return kept.error();
    }
    if (!kept.value() || kept.value()->result.kind == ScenarioClass::Failed) {
        return Outcome::NotRun;
    }
    const auto scenario = job.poses->read(index, 1);
    if (!scenario) {
        return scenario.error();
    }
    const ScenarioRun again = runner.run(scenario.value().front());
    return encode_result(again.result) == kept.value()->bytes ? Outcome::Same : Outcome::Different;
}

/// Prints that scenario `index` differs, unless ten (`number`) have been printed before.
void tell_difference(std::uint64_t index, std::uint64_t number) {
    constexpr std::uint64_t shown_max = 10;
    if (number < shown_max) {
        std::printf("scenario %llu differs\n", static_cast<unsigned long long>(index));
    }
}

Result<Counts>
compare_all(OpenedRun& run, PreparedJob& job, const std::vector<std::uint64_t>& indices) {
    const ScenarioRunner runner(*job.trees[0], *job.trees[1], job.query);
    Counts counts;
    for (const std::uint64_t index : indices) {
        const auto outcome = compare(run, job, runner, index);
        if (!outcome) {
            return outcome.error();
        }
        if (outcome.value() == Outcome::Different) {
            tell_difference(index, counts.different);
        }
        counts.same += outcome.value() == Outcome::Same ? 1 : 0;
        counts.different += outcome.value() == Outcome::Different ? 1 : 0;
        counts.not_run += outcome.value() == Outcome::NotRun ? 1 : 0;
    }
    return counts;
}

} // namespace

int execute(const VerifyCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    const std::filesystem::path tree_cache = tree_cache_folder(command.tree_cache);
    auto at_hand = RunAtHand::open(command.run, command.master, tree_cache);
    if (!at_hand) {
        return fail(at_hand.error());
    }
    OpenedRun& run = at_hand.value().run;
    ThreadPool pool(command.threads);
    TreeCache cache(tree_cache);
    auto job = at_hand.value().prepare(Trees::Always, cache, pool);
    if (!job) {
        return fail(job.error());
    }
    const auto indices = sample(job.value().poses->count(), command.sample, command.seed);
    const auto counts = compare_all(run, job.value(), indices);
    if (!counts) {
        return fail(counts.error());
    }
    const auto& [same, different, not_run] = counts.value();
    std::printf("%s of %s run again: %s the same, %s different, %s could not be run\n",
                grouped(indices.size()).c_str(),
                counted(job.value().poses->count(), "scenario").c_str(),
                grouped(same).c_str(),
                grouped(different).c_str(),
                grouped(not_run).c_str());
    if (different != 0) {
        return exit_contacts;
    }
    return not_run == 0 ? exit_done : exit_incomplete;
}

} // namespace cd
