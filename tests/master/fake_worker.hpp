// A minimal worker that can misbehave.
#pragma once

#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/partial_tree.hpp"
#include "common/tree/wire/top_block.hpp"
#include "tests/master/master_stage.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace cd::tests {

/// Requests all blocks a batch lacks, then computes the batch.
class FakeWorker {
  public:
    struct Habits {
        std::uint64_t dies_at_batch = 0; ///< Counted from 1; 0: never.
        std::uint64_t dies_at_range = 0; ///< Counted from 1; 0: never.
        bool answers_twice = false;
        bool lies_first = false;      ///< Answers twice: wrongly, then rightly.
        bool lies_second = false;     ///< Answers twice: rightly, then wrongly.
        bool lies_say_failed = false; ///< Wrong results report a failure; else no contact.
        std::uint64_t lies_alone = 0; ///< Number of first batches with only wrong answers.
        std::optional<std::uint64_t> dies_of = {}; ///< Scenario that kills the worker.
        bool sends_rubbish = false;
        bool holds_too_much = false; ///< Reports roots that the tree does not have.
        bool says_what_it_holds = false;
        bool only_takes = false;                       ///< Does nothing with its work.
        std::uint64_t instance = 0;                    ///< Instance id; 0: unknown.
        std::uint64_t batches_max = ~std::uint64_t{0}; ///< Rests after so many batches.
        std::vector<Results> comes_with = {};          ///< Sent first, as an earlier session's.
        std::optional<std::uint64_t> holds = {};       ///< Scenario held until `go_on`.
        std::string holder = "worker";                 ///< Holder of its certificate, if any.
        std::uint16_t peer_port = 0; ///< Port where it falsely claims to serve peers.
    };

    FakeWorker(Master& master, Habits habits) : master_(master), habits_(habits) {
        spawn(master.context.get_executor(), "fake worker", run());
    }
    ~FakeWorker() { hang_up(master_, channel_, ended); }

    std::uint64_t batches = 0;
    std::uint64_t ranges = 0;
    std::uint64_t blocks = 0;
    std::uint64_t sent_to_peers = 0; ///< Number of directions to peers.
    std::uint64_t trees_removed = 0;
    std::uint64_t kept = 0;           ///< Result messages the master acknowledged as durable.
    std::uint64_t kept_of_before = 0; ///< Those of them from an earlier session.
    bool is_held = false;
    std::optional<std::uint64_t> dropped; ///< Last scenario cancelled by the master.
    bool ended = false;

    void go_on() {
        habits_.holds.reset();
        work();
    }

    /// A status shows this once the master has read all results of the earlier session.
    static constexpr std::uint64_t cached_bytes = 1;

  private:
    [[nodiscard]] static Heartbeat busy() {
        Heartbeat heartbeat;
        heartbeat.cached_bytes = cached_bytes;
        return heartbeat;
    }

    struct Tree {
        std::optional<TreeTop> top;
        bool is_top_wanted = false;
        std::map<RootIndex, Subtree> subtrees;
    };

    asio::awaitable<void> run() {
        const Ending ending{ended};
        Target target = master_.target(CertifiedRole::Worker, habits_.holder);
        auto connected = co_await connect(std::move(target));
        channel_ = connected.value();
        Hello hello = hello_of_worker("fake", habits_.instance);
        hello.peer_port = habits_.peer_port;
        (void)co_await greet(channel_, hello);
        for (Results& results : habits_.comes_with) {
            results.sequence = results.sequence == 0 ? ++numbered_ : results.sequence;
            channel_->send(results);
        }
        channel_->send(Inventory{}); // All results of the earlier session are sent.
        channel_->send(busy());
        for (;;) {
            Result<Message> message = co_await channel_->receive(patience);
            if (!message) {
                break;
            }
            if (const auto* add = std::get_if<AddTree>(&message.value())) {
                trees_[add->tree];
            } else if (auto* add_job = std::get_if<AddJob>(&message.value())) {
                jobs_[add_job->job] = *add_job;
            } else if (const auto* remove = std::get_if<RemoveTree>(&message.value())) {
                trees_removed += trees_.erase(remove->tree);
            } else if (const auto* subtrees = std::get_if<Subtrees>(&message.value())) {
                keep(*subtrees);
            } else if (const auto* directions = std::get_if<FetchFromPeers>(&message.value())) {
                ++sent_to_peers;
                channel_->send(WantSubtrees{directions->tree, directions->roots});
            } else if (std::holds_alternative<Heartbeat>(message.value())) {
                channel_->send(busy());
            } else if (const auto* drop = std::get_if<DropScenario>(&message.value())) {
                dropped = drop->scenario;
            } else if (const auto* acknowledged = std::get_if<ResultsKept>(&message.value())) {
                kept += acknowledged->sequences.size();
                for (const std::uint64_t sequence : acknowledged->sequences) {
                    kept_of_before += sequence == 0 ? 0 : 1;
                }
            } else if (auto* unit = std::get_if<WorkUnit>(&message.value());
                       unit != nullptr && !unit->is_analysed()) {
                ++ranges;
                unwalked_.push_back(std::move(*unit));
            } else if (auto* batch = std::get_if<WorkUnit>(&message.value())) {
                if (++batches == habits_.dies_at_batch || is_deadly(*batch)) {
                    channel_->close();
                    break;
                }
                if (!habits_.only_takes) {
                    waiting_.push_back(std::move(*batch));
                    ask();
                }
            }
            if (ranges != 0 && ranges == habits_.dies_at_range) {
                channel_->close();
                break;
            }
            if (!walk()) {
                channel_->close();
                break;
            }
            work();
        }
    }

    /// Descends queued ranges whose upper trees are present. Returns false if a range is deadly.
    bool walk() {
        for (; !unwalked_.empty() && has_tops(unwalked_.front()); unwalked_.pop_front()) {
            waiting_.push_back(analysed(unwalked_.front()));
            if (is_deadly(waiting_.back())) {
                return false;
            }
            ask();
        }
        return true;
    }

    bool has_tops(const WorkUnit& range) {
        const AddJob& job = jobs_.at(range.job);
        bool has_all = true;
        for (const TreeId id : job.trees) {
            Tree& tree = trees_.at(id);
            has_all = has_all && tree.top;
            if (!tree.top && !std::exchange(tree.is_top_wanted, true)) {
                channel_->send(WantSubtrees{id, {top_root}});
            }
        }
        return has_all;
    }

    [[nodiscard]] static bool has(const WorkUnit& batch, std::optional<std::uint64_t> index) {
        const auto scenarios = unpack_scenarios(batch.scenarios, limits::scenarios_max).value();
        return index &&
               std::any_of(scenarios.begin(), scenarios.end(), [&](const Scenario& scenario) {
                   return scenario.index == *index;
               });
    }
    [[nodiscard]] bool is_deadly(const WorkUnit& batch) const {
        return has(batch, habits_.dies_of);
    }

    void keep(const Subtrees& subtrees) {
        for (const SubtreeBlock& block : subtrees.blocks) {
            const Bytes bytes =
                decompress(block.compressed, limits::subtree_block_bytes_max).value();
            EXPECT_EQ(sha256(bytes), block.hash);
            if (block.root == top_root) {
                trees_.at(subtrees.tree).top = decode_top(bytes).value();
                continue;
            }
            trees_.at(subtrees.tree)
                .subtrees.emplace(block.root, std::move(decode_subtree(bytes).value()));
            if (habits_.says_what_it_holds) {
                channel_->send(Held{subtrees.tree, {block.root}});
            }
            ++blocks;
        }
    }

    /// Returns a range as the batch that an analysis would make of it.
    [[nodiscard]] WorkUnit analysed(const WorkUnit& range) {
        const AddJob& job = jobs_.at(range.job);
        std::vector<Scenario> scenarios;
        if (job.grid) {
            const Grid grid = decode_grid(*job.grid).value();
            for (std::uint64_t place = 0; place < range.count; ++place) {
                scenarios.push_back(scenario_on(grid, range.first + place));
            }
        } else {
            scenarios = unpack_scenarios(range.scenarios, range.count).value();
            EXPECT_EQ(scenarios.size(), range.count);
        }
        WorkUnit batch{range.task, range.job, 0, range.count, pack_scenarios(scenarios), {0}, {}};
        for (const Scenario& scenario : scenarios) {
            const auto roots = query_roots(
                *trees_.at(job.trees[0]).top, *trees_.at(job.trees[1]).top, scenario, job.query);
            const std::vector<RootPair>& pairs = roots.value().pairs;
            batch.pairs.insert(batch.pairs.end(), pairs.begin(), pairs.end());
            batch.pair_offsets.push_back(static_cast<std::uint32_t>(batch.pairs.size()));
        }
        return batch;
    }

    [[nodiscard]] std::vector<RootIndex> missing(TreeId tree, const std::vector<RootIndex>& roots) {
        std::vector<RootIndex> lacking;
        for (const RootIndex root : roots) {
            if (!trees_.at(tree).subtrees.contains(root)) {
                lacking.push_back(root);
            }
        }
        return lacking;
    }

    void ask() {
        const WorkUnit& batch = waiting_.back();
        const AddJob& job = jobs_.at(batch.job);
        const auto a = missing(job.trees[0], roots_of_a(batch.pairs));
        const auto b = missing(job.trees[1], roots_of_b(batch.pairs));
        if (habits_.holds_too_much) {
            channel_->send(Held{job.trees[0], {1u << 30}});
        }
        // Requests twice, as a worker may: the master sends each once or twice, and never fails.
        channel_->send(WantSubtrees{job.trees[0], a});
        channel_->send(WantSubtrees{job.trees[0], a});
        channel_->send(WantSubtrees{job.trees[1], b});
    }

    void work() {
        while (!waiting_.empty() && batches_answered_ < habits_.batches_max) {
            const WorkUnit& batch = waiting_.front();
            const AddJob& job = jobs_.at(batch.job);
            is_held = has(batch, habits_.holds);
            if (is_held || !missing(job.trees[0], roots_of_a(batch.pairs)).empty() ||
                !missing(job.trees[1], roots_of_b(batch.pairs)).empty()) {
                return;
            }
            compute(batch, job);
            waiting_.erase(waiting_.begin());
        }
    }

    [[nodiscard]] Results false_results(Results results) const {
        const Bytes records = unpack_records(results.records, 1u << 30).value();
        ByteReader in(records);
        ByteWriter out;
        for (std::uint32_t i = 0; i < results.count; ++i) {
            ScenarioResult result = decode_result(in.get_bytes(in.get<std::uint32_t>())).value();
            result.kind = ScenarioClass::Separate;
            result.pair_count = 0;
            result.pairs.clear();
            if (habits_.lies_say_failed) {
                result.kind = ScenarioClass::Failed;
                result.failure = "too hard for me";
            }
            put_record(out, encode_result(result));
        }
        results.records = pack_records(out.bytes());
        return results;
    }

    static std::shared_ptr<const BodyPartRuns> parts_of(const AddJob& job) {
        if (job.parts.empty()) {
            return nullptr;
        }
        return std::make_shared<const BodyPartRuns>(BodyPartRuns{
            PartRuns::create(job.parts[0]).value(), PartRuns::create(job.parts[1]).value()});
    }

    void compute(const WorkUnit& batch, const AddJob& job) {
        const auto scenarios = unpack_scenarios(batch.scenarios, limits::scenarios_max).value();
        Results results;
        results.task = batch.task;
        results.job = batch.job;
        ByteWriter records;
        ContactMapSum sum(parts_of(job));
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            std::vector<SubtreePair> pairs;
            for (std::uint32_t p = batch.pair_offsets[i]; p < batch.pair_offsets[i + 1]; ++p) {
                pairs.push_back({trees_.at(job.trees[0]).subtrees.at(batch.pairs[p].a).view(),
                                 trees_.at(job.trees[1]).subtrees.at(batch.pairs[p].b).view()});
            }
            const ScenarioRun run = run_on_subtrees(pairs, scenarios[i], job.query);
            put_record(records, encode_result(run.result));
            sum.add(run.result, run.found);
            results.statistics += run.statistics;
            ++results.count;
        }
        results.records = pack_records(records.bytes());
        if (!job.parts.empty()) {
            results.map = pack_map(sum.take());
        }
        if (habits_.sends_rubbish) {
            results.records.resize(results.records.size() / 2);
        }
        if (batches_answered_++ < habits_.lies_alone) {
            channel_->send(false_results(results));
            channel_->send(EndOfTask{batch.task});
            return;
        }
        if (habits_.lies_first) {
            channel_->send(false_results(results));
        }
        channel_->send(results);
        if (habits_.lies_second) {
            channel_->send(false_results(results));
        }
        if (habits_.answers_twice) {
            channel_->send(results);
        }
        channel_->send(EndOfTask{batch.task});
    }

    Master& master_;
    Habits habits_;
    std::uint64_t numbered_ = 0; ///< Last sequence number given to `comes_with`.
    std::shared_ptr<Channel> channel_;
    std::map<TreeId, Tree> trees_;
    std::map<JobId, AddJob> jobs_;
    std::vector<WorkUnit> waiting_;
    std::deque<WorkUnit> unwalked_; ///< Ranges waiting for upper trees.
    std::uint64_t batches_answered_ = 0;
};

} // namespace cd::tests
