#include "bench/cluster/model/simulated_master.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "bench/cluster/model/sketches.hpp"
#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "master/coordinator/coordinator.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <type_traits>
#include <utility>

namespace cd::bench {

namespace {

/// A grid with so many places: its order is that of the workload.
Grid make_line(std::uint64_t count) {
    Grid grid;
    grid.position[0] = {0, 1, count};
    return grid;
}

Submit submission(const Workload& workload, const MasterOptions& options) {
    Submit submit;
    submit.bodies.resize(2);
    submit.bodies[0].mesh = sha256({});
    submit.query.level = Level::Count;
    submit.cluster = options.dispatch;
    submit.cluster.analysis = options.analysis;
    submit.scenarios = workload.count();
    submit.grid = encode_grid(make_line(workload.count()));
    return submit;
}

} // namespace

struct SimulatedMaster::State {
    State(const Workload& of, const MasterOptions& with)
        : workload(of), options(with), pool(with.pool_threads) {}

    Analysis analyse(const Scenario& scenario);
    Result<TakenResults> check(const Results& message);
    void join(std::uint32_t threads);
    void send(WorkerId to, const Message& message);
    [[nodiscard]] const MasterJob& only_job() const { return *coordinator.jobs().find(job); }

    const Workload& workload;
    MasterOptions options;
    MasterCounts counts;
    std::map<BlockId, std::uint64_t> uploads; ///< Number of times that a block was sent.
    Letters letters;                          ///< Of the current event.
    double letter_seconds = 0; ///< Processor time for the letters of the current event.
    const double clock_cost = cpu_clock_cost();
    double spent = 0;           ///< Simulated time of the current work of a pool thread.
    std::uint64_t analysed = 0; ///< Scenarios of the current work of a pool thread.
    JobId job;

    asio::io_context context{1};
    SketchLoop loop;
    SketchNetwork network;
    SketchGeometry geometry{workload, [this](const Scenario& one) { return analyse(one); }};
    SketchPool pool;
    InstantPool blocking;
    SketchJournal journal;
    Coordinator coordinator{
        {.executor = context.get_executor(),
         .loop = loop,
         .network = network,
         .geometry = geometry,
         .store = nullptr,
         .compute = pool,
         .blocking = blocking,
         .journal = journal,
         .directory = {},
         .options = {
             .check = [this](const TaskContent&, const Results& message) { return check(message); },
             .feed = options.feed,
             .dispatch = {.helps_at_end = options.helps_at_end,
                          .strategies = strategies_with(options.variation)},
             .cpu_seconds =
                 [this] { return options.result_seconds * static_cast<double>(counts.results); }}}};
};

// ---- What pool threads compute ------------------------------------------------------------------

Analysis SimulatedMaster::State::analyse(const Scenario& scenario) {
    const ScenarioCost& cost = workload.scenario(scenario.index);
    spent += cost.analysis_seconds;
    ++analysed;
    Analysis analysis;
    analysis.scenario = scenario;
    analysis.bytes = cost.batch_bytes;
    analysis.predicted_ns = cost.predicted_ns;
    for (const BlockId& block : cost.blocks) {
        (block.tree == 0 ? analysis.roots_a : analysis.roots_b).push_back(block.root);
    }
    return analysis;
}

Result<TakenResults> SimulatedMaster::State::check(const Results& message) {
    spent += message.count * workload.results.intake_seconds;
    TakenResults taken;
    for (const std::uint64_t scenario : scenarios_in(message)) {
        ScenarioResult result;
        result.index = scenario;
        taken.add(result, scenario, {}); // The scenarios lie on a grid, which keeps its order.
    }
    taken.positions = PositionSet::of(scenarios_in(message));
    return taken;
}

// ---- Letters ------------------------------------------------------------------------------------

void SimulatedMaster::State::send(WorkerId to, const Message& message) {
    const double begin = cpu_seconds();
    const std::uint64_t bytes = bytes_of(message, workload);
    counts.sent_bytes += bytes;
    if (const auto* subtrees = std::get_if<Subtrees>(&message)) {
        counts.blocks += subtrees->blocks.size();
        for (const SubtreeBlock& block : subtrees->blocks) {
            const BlockId id = block_id(subtrees->tree, block.root);
            counts.block_bytes += workload.block(id).bytes;
            counts.uploads_max = std::max(counts.uploads_max, ++uploads[id]);
        }
    }
    counts.batches += std::holds_alternative<WorkUnit>(message) ? 1 : 0;
    letters.push_back({to, message, bytes});
    letter_seconds += cpu_seconds() - begin + clock_cost;
}

// ---- Events -------------------------------------------------------------------------------------

template <class Event>
SimulatedMaster::Letters SimulatedMaster::run(const Event& event) {
    State& state = *state_;
    const double begin = cpu_seconds();
    state.letter_seconds = 0;
    event();
    do {
        state.context.restart();
    } while (state.context.poll() != 0 || state.loop.run_ready());
    const double passed = cpu_seconds() - begin;
    state.counts.seconds += std::max(0.0, passed - state.letter_seconds - state.clock_cost);
    return std::exchange(state.letters, {});
}

SimulatedMaster::SimulatedMaster(const Workload& workload, const MasterOptions& options)
    : state_(std::make_unique<State>(workload, options)) {
    start_logging("simulation", "error");
    CD_CHECK(state_->coordinator.restore({}).has_value());
}

SimulatedMaster::~SimulatedMaster() = default;

SimulatedMaster::Letters SimulatedMaster::start(std::span<const std::uint32_t> worker_threads) {
    State& state = *state_;
    return run([&] {
        const std::uint64_t count = state.workload.count();
        state.job = state.coordinator.jobs().allot(count).value();
        const JobRecord record{state.job, submission(state.workload, state.options)};
        state.coordinator.jobs().write(record);
        state.journal.commit();
        state.coordinator.jobs().begin(
            record,
            ResultStore::create(state.journal.results_path(state.job), state.job, count),
            std::make_shared<OrderedPoses>(make_line(count)));
        state.loop.run_ready();
        for (const std::uint32_t threads : worker_threads) {
            state.join(threads);
        }
    });
}

SimulatedMaster::Letters SimulatedMaster::join(std::span<const std::uint32_t> worker_threads) {
    return run([&] {
        for (const std::uint32_t threads : worker_threads) {
            state_->join(threads);
        }
    });
}

void SimulatedMaster::State::join(std::uint32_t threads) {
    Hello hello;
    hello.role = Role::Worker;
    hello.threads = threads;
    hello.cache_bytes = options.cache_bytes;
    hello.peer_port = options.peers ? 1 : 0;
    hello.instance = coordinator.workers().all().size() + 1;
    hello.name = "worker " + std::to_string(hello.instance);
    const Reception reception = coordinator.workers().receive(hello, "");
    coordinator.workers().join(
        reception,
        hello,
        std::make_shared<SketchChannel>(
            [this, to = reception.worker](const Message& message) { send(to, message); }));
}

SimulatedMaster::Letters SimulatedMaster::time_is(double now) {
    return run([&] { state_->loop.time_is(now); });
}

std::optional<double> SimulatedMaster::next_timer() const {
    return state_->loop.next_timer();
}

SimulatedMaster::Letters SimulatedMaster::take(WorkerId from, const Message& message) {
    WorkerDesk& desk = state_->coordinator.worker_desk();
    state_->counts.wants += std::holds_alternative<WantSubtrees>(message) ? 1 : 0;
    return run([&] {
        std::visit(
            [&](const auto& one) {
                if constexpr (std::is_same_v<std::decay_t<decltype(one)>, Results>) {
                    state_->counts.results += one.count;
                    desk.came(from, one, [] {});
                } else if constexpr (requires { desk.came(from, one); }) {
                    desk.came(from, one);
                }
            },
            message);
    });
}

bool SimulatedMaster::has_pool_work() const {
    return !state_->pool.waiting.empty();
}

SimulatedMaster::PoolRun SimulatedMaster::start_pool_work() {
    State& state = *state_;
    const auto work = std::move(state.pool.waiting.front());
    state.pool.waiting.pop_front();
    state.spent = 0;
    state.analysed = 0;
    auto outcome = state.loop.record(work);
    return {state.spent, state.analysed, std::move(outcome)};
}

SimulatedMaster::Letters SimulatedMaster::take(PoolRun run) {
    return this->run([&] {
        for (const auto& function : run.outcome) {
            function();
        }
    });
}

const std::deque<std::size_t>& SimulatedMaster::uncommitted() const {
    return state_->journal.uncommitted();
}

SimulatedMaster::Letters SimulatedMaster::commit() {
    return run([&] { state_->journal.commit(); });
}

bool SimulatedMaster::is_done() const {
    return state_->only_job().state() == JobState::Done;
}

const MasterCounts& SimulatedMaster::counts() const {
    return state_->counts;
}

std::uint64_t SimulatedMaster::answered() const {
    return state_->only_job().merged.summary().merged();
}

std::optional<Growth> SimulatedMaster::growth() const {
    return state_->coordinator.jobs().cluster().growth;
}

std::uint64_t SimulatedMaster::recalled() const {
    return state_->only_job().tally.help.recalled;
}

std::uint64_t SimulatedMaster::copies() const {
    return state_->only_job().tally.help.copies;
}

} // namespace cd::bench
