#include "bench/cluster/model/master_model.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <string>
#include <utility>

namespace cd::bench {

namespace {

constexpr JobId the_job{1};
constexpr double period_of_director =
    std::chrono::duration<double>(timing::peer_check_period).count();

/// Returns the number that the simulated master gives a tree.
TreeId tree_id(std::uint8_t tree) {
    return TreeId{std::uint64_t{1} + tree};
}

DispatchTree dispatch_tree(const Workload& workload, std::uint8_t tree) {
    DispatchTree dispatch;
    dispatch.tree = tree_id(tree);
    for (const BlockCost& block : workload.trees[tree]) {
        dispatch.root_triangles.push_back(block.triangles);
        dispatch.root_bytes.push_back(block.bytes);
    }
    return dispatch;
}

BlockId block_id(const BlockKey& key) {
    return {static_cast<std::uint8_t>(key.tree.value - 1), key.root};
}

std::vector<BlockId> blocks_of(TreeId tree, const std::vector<RootIndex>& roots) {
    std::vector<BlockId> blocks;
    blocks.reserve(roots.size());
    for (const RootIndex root : roots) {
        blocks.push_back(block_id({tree, root}));
    }
    return blocks;
}

std::vector<RootIndex> roots_in(const std::vector<BlockId>& blocks, std::uint8_t tree) {
    std::vector<RootIndex> roots;
    for (const BlockId& block : blocks) {
        if (block.tree == tree) {
            roots.push_back(block.root);
        }
    }
    return roots;
}

BlockDirector::Time time_point(double seconds) {
    return BlockDirector::Time(std::chrono::duration_cast<BlockDirector::Time::duration>(
        std::chrono::duration<double>(seconds)));
}

void append(std::vector<Letter>& letters, std::vector<Letter> more) {
    std::move(more.begin(), more.end(), std::back_inserter(letters));
}

AnalysedScenario analysed_scenario(const Workload& workload, std::uint64_t index) {
    const ScenarioCost& cost = workload.scenario(index);
    AnalysedScenario analysed;
    analysed.position = index;
    analysed.bytes = cost.batch_bytes;
    analysed.predicted_ns = cost.predicted_ns;
    for (const BlockId& block : cost.blocks) {
        (block.tree == 0 ? analysed.roots_a : analysed.roots_b).push_back(block.root);
    }
    return analysed;
}

} // namespace

MasterModel::MasterModel(const Workload& workload,
                         const ClusterOptions& options,
                         std::uint64_t ahead,
                         bool peers,
                         std::uint64_t cache_bytes,
                         bool helps_at_end)
    : workload_(workload),
      options_(options),
      dispatcher_(DispatcherOptions{.helps_at_end = helps_at_end}),
      ahead_(ahead),
      is_answered_(workload.count()),
      peers_(peers),
      cache_bytes_(cache_bytes) {}

std::vector<Letter> MasterModel::time_is(double now) {
    now_ = now;
    dispatcher_.time_is(now);
    if (now - director_told_ < period_of_director) {
        return {};
    }
    director_told_ = now;
    return direct([&] { return director_.time_is(time_point(now)); });
}

std::vector<Letter> MasterModel::start(std::span<const std::uint32_t> worker_threads) {
    auto letters = dispatch([&] {
        return dispatcher_.job_opened(
            the_job, options_, dispatch_tree(workload_, 0), dispatch_tree(workload_, 1));
    });
    for (const std::uint32_t threads : worker_threads) {
        const WorkerId worker{workers_.size() + 1};
        workers_.push_back(worker);
        WorkerFacts facts;
        facts.name = "worker " + std::to_string(worker.value);
        facts.threads = threads;
        facts.cache_bytes = cache_bytes_;
        director_.worker_joined(worker, peers_);
        append(letters, dispatch([&] { return dispatcher_.worker_joined(worker, facts); }));
    }
    return letters;
}

std::optional<std::uint64_t> MasterModel::next_to_analyse() {
    const auto [first, count] = next_block_to_analyse(1);
    return count == 0 ? std::nullopt : std::optional(first);
}

std::pair<std::uint64_t, std::uint64_t>
MasterModel::next_block_to_analyse(std::uint64_t count_max) {
    const std::uint64_t first = given_out_;
    if (first == workload_.count() || has_enough()) {
        return {first, 0};
    }
    given_out_ = std::min(first + count_max, workload_.count());
    return {first, given_out_ - first};
}

std::vector<Letter> MasterModel::take(const Analysed& message) {
    ++analysed_;
    auto letters = dispatch([&] {
        return dispatcher_.scenario_analysed(the_job,
                                             analysed_scenario(workload_, message.scenario));
    });
    pause_at_end(letters);
    return letters;
}

std::vector<Letter> MasterModel::take(const BlocksWanted& message) {
    ++counts_.wants;
    for (const BlockId& block : message.blocks) {
        transfers_[message.worker].wanted(
            tree_id(block.tree), block.root, workload_.block(block).bytes, now_);
    }
    std::vector<Letter> letters;
    for (const std::uint8_t tree : {std::uint8_t{0}, std::uint8_t{1}}) {
        append(letters, direct([&] {
                   return director_.wanted(message.worker,
                                           tree_id(tree),
                                           roots_in(message.blocks, tree),
                                           time_point(now_));
               }));
    }
    return letters;
}

std::vector<Letter> MasterModel::deliver(const BlockActions& actions) {
    std::vector<Letter> letters;
    BlocksSent part;
    WorkerId to;
    std::uint64_t bytes = 0;
    const auto send_part = [&] {
        if (!part.blocks.empty()) {
            post(to, std::exchange(part, {}), letters);
            bytes = 0;
        }
    };
    for (const BlockAction& action : actions) {
        if (const auto* directed = std::get_if<SendToPeers>(&action)) {
            post(directed->to,
                 FetchDirected{directed->sources.front(),
                               blocks_of(directed->tree, directed->roots)},
                 letters);
            continue;
        }
        const auto& send = std::get<SendBlock>(action);
        const BlockId block = block_id(send.block);
        if (bytes >= limits::subtrees_bytes_min || send.to != to ||
            (!part.blocks.empty() && part.blocks.front().tree != block.tree)) {
            send_part();
        }
        to = send.to;
        part.blocks.push_back(block);
        bytes += workload_.block(block).bytes;
        ++counts_.blocks;
        counts_.block_bytes += workload_.block(block).bytes;
    }
    send_part();
    return letters;
}

std::vector<Letter> MasterModel::take(const BlocksHeld& message) {
    std::vector<Letter> letters;
    for (const std::uint8_t tree : {std::uint8_t{0}, std::uint8_t{1}}) {
        const std::vector<RootIndex> roots = roots_in(message.blocks, tree);
        const auto measured = transfers_[message.worker].held(tree_id(tree), roots, now_);
        report([&] {
            if (measured) {
                dispatcher_.transfer_measured(message.worker, measured->bytes, measured->seconds);
            }
            dispatcher_.roots_arrived(message.worker, tree_id(tree), roots);
        });
        append(letters, direct([&] {
                   return director_.held(message.worker, tree_id(tree), roots, time_point(now_));
               }));
    }
    return letters;
}

std::vector<Letter> MasterModel::take(const BlocksEvicted& message) {
    std::vector<Letter> letters;
    for (const std::uint8_t tree : {std::uint8_t{0}, std::uint8_t{1}}) {
        const std::vector<RootIndex> roots = roots_in(message.blocks, tree);
        append(letters, direct([&] {
                   return director_.evicted(message.worker, tree_id(tree), roots, time_point(now_));
               }));
        append(letters, dispatch([&] {
                   return dispatcher_.roots_evicted(message.worker, tree_id(tree), roots);
               }));
    }
    return letters;
}

std::vector<Letter> MasterModel::take(const PeerFailed& message) {
    const std::uint8_t tree = message.blocks.front().tree;
    return direct([&] {
        return director_.peer_failed(message.worker,
                                     message.source,
                                     tree_id(tree),
                                     roots_in(message.blocks, tree),
                                     PeerOutcome::Missing,
                                     time_point(now_));
    });
}

std::vector<Letter> MasterModel::take(const ResultsSent& message) {
    for (const std::uint64_t scenario : message.scenarios) {
        CD_CHECK(scenario < is_answered_.size());
        ++(is_answered_[scenario] ? counts_.answered_again : counts_.answered);
        is_answered_[scenario] = true;
    }
    auto letters = dispatch([&] {
        return dispatcher_.answered({message.worker,
                                     message.task,
                                     the_job,
                                     PositionSet::of(message.scenarios),
                                     message.compute_seconds});
    });
    if (message.ends_task) {
        append(letters,
               dispatch([&] { return dispatcher_.task_ended(message.worker, message.task); }));
    }
    pause_at_end(letters);
    return letters;
}

std::vector<Letter> MasterModel::take(const GaveBack& message) {
    auto letters = dispatch([&] {
        return dispatcher_.task_recalled(
            message.worker, message.task, PositionSet::of(message.scenarios));
    });
    pause_at_end(letters);
    return letters;
}

template <class Event>
std::vector<Letter> MasterModel::dispatch(const Event& event) {
    const double start = cpu_seconds();
    const Actions actions = event();
    counts_.dispatcher_seconds += cpu_seconds() - start;
    ++counts_.dispatcher_calls;
    std::vector<Letter> letters;
    for (const Action& action : actions) {
        perform(action, letters);
    }
    return letters;
}

template <class Event>
std::vector<Letter> MasterModel::direct(const Event& event) {
    const double start = cpu_seconds();
    const BlockActions actions = event();
    counts_.dispatcher_seconds += cpu_seconds() - start;
    return deliver(actions);
}

template <class Event>
void MasterModel::report(const Event& event) {
    const double start = cpu_seconds();
    event();
    counts_.dispatcher_seconds += cpu_seconds() - start;
}

void MasterModel::perform(const Action& action, std::vector<Letter>& letters) {
    if (const auto* ask = std::get_if<AskBack>(&action)) {
        return post(ask->worker, AskedBack{ask->task, ask->positions.list()}, letters);
    }
    if (const auto* loser = std::get_if<CallOff>(&action)) {
        for (const std::uint64_t scenario : loser->positions.list()) {
            post(loser->worker, CalledOff{loser->task, scenario}, letters);
        }
        return;
    }
    if (const auto* hint = std::get_if<SendHint>(&action)) {
        return post(hint->worker, Hinted{blocks_of(hint->tree, hint->roots)}, letters);
    }
    if (const auto* returned = std::get_if<UnitsReturned>(&action)) {
        counts_.recalled += returned->positions;
        return;
    }
    const auto* unit = std::get_if<SendUnit>(&action);
    // No worker is lost here, so no scenario is given up.
    CD_CHECK(unit != nullptr);
    ++counts_.batches;
    counts_.copies += unit->copy_of == TaskId{} ? 0 : unit->positions.count();
    const bool is_first = knows_trees_.insert(unit->worker).second;
    post(unit->worker, BatchSent{unit->task, unit->positions.list(), is_first}, letters);
}

void MasterModel::post(WorkerId to, ToWorker content, std::vector<Letter>& letters) {
    const std::uint64_t bytes = bytes_of(content, workload_);
    counts_.sent_bytes += bytes;
    letters.push_back({to, std::move(content), bytes});
}

bool MasterModel::has_enough() const {
    const std::uint64_t under_way = given_out_ - analysed_;
    return ahead_ == 0 ? dispatcher_.unsent() + under_way >= dispatcher_.unsent_enough()
                       : waiting() + under_way >= ahead_;
}

std::uint64_t MasterModel::waiting() const {
    std::uint64_t waiting = dispatcher_.unsent();
    for (const WorkerId worker : workers_) {
        waiting -= dispatcher_.worker_status(worker).buffered;
    }
    return waiting;
}

void MasterModel::pause_at_end(std::vector<Letter>& letters) {
    if (analysed_ == workload_.count() && !is_done()) {
        append(letters, dispatch([&] { return dispatcher_.input_paused(); }));
    }
}

} // namespace cd::bench
