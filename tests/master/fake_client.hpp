// A client that submits, watches and fetches, and the right result of its job.
#pragma once

#include "common/job/result/contact_map.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/master/master_stage.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/scenarios.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <utility>

namespace cd::tests {

/// The meshes and scenarios of the tests, with the right results.
struct Reference {
    Reference() {
        std::mt19937_64 random(1);
        for (std::uint64_t i = 0; i < 90; ++i) {
            scenarios.push_back(make_scenario({Pose{}, make_pose(random, 1.6)}, i));
        }
        const ObbTree tree_a = make_tree(a);
        const ObbTree tree_b = make_tree(b);
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
        submit.bodies = {{a.hash(), "a"}, {b.hash(), "b"}};
        submit.cluster.strategy = "best-match"; // Makes small batches.
        submit.cluster.depths = {4, 3};
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

/// Returns the submission of `reference()` with this analysis.
inline Submit submission(AnalysisMode mode) {
    Submit submit = reference().submission();
    submit.cluster.analysis = mode;
    return submit;
}

/// Returns the submission of `reference()` with a grid in place of its poses.
inline Submit submission(const Grid& grid) {
    Submit submit = reference().submission();
    submit.scenarios = grid.count();
    submit.grid = encode_grid(grid);
    submit.poses.kind = PosesKind::Grid;
    return submit;
}

/// Returns the result as a worker computes it.
inline ScenarioResult right_result(std::uint64_t index) {
    static const auto trees = std::pair(make_tree(reference().a), make_tree(reference().b));
    const std::vector<SubtreePair> whole{{trees.first.view(), trees.second.view()}};
    return run_on_subtrees(whole, reference().scenarios[index], {}).result;
}

/// Returns what a worker answers that says that nothing touches.
inline ScenarioResult wrong_result(std::uint64_t index) {
    ScenarioResult result = right_result(index);
    result.kind = ScenarioClass::Separate;
    result.pair_count = 0;
    result.pairs.clear();
    return result;
}

/// Returns the packed sums by part of results that list pairs, as a worker sends them.
inline Bytes packed_sums(std::span<const ScenarioResult> results) {
    ContactMapSum sum(body_part_runs(reference().a, reference().b));
    for (const ScenarioResult& result : results) {
        sum.add(result, {});
    }
    return pack_map(sum.take());
}

/// Results without a task, as from an earlier session.
inline Results late_results(JobId job, const ScenarioResult& result) {
    ByteWriter records;
    put_record(records, encode_result(result));
    Results results;
    results.job = job;
    results.count = 1;
    results.records = pack_records(records.bytes());
    results.map = packed_sums(std::span(&result, 1));
    return results;
}

inline Results right_results(JobId job, std::uint64_t index) {
    return late_results(job, right_result(index));
}

/// Returns a scenario that only a worker can answer.
inline std::uint64_t scenario_with_contact() {
    std::uint64_t index = 0;
    while (right_result(index).pair_count == 0) {
        ++index;
    }
    return index;
}

/// If all stored results say that nothing touches, returns a scenario whose result is wrong.
inline std::optional<std::uint64_t> wrong_scenario(const ResultStore& results) {
    for (const Scenario& scenario : reference().scenarios) {
        if (results.has(scenario.index) && right_result(scenario.index).pair_count != 0) {
            return scenario.index;
        }
    }
    return std::nullopt;
}

/// A client that runs one conversation.
class Client {
  public:
    explicit Client(Master& master) : master_(master) {}
    /// Starts this submission.
    Client(Master& master, Submit submit) : Client(master) { start(std::move(submit)); }
    ~Client() { hang_up(master_, channel_, ended_); }

    /// Uploads missing meshes, submits with poses, watches to the end, and fetches all results.
    void start(Submit submit) {
        spawn(master_.context.get_executor(), "client", run(std::move(submit)));
    }
    /// Submits only; it is done when the job is accepted.
    void start_submitting(Submit submit) {
        spawn(master_.context.get_executor(), "client", submit_and_leave(std::move(submit)));
    }
    /// Sends the messages and keeps one answer.
    void start_asking(std::vector<Message> messages) {
        spawn(master_.context.get_executor(), "client", ask(std::move(messages)));
    }
    void run_until_done() {
        master_.run_until([this] { return done; });
    }
    /// Expects the job to end with the results of `reference()`, and so many failed.
    void expect_right(std::uint64_t failed = 0) {
        run_until_done();
        ASSERT_TRUE(done);
        const JobStatus& last = statuses.back();
        EXPECT_EQ(last.state, JobState::Done) << last.failure;
        EXPECT_EQ(last.summary.failed, failed);
        EXPECT_EQ(last.summary.merged(), reference().scenarios.size());
        if (failed == 0) {
            EXPECT_EQ(last.digest, reference().digest);
            EXPECT_EQ(last.summary.pairs, reference().summary.pairs);
            EXPECT_EQ(last.summary.cross, reference().summary.cross);
            EXPECT_EQ(records, reference().scenarios.size());
        }
    }

    std::uint64_t boot_id = 0; ///< Of the host on which the client says that it runs.
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
        Hello hello; // Named, because GCC 12 copies temporaries in such an expression bit by bit.
        hello.boot_id = boot_id;
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
        MeshesQuery query;
        for (const JobBody& body : submit.bodies) {
            query.meshes.push_back(body.mesh);
        }
        channel_->send(query);
        const auto missing =
            std::get<MeshesMissing>((co_await channel_->receive(patience)).value());
        for (const Sha256& hash : missing.meshes) {
            co_await upload(hash);
        }
        channel_->send(submit);
        for (Bytes& run : packed_runs(reference().scenarios)) {
            channel_->send(PosesPart{std::move(run)});
        }
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

/// Returns the answer to the last message; the others need none.
inline Message answer_to(Master& master, std::vector<Message> messages) {
    Client client(master);
    client.start_asking(std::move(messages));
    client.run_until_done();
    EXPECT_TRUE(client.answer->has_value());
    return client.answer->has_value() ? client.answer->value() : Message{};
}

/// Returns the text of the failure that answers the last message.
inline std::string refusal_of(Master& master, std::vector<Message> messages) {
    const Message answer = answer_to(master, std::move(messages));
    const auto* const failure = std::get_if<Failure>(&answer);
    EXPECT_NE(failure, nullptr) << answer.index();
    return failure == nullptr ? "" : failure->detail;
}

/// Returns once the job is accepted; does not wait for its end.
inline JobId submit_to(Master& master, Submit submit) {
    Client client(master);
    client.start_submitting(std::move(submit));
    client.run_until_done();
    return client.job.value();
}

inline void expect_right_end(Master& master, JobId job) {
    master.run_until([&] { return master.status(job).state != JobState::Running; });
    const JobStatus status = master.status(job);
    EXPECT_EQ(status.state, JobState::Done) << status.failure;
    EXPECT_EQ(status.digest, reference().digest);
    EXPECT_EQ(status.summary.pairs, reference().summary.pairs);
    EXPECT_TRUE(status.paused.empty());
}

} // namespace cd::tests
