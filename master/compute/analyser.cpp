#include "master/compute/analyser.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/distance_looks.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/settle.hpp"
#include "master/dispatch/cost_model.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <span>

namespace cd {

namespace {

/// Analyses one scenario as in the paper, but does not set `bytes`.
Analysis analyse_uncounted(const AnalysisInput& input, const Scenario& scenario) {
    if (input.sketch) {
        return input.sketch(scenario);
    }
    Analysis analysis;
    analysis.scenario = scenario;
    // The root of an upper tree is the whole body's box, so this descent includes the broad phase.
    const TreeTop& top_a = *input.tops.at(scenario.body_a);
    const TreeTop& top_b = *input.tops.at(scenario.body_b);
    RunOptions options;
    options.radii = radii_of(input.radii, scenario);
    Result<CollidingRoots> roots = query_roots(top_a, top_b, scenario, input.query, options.radii);
    if (!roots) {
        analysis.finished = failed_result(scenario, input.query, roots.error());
        return analysis;
    }
    analysis.cost.search.box_tests = roots.value().box_tests;
    if (roots.value().pairs.empty()) {
        ScenarioRun run = run_on_subtrees({}, scenario, input.query, options);
        analysis.finished = std::move(run.result);
        analysis.cost.search += run.statistics;
        analysis.cost.inside = input.settler->settle(scenario, *analysis.finished);
    } else {
        analysis.pairs = std::move(roots.value().pairs);
        std::span<const RootPair> wanted = analysis.pairs;
        std::vector<RootPair> first;
        if (looks_twice(input.query, analysis.pairs)) {
            first = first_look(top_a, top_b, scenario.poses, analysis.pairs);
            wanted = first;
        }
        analysis.roots_a = roots_of_a(wanted);
        analysis.roots_b = roots_of_b(wanted);
        analysis.predicted_ns = predicted_ns(meeting_size(top_a, top_b, analysis.pairs));
    }
    return analysis;
}

std::uint64_t bytes_in_batch(const Analysis& analysis) {
    return packed_bytes(analysis.scenario) + sizeof(std::uint32_t) +
           analysis.pairs.size() * sizeof(RootPair);
}

void analyse_block(const AnalysisInput& input,
                   const std::vector<bool>* done,
                   AnalysedBlock& block) {
    const auto begin = std::chrono::steady_clock::now();
    const PositionRange& range = block.positions;
    const Result<std::vector<Scenario>> scenarios = input.poses->read(range.first, range.count);
    if (!scenarios) {
        block.error = scenarios.error();
        return;
    }
    block.scenarios.reserve(range.count);
    std::uint64_t next = range.first;
    for (const Scenario& scenario : scenarios.value()) {
        const std::uint64_t position = next++;
        if (done != nullptr && scenario.index < done->size() && (*done)[scenario.index]) {
            continue;
        }
        Analysis& analysis = block.scenarios.emplace_back(analyse_uncounted(input, scenario));
        analysis.position = position;
        if (!input.sketch) {
            analysis.bytes = bytes_in_batch(analysis);
        }
    }
    block.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

Analysis analyse(const AnalysisInput& input, const Scenario& scenario) {
    Analysis analysis = analyse_uncounted(input, scenario);
    analysis.bytes = bytes_in_batch(analysis);
    return analysis;
}

/// Shared with the functions on the pool, which may outlive the analyser.
struct Analyser::State {
    AnalysisInput input;
    std::function<void(AnalysedBlock)> deliver;

    mutable std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t started = 0;                    ///< Number of blocks started.
    std::uint64_t delivered = 0;                  ///< Number of blocks delivered.
    std::map<std::uint64_t, AnalysedBlock> ready; ///< Analysed blocks that wait for earlier ones.
    bool delivering = false;
    bool stopped = false;

    void run_block(std::uint64_t number, const std::vector<bool>* done, AnalysedBlock block);
    void deliver_ready();
};

void Analyser::State::run_block(std::uint64_t number,
                                const std::vector<bool>* done,
                                AnalysedBlock block) {
    {
        const std::lock_guard lock(mutex);
        if (stopped) {
            return;
        }
    }
    analyse_block(input, done, block);
    {
        const std::lock_guard lock(mutex);
        ready.emplace(number, std::move(block));
        // If another thread is delivering, it also delivers this block.
        if (delivering || stopped) {
            return;
        }
        delivering = true;
    }
    deliver_ready();
}

void Analyser::State::deliver_ready() {
    std::unique_lock lock(mutex);
    while (!stopped && !ready.empty() && ready.begin()->first == delivered) {
        AnalysedBlock block = std::move(ready.begin()->second);
        ready.erase(ready.begin());
        ++delivered;
        lock.unlock();
        deliver(std::move(block));
        lock.lock();
    }
    delivering = false;
    changed.notify_all();
}

Analyser::Analyser(Pool& pool, AnalysisInput input, std::function<void(AnalysedBlock)> deliver)
    : pool_(pool), state_(std::make_shared<State>()) {
    state_->input = std::move(input);
    state_->deliver = std::move(deliver);
}

Analyser::~Analyser() {
    std::unique_lock lock(state_->mutex);
    state_->stopped = true;
    state_->changed.wait(lock, [this] { return !state_->delivering; });
}

void Analyser::start(const PositionRange& positions,
                     const Losses& losses,
                     std::shared_ptr<const std::vector<bool>> done) {
    CD_CHECK(positions.count != 0 && positions.count <= limits::analysis_block_scenarios);
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->stopped) {
            return;
        }
        number = state_->started++;
    }
    ++under_way_;
    pool_.post([state = state_, number, positions, losses, done = std::move(done)] {
        state->run_block(number, done.get(), {positions, losses, {}, 0, std::nullopt});
    });
}

} // namespace cd
