// A whole master in the test's process, and those who connect to it: workers with habits, and
// clients.
#pragma once

#include "common/core/compress.hpp"
#include "common/core/disk_file.hpp"
#include "common/core/limits.hpp"
#include "common/job/packed_records.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build.hpp"
#include "common/tree/partial_tree.hpp"
#include "common/tree/top_block.hpp"
#include "master/coordinator.hpp"
#include "master/identity.hpp"
#include "master/server.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <utility>

namespace cd::tests {

inline constexpr std::chrono::seconds patience{60};

/// What is not as usual of a master.
struct Stage {
    ClientLimits clients = {};
    bool is_secured = false; ///< With an identity, which is made where there is none.
};

/// A whole master on one context, which the test runs.
class Master {
  public:
    /// Unless told, a worker whose connection breaks does not come back.
    explicit Master(
        const FailureTimes& failure_times = {.return_within = std::chrono::milliseconds(0)},
        const std::filesystem::path& state = {}, ///< Empty: a folder of its own.
        const Stage& stage = {})
        : directory(state.empty() ? folder.path() : state),
          times(failure_times),
          identity(stage.is_secured ? make_identity() : nullptr),
          server(std::move(Server::listen(context.get_executor(),
                                          {"127.0.0.1", 0},
                                          coordinator,
                                          identity.get(),
                                          stage.clients)
                               .value())) {
        EXPECT_TRUE(coordinator.restore(journal->take_recovered()));
        server->start();
    }
    ~Master() { end(); }

    /// What has begun is finished; nothing begins any more.
    void end() {
        server->close();
        context.run_for(patience);
    }

    /// Runs everything until the condition holds.
    template <class Condition>
    void run_until(Condition condition) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!condition() && std::chrono::steady_clock::now() < deadline) {
            context.run_one_for(std::chrono::seconds(1));
        }
        ASSERT_TRUE(condition()) << "this took too long";
    }
    [[nodiscard]] Endpoint endpoint() const { return {"127.0.0.1", server->port()}; }
    /// For a holder of that name and role; plain without an identity.
    [[nodiscard]] Target target(CertifiedRole role, const std::string& holder) const {
        if (identity == nullptr) {
            return endpoint();
        }
        const auto authority =
            CertificateAuthority::parse(read_text(directory / "identity/authority.pem"),
                                        read_text(directory / "identity/authority.key"));
        const WallTime now = identity->now();
        const std::chrono::hours hour(1);
        return {endpoint(),
                Tls::make(authority.value().issue({role, holder, now - hour, now + hour})).value()};
    }

    TemporaryFolder folder;
    std::filesystem::path directory;
    asio::io_context context{1};
    ThreadPool compute{2};
    std::unique_ptr<GeometryStore> store =
        std::move(GeometryStore::open(directory, compute).value());
    std::unique_ptr<Journal> journal =
        std::move(Journal::open({.directory = directory, .synced = false}).value());
    ThreadPool blocking{2};
    FailureTimes times;
    Coordinator coordinator{{context.get_executor(),
                             *store,
                             compute,
                             blocking,
                             *journal,
                             directory / "jobs",
                             Durability::Unsynced,
                             times}};
    std::unique_ptr<MasterIdentity> identity;
    std::unique_ptr<Server> server;

  private:
    [[nodiscard]] std::unique_ptr<MasterIdentity> make_identity() const {
        const MasterIdentity::Options options{std::chrono::hours(1)};
        if (!std::filesystem::exists(directory / "identity")) {
            EXPECT_TRUE(MasterIdentity::init(directory, options));
        }
        return std::move(MasterIdentity::open(directory, options).value());
    }
};

/// The end of a peer's conversation with the master, which a test must not outlive.
struct Ending {
    bool& ended;
    ~Ending() { ended = true; }
};

inline void hang_up(Master& master, const std::shared_ptr<Channel>& channel, const bool& ended) {
    while (!ended) {
        if (channel != nullptr) {
            channel->close();
        }
        master.context.run_one_for(std::chrono::seconds(1));
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
        bool lies_say_failed = false; ///< Else that nothing touches.
        std::uint64_t lies_alone = 0; ///< So many first batches it answers wrongly, and that is it.
        std::optional<std::uint64_t> dies_of = {}; ///< A scenario.
        bool sends_rubbish = false;
        bool forgets_one = false;    ///< Once, it ends a task without an answer.
        bool holds_too_much = false; ///< Roots that the tree does not have.
        bool says_what_it_holds = false;
        bool only_takes = false;                       ///< It does nothing with what it gets.
        std::uint64_t instance = 0;                    ///< Of its process; 0: not known.
        std::uint64_t batches_max = ~std::uint64_t{0}; ///< It answers so many, and rests.
        std::optional<Results> comes_with = {};        ///< Of an earlier session.
        std::optional<std::uint64_t> holds = {};       ///< A scenario, until it is told to go on.
        std::string holder = "worker";                 ///< Of its certificate, if it needs one.
    };

    FakeWorker(Master& master, Habits habits) : master_(master), habits_(habits) {
        spawn(master.context.get_executor(), "fake worker", run());
    }
    ~FakeWorker() { hang_up(master_, channel_, ended); }

    std::uint64_t batches = 0;
    std::uint64_t ranges = 0;
    std::uint64_t blocks = 0;
    std::uint64_t trees_removed = 0;
    std::uint64_t kept = 0; ///< Messages of results that the master says it has for good.
    bool is_held = false;
    std::optional<std::uint64_t> dropped; ///< The last scenario that nobody waits for.
    bool ended = false;

    void go_on() {
        habits_.holds.reset();
        work();
    }

  private:
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
        Hello hello;
        hello.role = Role::Worker;
        hello.name = "fake";
        hello.threads = 1;
        hello.cache_bytes = 1 << 20;
        hello.instance = habits_.instance;
        (void)co_await greet(channel_, hello);
        if (habits_.comes_with) {
            channel_->send(*habits_.comes_with);
        }
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
            } else if (const auto* drop = std::get_if<DropScenario>(&message.value())) {
                dropped = drop->scenario;
            } else if (const auto* acknowledged = std::get_if<ResultsKept>(&message.value())) {
                kept += acknowledged->sequences.size();
            } else if (auto* range = std::get_if<ScenarioRange>(&message.value())) {
                ++ranges;
                unwalked_.push_back(std::move(*range));
            } else if (auto* batch = std::get_if<Batch>(&message.value())) {
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

    /// False: one of them is deadly.
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

    bool has_tops(const ScenarioRange& range) {
        const AddJob& job = jobs_.at(range.job);
        bool has_all = true;
        for (const TreeId id : {job.tree_a, job.tree_b}) {
            Tree& tree = trees_.at(id);
            has_all = has_all && tree.top;
            if (!tree.top && !std::exchange(tree.is_top_wanted, true)) {
                channel_->send(WantSubtrees{id, {top_root}});
            }
        }
        return has_all;
    }

    [[nodiscard]] static bool has(const Batch& batch, std::optional<std::uint64_t> index) {
        const auto scenarios = unpack_scenarios(batch.scenarios, limits::scenarios_max).value();
        return index &&
               std::any_of(scenarios.begin(), scenarios.end(), [&](const Scenario& scenario) {
                   return scenario.index == *index;
               });
    }
    [[nodiscard]] bool is_deadly(const Batch& batch) const { return has(batch, habits_.dies_of); }

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
            scenarios = unpack_scenarios(range.scenarios, range.count).value();
            EXPECT_EQ(scenarios.size(), range.count);
        }
        Batch batch{range.task, range.job, pack_scenarios(scenarios), {0}, {}};
        for (const Scenario& scenario : scenarios) {
            const auto pairs = colliding_roots(
                *trees_.at(job.tree_a).top, *trees_.at(job.tree_b).top, scenario.poses);
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
        while (!waiting_.empty() && batches_answered_ < habits_.batches_max) {
            const Batch& batch = waiting_.front();
            const AddJob& job = jobs_.at(batch.job);
            is_held = has(batch, habits_.holds);
            if (is_held || !missing(job.tree_a, roots_of_a(batch.pairs)).empty() ||
                !missing(job.tree_b, roots_of_b(batch.pairs)).empty()) {
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
            const Bytes record = encode_result(result);
            out.put(static_cast<std::uint32_t>(record.size()));
            out.put_array(std::span(reinterpret_cast<const char*>(record.data()), record.size()));
        }
        results.records = pack_records(out.bytes());
        return results;
    }

    void compute(const Batch& batch, const AddJob& job) {
        const auto scenarios = unpack_scenarios(batch.scenarios, limits::scenarios_max).value();
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
    std::deque<ScenarioRange> unwalked_; ///< Wait for tops.
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

inline const Reference& reference() {
    static const Reference instance;
    return instance;
}

/// Of no task, as of an earlier session.
inline Results right_results(JobId job, std::uint64_t index) {
    static const auto trees = [] {
        ThreadPool pool(2);
        return std::pair(build_tree(share(reference().a), {}, pool),
                         build_tree(share(reference().b), {}, pool));
    }();
    const std::vector<SubtreePair> whole{{trees.first.view(), trees.second.view()}};
    const Bytes record =
        encode_result(run_on_subtrees(whole, reference().scenarios[index], {}).result);
    ByteWriter records;
    records.put(static_cast<std::uint32_t>(record.size()));
    put_bytes(records, record);
    Results results;
    results.job = job;
    results.count = 1;
    results.records = pack_records(records.bytes());
    return results;
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
    /// Of that only the beginning: it is done when the job is accepted.
    void start_submitting(Submit submit) {
        spawn(master_.context.get_executor(), "client", submit_and_leave(std::move(submit)));
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
        Target target = master_.target(CertifiedRole::Submitter, "client");
        channel_ = (co_await connect(std::move(target))).value();
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

    asio::awaitable<void> submit_and_leave(Submit submit) {
        const Ending ending{ended_};
        co_await submit_job(std::move(submit));
        done = true;
    }

    asio::awaitable<void> run(Submit submit) {
        const Ending ending{ended_};
        co_await submit_job(std::move(submit));
        channel_->send(Watch{*job});
        do {
            statuses.push_back(std::get<JobStatus>((co_await channel_->receive(patience)).value()));
        } while (statuses.back().state == JobState::Running);
        co_await fetch();
        done = true;
    }

    asio::awaitable<void> submit_job(Submit submit) {
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

inline void expect_right(const Client& client) {
    ASSERT_TRUE(client.done);
    const JobStatus& last = client.statuses.back();
    EXPECT_EQ(last.state, JobState::Done) << last.failure;
    EXPECT_EQ(last.digest, reference().digest);
    EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
    EXPECT_EQ(last.summary.pairs, reference().summary.pairs);
    EXPECT_EQ(last.summary.cross, reference().summary.cross);
    EXPECT_EQ(client.records, reference().scenarios.size());
}

} // namespace cd::tests
