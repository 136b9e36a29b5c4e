// Proves that a master in this process does whole jobs over loopback: the digest is that of the
// same scenarios without a cluster, whatever workers do, and what clients send wrong is refused.
#include "master/server.hpp"

#include "common/core/compress.hpp"
#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build.hpp"
#include "common/tree/partial_tree.hpp"
#include "master/coordinator.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <map>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 60s;

/// A whole master on one context, which the test runs.
class Master {
  public:
    /// Unless told, a worker whose connection breaks does not come back.
    explicit Master(const FailureTimes& failure_times = {.return_within = 0ms})
        : times(failure_times) {
        EXPECT_TRUE(coordinator.restore(journal->take_recovered()));
        server->start();
    }
    ~Master() {
        server->close();
        context.run_for(patience);
    }

    /// Runs everything until the condition holds.
    template <class Condition>
    void run_until(Condition condition) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!condition() && std::chrono::steady_clock::now() < deadline) {
            context.run_one_for(1s);
        }
        ASSERT_TRUE(condition()) << "this took too long";
    }
    [[nodiscard]] Endpoint endpoint() const { return {"127.0.0.1", server->port()}; }

    TemporaryFolder folder;
    asio::io_context context{1};
    ThreadPool compute{2};
    std::unique_ptr<GeometryStore> store =
        std::move(GeometryStore::open(folder.path(), compute).value());
    std::unique_ptr<Journal> journal =
        std::move(Journal::open({.directory = folder.path(), .synced = false}).value());
    ThreadPool blocking{2};
    FailureTimes times;
    Coordinator coordinator{{context.get_executor(),
                             *store,
                             compute,
                             blocking,
                             *journal,
                             folder.path() / "jobs",
                             Durability::Unsynced,
                             times}};
    std::unique_ptr<Server> server =
        std::move(Server::listen(context.get_executor(), {"127.0.0.1", 0}, coordinator).value());
};

/// The end of a peer's conversation with the master, which a test must not outlive.
struct Ending {
    bool& ended;
    ~Ending() { ended = true; }
};

void hang_up(Master& master, const std::shared_ptr<Channel>& channel, const bool& ended) {
    while (!ended) {
        if (channel != nullptr) {
            channel->close();
        }
        master.context.run_one_for(1s);
    }
}

/// A worker in its simplest form: it asks for all that a batch lacks, then computes the batch.
class FakeWorker {
  public:
    struct Habits {
        std::uint64_t dies_at_batch = 0; ///< Counted from 1; 0 lives on.
        std::uint64_t dies_at_range = 0; ///< The same.
        bool answers_twice = false;
        bool lies_first = false;      ///< It answers wrongly, then rightly;
        bool lies_second = false;     ///< or the other way round.
        std::uint64_t lies_alone = 0; ///< So many first batches it answers wrongly, and that is it.
        std::optional<std::uint64_t> dies_of = {}; ///< A scenario.
        bool sends_rubbish = false;
        bool forgets_one = false;    ///< Once, it ends a task without an answer.
        bool holds_too_much = false; ///< Roots that the tree does not have.
        bool says_what_it_holds = false;
    };

    FakeWorker(Master& master, Habits habits) : master_(master), habits_(habits) {
        spawn(master.context.get_executor(), "fake worker", run());
    }
    ~FakeWorker() { hang_up(master_, channel_, ended); }

    std::uint64_t batches = 0;
    std::uint64_t ranges = 0;
    std::uint64_t blocks = 0;
    std::uint64_t trees_removed = 0;
    bool ended = false;

  private:
    struct Tree {
        TreeTop top;
        std::map<RootIndex, Subtree> subtrees;
    };

    asio::awaitable<void> run() {
        const Ending ending{ended};
        auto connected = co_await connect(master_.endpoint());
        channel_ = connected.value();
        Hello hello;
        hello.role = Role::Worker;
        hello.name = "fake";
        hello.threads = 1;
        hello.cache_bytes = 1 << 20;
        (void)co_await greet(channel_, hello);
        for (;;) {
            Result<Message> message = co_await channel_->receive(patience);
            if (!message) {
                break;
            }
            if (auto* add = std::get_if<AddTree>(&message.value())) {
                trees_[add->tree].top = make_tree_top(add->top).value();
            } else if (auto* add_job = std::get_if<AddJob>(&message.value())) {
                jobs_[add_job->job] = *add_job;
            } else if (const auto* remove = std::get_if<RemoveTree>(&message.value())) {
                trees_removed += trees_.erase(remove->tree);
            } else if (const auto* subtrees = std::get_if<Subtrees>(&message.value())) {
                keep(*subtrees);
            } else if (auto* range = std::get_if<ScenarioRange>(&message.value())) {
                ++ranges;
                waiting_.push_back(analysed(*range));
                if (is_deadly(waiting_.back())) {
                    channel_->close();
                    break;
                }
                ask();
            } else if (auto* batch = std::get_if<Batch>(&message.value())) {
                if (++batches == habits_.dies_at_batch || is_deadly(*batch)) {
                    channel_->close();
                    break;
                }
                waiting_.push_back(std::move(*batch));
                ask();
            }
            if (ranges != 0 && ranges == habits_.dies_at_range) {
                channel_->close();
                break;
            }
            work();
        }
    }

    [[nodiscard]] bool is_deadly(const Batch& batch) const {
        const auto scenarios = unpack_scenarios(batch.scenarios).value();
        return habits_.dies_of &&
               std::any_of(scenarios.begin(), scenarios.end(), [&](const Scenario& scenario) {
                   return scenario.index == *habits_.dies_of;
               });
    }

    void keep(const Subtrees& subtrees) {
        for (const SubtreeBlock& block : subtrees.blocks) {
            const Bytes bytes =
                decompress(block.compressed, limits::subtree_block_bytes_max).value();
            EXPECT_EQ(sha256(bytes), block.hash);
            trees_.at(subtrees.tree)
                .subtrees.emplace(block.root, std::move(decode_subtree(bytes).value()));
            if (habits_.says_what_it_holds) {
                channel_->send(Held{subtrees.tree, {block.root}});
            }
            ++blocks;
        }
    }

    /// A range as the batch that an analysis would make of it.
    [[nodiscard]] Batch analysed(const ScenarioRange& range) {
        const AddJob& job = jobs_.at(range.job);
        std::vector<Scenario> scenarios;
        if (job.grid) {
            const Grid grid = decode_grid(*job.grid).value();
            for (std::uint64_t place = 0; place < range.count; ++place) {
                scenarios.push_back(scenario_on(grid, range.first + place));
            }
        } else {
            scenarios = unpack_scenarios(range.scenarios).value();
            EXPECT_EQ(scenarios.size(), range.count);
        }
        Batch batch{range.task, range.job, pack_scenarios(scenarios), {0}, {}};
        for (const Scenario& scenario : scenarios) {
            const auto pairs = colliding_roots(
                trees_.at(job.tree_a).top, trees_.at(job.tree_b).top, scenario.poses);
            batch.pairs.insert(batch.pairs.end(), pairs.value().begin(), pairs.value().end());
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
        const Batch& batch = waiting_.back();
        const AddJob& job = jobs_.at(batch.job);
        const auto a = missing(job.tree_a, roots_of_a(batch.pairs));
        const auto b = missing(job.tree_b, roots_of_b(batch.pairs));
        if (habits_.holds_too_much) {
            channel_->send(Held{job.tree_a, {1u << 30}});
        }
        // Twice, as a worker might: the master sends each once, or twice, but never fails.
        channel_->send(WantSubtrees{job.tree_a, a});
        channel_->send(WantSubtrees{job.tree_a, a});
        channel_->send(WantSubtrees{job.tree_b, b});
    }

    void work() {
        while (!waiting_.empty()) {
            const Batch& batch = waiting_.front();
            const AddJob& job = jobs_.at(batch.job);
            if (!missing(job.tree_a, roots_of_a(batch.pairs)).empty() ||
                !missing(job.tree_b, roots_of_b(batch.pairs)).empty()) {
                return;
            }
            compute(batch, job);
            waiting_.erase(waiting_.begin());
        }
    }

    /// As if nothing had touched anything.
    static Results false_results(Results results) {
        const Bytes records = unpack_records(results.records, 1u << 30).value();
        ByteReader in(records);
        ByteWriter out;
        for (std::uint32_t i = 0; i < results.count; ++i) {
            ScenarioResult result = decode_result(in.get_bytes(in.get<std::uint32_t>())).value();
            result.kind = ScenarioClass::Separate;
            result.pair_count = 0;
            result.pairs.clear();
            const Bytes record = encode_result(result);
            out.put(static_cast<std::uint32_t>(record.size()));
            out.put_array(std::span(reinterpret_cast<const char*>(record.data()), record.size()));
        }
        results.records = pack_records(out.bytes());
        return results;
    }

    void compute(const Batch& batch, const AddJob& job) {
        const auto scenarios = unpack_scenarios(batch.scenarios).value();
        Results results;
        results.task = batch.task;
        results.job = batch.job;
        ByteWriter records;
        const std::size_t left_out = std::exchange(habits_.forgets_one, false) ? 1 : 0;
        for (std::size_t i = left_out; i < scenarios.size(); ++i) {
            std::vector<SubtreePair> pairs;
            for (std::uint32_t p = batch.pair_offsets[i]; p < batch.pair_offsets[i + 1]; ++p) {
                pairs.push_back({trees_.at(job.tree_a).subtrees.at(batch.pairs[p].a).view(),
                                 trees_.at(job.tree_b).subtrees.at(batch.pairs[p].b).view()});
            }
            const ScenarioRun run = run_on_subtrees(pairs, scenarios[i], job.query);
            const Bytes record = encode_result(run.result);
            records.put(static_cast<std::uint32_t>(record.size()));
            records.put_array(
                std::span(reinterpret_cast<const char*>(record.data()), record.size()));
            results.statistics += run.statistics;
            ++results.count;
        }
        results.records = pack_records(records.bytes());
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
    std::shared_ptr<Channel> channel_;
    std::map<TreeId, Tree> trees_;
    std::map<JobId, AddJob> jobs_;
    std::vector<Batch> waiting_;
    std::uint64_t batches_answered_ = 0;
};

/// The meshes and scenarios of the tests, and what is right.
struct Reference {
    Reference() {
        std::mt19937_64 random(1);
        for (std::uint64_t i = 0; i < 90; ++i) {
            Scenario scenario;
            scenario.index = i;
            scenario.poses.b = make_pose(random, 1.6);
            scenarios.push_back(scenario);
        }
        ThreadPool pool(2);
        const ObbTree tree_a = build_tree(share(a), {}, pool);
        const ObbTree tree_b = build_tree(share(b), {}, pool);
        ResultMerger merger(scenarios.size());
        for (const Scenario& scenario : scenarios) {
            (void)merger.add(run_scenario(tree_a, tree_b, scenario, {}).result);
        }
        summary = merger.summary();
        digest = merger.digest().value();
    }

    [[nodiscard]] Submit submission() const {
        Submit submit;
        submit.name = "test";
        submit.bodies = {a.hash(), b.hash()};
        submit.cluster.strategy = Strategy::BestMatch; // With small batches.
        submit.cluster.depth_a = 4;
        submit.cluster.depth_b = 3;
        submit.cluster.q = 5;
        submit.scenarios = scenarios.size();
        return submit;
    }

    Mesh a = make_sphere(3);
    Mesh b = make_torus(0.7, 0.2, 24, 12);
    std::vector<Scenario> scenarios;
    Summary summary;
    Sha256 digest;
};

const Reference& reference() {
    static const Reference instance;
    return instance;
}

/// A client that runs one conversation.
class Client {
  public:
    explicit Client(Master& master) : master_(master) {}
    ~Client() { hang_up(master_, channel_, ended_); }

    /// Uploads what is missing, submits with poses, watches to the end, and fetches all results.
    void start(Submit submit) {
        spawn(master_.context.get_executor(), "client", run(std::move(submit)));
    }
    /// Sends the messages and keeps one answer.
    void start_asking(std::vector<Message> messages) {
        spawn(master_.context.get_executor(), "client", ask(std::move(messages)));
    }

    std::vector<JobStatus> statuses;
    std::uint64_t records = 0;
    std::optional<Result<Message>> answer;
    std::optional<JobId> job;
    std::uint64_t meshes_sent = 0;
    bool done = false;

  private:
    asio::awaitable<void> greet_master() {
        channel_ = (co_await connect(master_.endpoint())).value();
        const Hello hello; // Named: GCC 12 copies temporaries in such an expression bit by bit.
        (void)co_await greet(channel_, hello);
    }

    asio::awaitable<void> ask(std::vector<Message> messages) {
        const Ending ending{ended_};
        co_await greet_master();
        for (const Message& message : messages) {
            channel_->send(message);
        }
        answer = co_await channel_->receive(patience);
        done = true;
    }

    asio::awaitable<void> run(Submit submit) {
        const Ending ending{ended_};
        co_await greet_master();
        channel_->send(MeshesQuery{submit.bodies});
        const auto missing =
            std::get<MeshesMissing>((co_await channel_->receive(patience)).value());
        for (const Sha256& hash : missing.meshes) {
            co_await upload(hash);
        }
        channel_->send(submit);
        const std::span<const Scenario> all(reference().scenarios);
        channel_->send(PosesPart{pack_scenarios(all.first(40))});
        channel_->send(PosesPart{pack_scenarios(all.subspan(40))});
        channel_->send(PosesEnd{});
        job = std::get<Accepted>((co_await channel_->receive(patience)).value()).job;
        channel_->send(Watch{*job});
        do {
            statuses.push_back(std::get<JobStatus>((co_await channel_->receive(patience)).value()));
        } while (statuses.back().state == JobState::Running);
        co_await fetch();
        done = true;
    }

    asio::awaitable<void> upload(Sha256 hash) {
        const Mesh& mesh = hash == reference().a.hash() ? reference().a : reference().b;
        const Bytes bytes = mesh.canonical_bytes();
        const std::size_t half = bytes.size() / 2;
        const auto part = [&](std::size_t begin, std::size_t end) {
            return MeshPart{hash,
                            "mesh",
                            bytes.size(),
                            begin,
                            Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                                  bytes.begin() + static_cast<std::ptrdiff_t>(end))};
        };
        channel_->send(part(0, half));
        channel_->send(part(half, bytes.size()));
        const auto stored = std::get<MeshStored>((co_await channel_->receive(patience)).value());
        EXPECT_EQ(stored.mesh, hash);
        ++meshes_sent;
    }

    asio::awaitable<void> fetch() {
        for (;;) {
            channel_->send(ResultsQuery{*job, records, 1000});
            const auto part = std::get<ResultsPart>((co_await channel_->receive(patience)).value());
            EXPECT_EQ(part.first, records);
            if (part.count == 0) {
                co_return;
            }
            records += part.count;
        }
    }

    Master& master_;
    std::shared_ptr<Channel> channel_;
    bool ended_ = false;
};

void expect_right(const Client& client) {
    ASSERT_TRUE(client.done);
    const JobStatus& last = client.statuses.back();
    EXPECT_EQ(last.state, JobState::Done) << last.failure;
    EXPECT_EQ(last.digest, reference().digest);
    EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
    EXPECT_EQ(last.summary.pairs, reference().summary.pairs);
    EXPECT_EQ(last.summary.cross, reference().summary.cross);
    EXPECT_EQ(client.records, reference().scenarios.size());
}

TEST(Server, AJobHasTheDigestOfTheSameScenariosWithoutACluster) {
    // Every kind of answer occurs, or agreement would mean little.
    ASSERT_GT(reference().summary.cross, 10u);
    ASSERT_GT(reference().summary.separate, 10u);
    for (const Strategy strategy : {Strategy::BestMatch,
                                    Strategy::BestMatchLoad,
                                    Strategy::Random,
                                    Strategy::Lowest,
                                    Strategy::BestMatchPull,
                                    Strategy::EarliestFinish}) {
        Master master;
        FakeWorker one(master, {});
        FakeWorker two(master, {});
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.strategy = strategy;
        submit.cluster.claim = strategy != Strategy::BestMatch;
        client.start(submit);
        master.run_until([&] { return client.done; });
        expect_right(client);
        EXPECT_EQ(client.meshes_sent, 2u);
        EXPECT_GT(client.statuses.back().answered_by_master, 0u);
        EXPECT_GT(client.statuses.back().statistics.search.box_tests, 0u);
        // Nothing uses the trees any more.
        master.run_until([&] { return one.trees_removed + two.trees_removed >= 2; });
    }
}

TEST(Server, WhoeverFindsTheCollidingRootsTheDigestIsTheSame) {
    for (const AnalysisMode mode :
         {AnalysisMode::Auto, AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        FakeWorker one(master, {});
        FakeWorker two(master, {.answers_twice = true});
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start(submit);
        master.run_until([&] { return client.done; });
        expect_right(client);
        EXPECT_EQ(one.ranges + two.ranges != 0, mode == AnalysisMode::Never) << to_text(mode);
        EXPECT_EQ(one.batches + two.batches == 0, mode == AnalysisMode::Never) << to_text(mode);
    }
}

TEST(Server, RangesOfAWorkerThatDiesOrForgetsAreAnalysedAndDoneByAnother) {
    for (const FakeWorker::Habits habits :
         {FakeWorker::Habits{.dies_at_range = 2}, FakeWorker::Habits{.forgets_one = true}}) {
        Master master;
        FakeWorker bad(master, habits);
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = AnalysisMode::Never;
        client.start(submit);
        master.run_until([&] { return bad.ranges >= 2; });
        FakeWorker other(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
        EXPECT_GT(bad.batches + other.batches, 0u);
    }
}

TEST(Server, AWorkerThatDiesHasItsScenariosDoneByAnother) {
    Master master;
    FakeWorker mortal(master, {.dies_at_batch = 2});
    FakeWorker other(master, {});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    expect_right(client);
    EXPECT_TRUE(mortal.ended);
}

TEST(Server, AWorkerMayComeAfterTheJob) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.job.has_value(); });
    FakeWorker late(master, {});
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Server, RepeatedAndForgottenAnswersDoNoHarm) {
    Master master;
    FakeWorker twice(master, {.answers_twice = true, .forgets_one = true});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    expect_right(client);
}

TEST(Server, OfResultsThatDifferTheRightOneStaysAndTheWorkerIsQuarantined) {
    for (const FakeWorker::Habits habits :
         {FakeWorker::Habits{.lies_first = true}, FakeWorker::Habits{.lies_second = true}}) {
        Master master;
        FakeWorker liar(master, habits);
        Client client(master);
        client.start(reference().submission());
        master.run_until([&] {
            const ClusterStatus status = master.coordinator.cluster_status();
            return status.workers.size() == 1 && status.workers[0].quarantined;
        });
        EXPECT_FALSE(master.coordinator.cluster_status().alarms.empty());
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
    }
}

TEST(Server, AfterAnAlarmWhatElseTheWorkerHasAnsweredIsDoneAgain) {
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        FakeWorker liar(master, {.lies_first = true, .lies_alone = 3});
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start(submit);
        master.run_until([&] {
            const ClusterStatus status = master.coordinator.cluster_status();
            return status.workers.size() == 1 && status.workers[0].quarantined;
        });
        const ClusterStatus status = master.coordinator.cluster_status();
        EXPECT_GT(status.jobs.at(0).doubted, 0u);
        EXPECT_GT(status.alarm_count, 0u);
        EXPECT_EQ(status.jobs.at(0).state, JobState::Running);
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
        EXPECT_EQ(client.statuses.back().doubted, 0u);
    }
}

/// A scenario that a worker has to answer.
std::uint64_t scenario_with_contact() {
    const Reference& all = reference();
    ThreadPool pool(2);
    const ObbTree a = build_tree(share(all.a), {}, pool);
    const ObbTree b = build_tree(share(all.b), {}, pool);
    for (const Scenario& scenario : all.scenarios) {
        if (run_scenario(a, b, scenario, {}).result.pair_count != 0) {
            return scenario.index;
        }
    }
    return 0;
}

TEST(Server, AScenarioThatTakesItsWorkersDownFailsAndTheJobGoesOn) {
    const std::uint64_t deadly = scenario_with_contact();
    for (const AnalysisMode mode : {AnalysisMode::Always, AnalysisMode::Never}) {
        Master master;
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.analysis = mode;
        client.start(submit);
        std::vector<std::unique_ptr<FakeWorker>> workers;
        master.run_until([&] {
            if (workers.empty() || workers.back()->ended) {
                workers.push_back(
                    std::make_unique<FakeWorker>(master, FakeWorker::Habits{.dies_of = deadly}));
            }
            return client.done;
        });
        const JobStatus& last = client.statuses.back();
        EXPECT_EQ(last.state, JobState::Done) << last.failure;
        EXPECT_EQ(last.summary.failed, 1u);
        EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
        EXPECT_LE(workers.size(), limits::scenario_losses_max + 2u);
    }
}

TEST(Server, AScenarioThatTakesLongIsShownWithItsWorker) {
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.job.has_value(); });
    FakeWorker worker(master, {});
    master.run_until([&] { return master.coordinator.cluster_status().workers.size() == 1; });
    const WorkerId id = master.coordinator.cluster_status().workers[0].worker;
    const auto shown = [&] {
        return master.coordinator.job_status(*client.job).value().long_scenarios;
    };
    master.coordinator.heartbeat_came(id, {1, 0, 1, {}, RunningScenario{*client.job, 3, 9.5}});
    EXPECT_TRUE(shown().empty()) << "not long yet";
    master.coordinator.heartbeat_came(id, {2, 0, 1, {}, RunningScenario{*client.job, 3, 75}});
    ASSERT_EQ(shown().size(), 1u);
    EXPECT_EQ(shown()[0].scenario, 3u);
    EXPECT_EQ(shown()[0].worker, id);
    EXPECT_EQ(shown()[0].name, "fake");
    EXPECT_EQ(master.coordinator.cluster_status().jobs.at(0).long_scenarios.size(), 1u);
    master.coordinator.heartbeat_came(id, {3, 0, 1, {}, {}});
    EXPECT_TRUE(shown().empty());
    master.run_until([&] { return client.done; });
}

TEST(Server, AScenarioMayBeCancelledAndTheJobGoesOn) {
    const std::uint64_t scenario = scenario_with_contact();
    Master master;
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.job && master.coordinator.analysis_input(*client.job); });
    const auto ask = [&](const Message& message) {
        Client other(master);
        other.start_asking({message});
        master.run_until([&] { return other.done; });
        const auto* failure = std::get_if<Failure>(&other.answer->value());
        return failure == nullptr ? std::string("fine") : failure->detail;
    };
    EXPECT_EQ(ask(Cancel{*client.job, scenario}), "fine");
    EXPECT_NE(ask(Cancel{*client.job, scenario}).find("has a result"), std::string::npos);
    EXPECT_NE(ask(Cancel{*client.job, 10'000}).find("no scenario"), std::string::npos);
    FakeWorker worker(master, {});
    master.run_until([&] { return client.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Done);
    EXPECT_EQ(client.statuses.back().summary.failed, 1u);
    EXPECT_EQ(client.statuses.back().summary.merged(), reference().scenarios.size());
}

TEST(Server, AWorkerThatSendsRubbishOrHoldsWhatDoesNotExistIsCutOff) {
    for (const FakeWorker::Habits habits :
         {FakeWorker::Habits{.sends_rubbish = true}, FakeWorker::Habits{.holds_too_much = true}}) {
        Master master;
        FakeWorker bad(master, habits);
        Client client(master);
        client.start(reference().submission());
        master.run_until([&] { return bad.ended; });
        FakeWorker good(master, {});
        master.run_until([&] { return client.done; });
        expect_right(client);
    }
}

/// Seconds of the link that the worker of a master, which has done one job, has to expect for the
/// first blocks of the next.
double expected_transfer(bool says_what_it_holds) {
    Master master;
    FakeWorker worker(master, {.says_what_it_holds = says_what_it_holds});
    for (const bool is_first : {true, false}) {
        Client client(master);
        Submit submit = reference().submission();
        submit.cluster.strategy = Strategy::EarliestFinish;
        client.start(submit);
        if (is_first) {
            master.run_until([&] { return client.done; });
            continue;
        }
        master.run_until(
            [&] { return client.job && master.coordinator.analysis_input(*client.job); });
        Analysis analysis;
        analysis.roots_a = {0};
        analysis.roots_b = {0};
        return master.coordinator.explain(*client.job, analysis).value().workers.at(0).transfer;
    }
    return 0;
}

TEST(Server, TransfersToAWorkerAreMeasured) {
    const double assumed = expected_transfer(false);
    const double measured = expected_transfer(true);
    EXPECT_GT(assumed, 0);
    EXPECT_GT(measured, 0);
    EXPECT_NE(measured, assumed);
}

TEST(Server, JobsOfSeveralClientsRunSideBySideAndMeshesAreSentOnce) {
    Master master;
    FakeWorker worker(master, {});
    Client first(master);
    first.start(reference().submission());
    master.run_until([&] { return first.job.has_value(); });
    Client second(master);
    Submit other = reference().submission();
    other.cluster.depth_a = 6;
    second.start(other);
    master.run_until([&] { return first.done && second.done; });
    expect_right(first);
    expect_right(second);
    EXPECT_NE(first.job, second.job);
    EXPECT_EQ(second.meshes_sent, 0u);
}

TEST(Server, AGridNeedsNoPoses) {
    Master master;
    FakeWorker worker(master, {});
    Client upload(master);
    upload.start(reference().submission());
    master.run_until([&] { return upload.done; });

    Grid grid;
    grid.position = {GridAxis{-1.5, 1.5, 7}, GridAxis{-1, 1, 3}, GridAxis{0, 0, 1}};
    for (int axis = 0; axis < 3; ++axis) {
        grid.rotation[static_cast<std::size_t>(axis)] = rotation_axis({0, 0, 1}, axis);
    }
    Submit submit = reference().submission();
    submit.scenarios = grid.count();
    submit.grid = encode_grid(grid);
    Client client(master);
    client.start_asking({submit});
    master.run_until([&] { return client.done; });
    ASSERT_TRUE(client.answer->has_value());
    const auto* accepted = std::get_if<Accepted>(&client.answer->value());
    ASSERT_NE(accepted, nullptr);
    master.run_until([&] {
        return master.coordinator.job_status(accepted->job).value().state == JobState::Done;
    });
    EXPECT_EQ(master.coordinator.job_status(accepted->job).value().summary.merged(), 21u);
}

TEST(Server, ACancelledJobEndsAndSaysSo) {
    Master master;
    Client client(master); // No worker: it would run for ever.
    client.start(reference().submission());
    master.run_until([&] { return !client.statuses.empty(); });
    Client other(master);
    other.start_asking({Cancel{*client.job}});
    master.run_until([&] { return client.done && other.done; });
    EXPECT_EQ(client.statuses.back().state, JobState::Cancelled);
    EXPECT_EQ(std::get<JobStatus>(other.answer->value()).state, JobState::Cancelled);
}

TEST(Server, WhatIsSubmittedWrongIsRefusedWithAReason) {
    Master master;
    Client upload(master);
    upload.start(reference().submission());
    master.run_until([&] { return upload.job.has_value(); });

    const auto expect_failure = [&](std::vector<Message> messages, const std::string& words) {
        SCOPED_TRACE(words);
        Client client(master);
        client.start_asking(std::move(messages));
        master.run_until([&] { return client.done; });
        ASSERT_TRUE(client.answer->has_value());
        const auto* failure = std::get_if<Failure>(&client.answer->value());
        ASSERT_NE(failure, nullptr);
        EXPECT_NE(failure->detail.find(words), std::string::npos) << failure->detail;
    };
    const Submit good = reference().submission();
    const auto with = [&](auto change) {
        Submit submit = good;
        change(submit);
        return std::vector<Message>{submit};
    };
    expect_failure(with([](Submit& s) { s.bodies.pop_back(); }), "two bodies");
    expect_failure(with([](Submit& s) { s.bodies[1] = Sha256{}; }), "not stored");
    expect_failure(with([](Submit& s) { s.cluster.depth_a = 21; }), "depth of A");
    expect_failure(with([](Submit& s) { s.cluster.q = 0; }), "q is 0");
    expect_failure(with([](Submit& s) { s.cluster.v_kb = 0; }), "v_kb");
    expect_failure(with([](Submit& s) { s.scenarios = ~0ull; }), "number of scenarios");
    expect_failure(with([](Submit& s) { s.query.ignored = {{0, 1u << 30, 0, 1}}; }), "outside");
    expect_failure(with([](Submit& s) { s.query.tolerance = -0.5; }), "tolerance");
    expect_failure(with([](Submit& s) { s.grid = Bytes(3); }), "");
    // Fewer poses than announced; then more.
    const std::span<const Scenario> all(reference().scenarios);
    expect_failure({good, PosesPart{pack_scenarios(all.first(10))}, PosesEnd{}}, "announced");
    Submit one = good;
    one.scenarios = 1;
    expect_failure({one, PosesPart{pack_scenarios(all.first(2))}, PosesEnd{}}, "");
    expect_failure({PosesEnd{}}, "without a job");
    expect_failure({Cancel{JobId{99}}}, "no job 99");
    expect_failure({Watch{JobId{99}}}, "no job 99");
    expect_failure({ResultsQuery{JobId{99}, 0, 1}}, "no job 99");
    expect_failure({EndOfTask{}}, "does not send");
    // A mesh whose bytes are not what its name says, and one that starts in the middle.
    const Bytes bytes(100);
    expect_failure({MeshPart{Sha256{}, "x", 100, 0, bytes}}, "");
}

TEST(Server, TheStatusOfTheClusterTellsOfWorkersJobsAndMeshes) {
    Master master;
    FakeWorker worker(master, {});
    Client client(master);
    client.start(reference().submission());
    master.run_until([&] { return client.done; });
    Client asking(master);
    asking.start_asking({StatusQuery{}});
    master.run_until([&] { return asking.done; });
    const auto status = std::get<ClusterStatus>(asking.answer->value());
    ASSERT_EQ(status.workers.size(), 1u);
    EXPECT_EQ(status.workers[0].name, "fake");
    EXPECT_EQ(status.workers[0].scenarios + status.jobs.at(0).answered_by_master,
              reference().scenarios.size());
    EXPECT_GE(status.workers[0].tasks, 1u);
    EXPECT_EQ(status.workers[0].subtrees_sent, worker.blocks);
    EXPECT_GT(status.workers[0].subtree_bytes_sent, 0u);
    EXPECT_GT(status.workers[0].bytes_sent, status.workers[0].subtree_bytes_sent);
    EXPECT_GT(status.workers[0].bytes_received, 0u);
    EXPECT_GT(status.workers[0].scenarios_per_second, 0);
    EXPECT_EQ(status.meshes.size(), 2u);
    EXPECT_GT(status.cpu_seconds, 0);
}

} // namespace
} // namespace cd::tests
