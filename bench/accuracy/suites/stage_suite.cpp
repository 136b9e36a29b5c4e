#include "bench/accuracy/suites/stage_suite.hpp"

#include "bench/accuracy/timing.hpp"

#include <array>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

constexpr std::size_t stages = pair_stage_count;

std::size_t highest_stage(const PairStatistics& before, const PairStatistics& after) {
    std::size_t highest = 0;
    for (std::size_t i = 0; i < stages; ++i) {
        highest = after.settled[i] > before.settled[i] ? i : highest;
    }
    return highest;
}

/// Part of a group's candidates.
struct Part {
    std::vector<Candidate> candidates;
    std::vector<Candidate> in_blocks;

    void add(const PairGroup& group, std::size_t i) {
        candidates.push_back(group.candidates[i]);
        if (!group.in_blocks.candidates.empty()) {
            in_blocks.push_back(group.in_blocks.candidates[i]);
        }
    }
    [[nodiscard]] PairGroup of(PairGroup group) const {
        group.candidates = candidates;
        group.in_blocks.candidates = in_blocks;
        return group;
    }
};

/// Candidates of each group, by the stage that settles them.
using Split = std::array<std::vector<Part>, stages>;

Split split_by_stage(const PairBatch& batch) {
    Split split;
    for (const PairGroup& group : batch.groups()) {
        for (auto& each : split) {
            each.emplace_back();
        }
        TrianglePairTest test(group.poses);
        for (std::size_t i = 0; i < group.candidates.size(); ++i) {
            // Repeats the candidate: few at once would skip the float stage.
            std::array<Candidate, 16> alike;
            alike.fill(group.candidates[i]);
            const PairStatistics before = test.statistics();
            static_cast<void>(test.classify(group.a, group.b, alike));
            split[highest_stage(before, test.statistics())].back().add(group, i);
        }
    }
    return split;
}

/// Groups with their pair tests.
struct Timed {
    std::string name;
    std::size_t pairs = 0;
    std::vector<std::pair<PairGroup, TrianglePairTest>> groups;

    void add(const PairGroup& group) {
        if (!group.candidates.empty()) {
            pairs += group.candidates.size();
            groups.emplace_back(group, TrianglePairTest(group.poses));
        }
    }

    void run() {
        for (auto& [group, test] : groups) {
            decide_as_product(test, group, [](std::span<const PairClass>) {});
        }
    }
};

} // namespace

void run_stages(const std::string& suite,
                const std::string& category,
                const PairBatch& batch,
                std::size_t rounds,
                CsvFile& csv) {
    const Split split = split_by_stage(batch);
    std::vector<Timed> timed(1);
    timed[0].name = "all";
    for (const PairGroup& group : batch.groups()) {
        timed[0].add(group);
    }
    for (std::size_t stage = 0; stage < stages; ++stage) {
        Timed& now = timed.emplace_back();
        now.name = to_text(static_cast<PairStage>(stage));
        for (std::size_t g = 0; g < batch.groups().size(); ++g) {
            now.add(split[stage][g].of(batch.groups()[g]));
        }
    }
    std::erase_if(timed, [](const Timed& each) { return each.pairs == 0; });
    const auto medians =
        interleaved_medians(rounds, timed.size(), [&](std::size_t i) { timed[i].run(); });
    for (std::size_t i = 0; i < timed.size(); ++i) {
        csv.row({suite,
                 category,
                 timed[i].name,
                 cell(std::uint64_t{timed[i].pairs}),
                 cell(1e9 * medians[i] / static_cast<double>(timed[i].pairs))});
    }
}

CsvFile open_stages_csv(const std::filesystem::path& folder) {
    return {folder / "stages.csv", {"suite", "category", "stage", "pairs", "ns_pair"}};
}

} // namespace cd::bench
