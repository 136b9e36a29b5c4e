#include "bench/cluster/master_model.hpp"

#include "bench/cluster/cpu_clock.hpp"
#include "common/core/check.hpp"
#include "common/core/limits.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace cd::bench {

namespace {

constexpr JobId the_job{1};

/// As the master numbers them here.
TreeId tree_id(std::uint8_t tree) {
    return TreeId{std::uint64_t{1} + tree};
}

DispatchTree dispatch_tree(const Workload& workload, std::uint8_t tree) {
    DispatchTree dispatch;
    dispatch.tree = tree_id(tree);
    for (const BlockCost& block : workload.trees[tree]) {
        dispatch.root_triangles.push_back(block.triangles);
    }
    return dispatch;
}

AnalysedScenario analysed_scenario(const Workload& workload, std::uint64_t index) {
    const ScenarioCost& cost = workload.scenario(index);
    AnalysedScenario analysed;
    analysed.index = index;
    analysed.bytes = cost.batch_bytes;
    for (const BlockId& block : cost.blocks) {
        (block.tree == 0 ? analysed.roots_a : analysed.roots_b).push_back(block.root);
    }
    return analysed;
}

} // namespace

MasterModel::MasterModel(const Workload& workload,
                         const ClusterOptions& options,
                         std::uint64_t ahead)
    : workload_(workload),
      options_(options),
      ahead_(std::max<std::uint64_t>(ahead, 1)),
      is_answered_(workload.count()) {}

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
        auto more = dispatch([&] { return dispatcher_.worker_joined(worker, facts); });
        std::move(more.begin(), more.end(), std::back_inserter(letters));
    }
    return letters;
}

std::optional<std::uint64_t> MasterModel::next_to_analyse() {
    const std::uint64_t under_way = given_out_ - analysed_;
    if (given_out_ == workload_.count() || waiting() + under_way >= ahead_) {
        return std::nullopt;
    }
    return given_out_++;
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

// As the real master gathers blocks into messages: of one tree, until they are large enough.
std::vector<Letter> MasterModel::take(const BlocksWanted& message) {
    ++counts_.wants;
    std::vector<Letter> letters;
    BlocksSent part;
    std::uint64_t bytes = 0;
    const auto send_part = [&] {
        if (!part.blocks.empty()) {
            post(message.worker, std::exchange(part, {}), letters);
            bytes = 0;
        }
    };
    for (const BlockId& block : message.blocks) {
        if (bytes >= limits::subtrees_bytes_min ||
            (!part.blocks.empty() && part.blocks.front().tree != block.tree)) {
            send_part();
        }
        part.blocks.push_back(block);
        bytes += workload_.block(block).bytes;
        ++counts_.blocks;
        counts_.block_bytes += workload_.block(block).bytes;
    }
    send_part();
    return letters;
}

std::vector<Letter> MasterModel::take(const ResultsSent& message) {
    std::vector<Letter> letters;
    const auto add = [&](std::vector<Letter> more) {
        std::move(more.begin(), more.end(), std::back_inserter(letters));
    };
    for (const std::uint64_t scenario : message.scenarios) {
        CD_CHECK(scenario < is_answered_.size());
        ++(is_answered_[scenario] ? counts_.answered_again : counts_.answered);
        is_answered_[scenario] = true;
        add(dispatch(
            [&] { return dispatcher_.scenario_answered(message.worker, the_job, scenario); }));
    }
    if (message.ends_task) {
        add(dispatch([&] { return dispatcher_.task_ended(message.worker, message.task); }));
    }
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

void MasterModel::perform(const Action& action, std::vector<Letter>& letters) {
    const auto* batch = std::get_if<SendBatch>(&action);
    // No worker is lost here, so none is given up.
    CD_CHECK(batch != nullptr);
    ++counts_.batches;
    const bool is_first = knows_trees_.insert(batch->worker).second;
    post(batch->worker, BatchSent{batch->task, batch->scenarios, is_first}, letters);
}

void MasterModel::post(WorkerId to, ToWorker content, std::vector<Letter>& letters) {
    const std::uint64_t bytes = bytes_of(content, workload_);
    counts_.sent_bytes += bytes;
    letters.push_back({to, std::move(content), bytes});
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
        auto more = dispatch([&] { return dispatcher_.input_paused(); });
        std::move(more.begin(), more.end(), std::back_inserter(letters));
    }
}

} // namespace cd::bench
