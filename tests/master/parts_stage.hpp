// The master's parts and services without a server, for tests of one service by itself. The test
// says what each worker sends.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/coordinator/invariants.hpp"
#include "master/coordinator/master_services.hpp"
#include "master/coordinator/worker_desk.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cd::tests {

/// The poses of `reference()` on a disk on which the first read fails.
inline std::shared_ptr<OrderedPoses> failing_poses() {
    const auto poses = std::make_shared<PackedPoses>(reference().scenarios);
    poses->failures = 1;
    return std::make_shared<OrderedPoses>(poses);
}

/// The meshes of `reference()` are stored. Nothing is handed out unless the test or a service under
/// test calls `services.work.feed()`.
class PartsStage : public testing::Test {
  protected:
    /// A worker's end of its connection.
    struct End {
        std::shared_ptr<Channel> channel;
        std::vector<Message> came;
    };

    PartsStage() {
        store(reference().a);
        store(reference().b);
        state.writer.start({[this](WorkerId worker, const ResultsKept& message) {
                                auto& sequences = kept[worker];
                                sequences.insert(sequences.end(),
                                                 message.sequences.begin(),
                                                 message.sequences.end());
                            },
                            [](JobId) {},
                            [this](JobId job) { ended.push_back(job); },
                            [this](JobId job) { dropped.push_back(job); },
                            [this](const Dispute& dispute) { disputes.push_back(dispute); },
                            [] {},
                            [] {}});
    }
    ~PartsStage() override {
        if (!HasFatalFailure()) {
            run_until_idle();
            check_invariants(state, services);
        }
    }

    /// Ends all work of the pools, and takes up its outcomes.
    void run_until_idle() {
        do {
            for (ThreadPool* pool : {&blocking, &compute}) {
                wait_for_all(*pool);
            }
        } while (context.poll() != 0);
    }

    template <class Condition>
    void run_until(const Condition& condition) {
        tests::run_until(context, condition);
    }

    void store(const Mesh& mesh) {
        const Bytes bytes = mesh.canonical_bytes();
        auto upload = geometry->begin_upload(mesh.hash(), "mesh", bytes.size());
        ASSERT_TRUE(upload && upload.value()->append(0, bytes));
        ASSERT_TRUE(geometry->finish_upload(std::move(upload.value())));
    }
    [[nodiscard]] static std::shared_ptr<OrderedPoses> poses() {
        return ordered(reference().scenarios);
    }
    /// Accepts a job, whose geometry is loaded next.
    MasterJob& begin(const Submit& submit, std::shared_ptr<OrderedPoses> scenarios = poses()) {
        const JobId id = state.jobs.next(submit.scenarios).value();
        const JobRecord record{id, submit};
        state.writer.write(AcceptJob{record});
        services.start.begin(record,
                             ResultStore::create(journal->results_path(id), id, submit.scenarios),
                             std::move(scenarios));
        return state.jobs.at(id);
    }
    /// Begins a job and loads its geometry.
    MasterJob& open(const Submit& submit, std::shared_ptr<OrderedPoses> scenarios = poses()) {
        MasterJob& job = begin(submit, std::move(scenarios));
        run_until([&] { return job.work() != nullptr; });
        return job;
    }
    MasterJob& open(AnalysisMode mode = AnalysisMode::Always) { return open(submission(mode)); }

    /// Returns a worker process with a connection.
    WorkerId join(InstanceId process, std::uint32_t threads = 1) {
        Hello hello = hello_of_worker("w" + std::to_string(process), process);
        hello.threads = threads;
        return connect(hello);
    }
    /// The worker goes on over another connection, on which nothing has come yet.
    void resume(WorkerId worker) {
        Hello hello;
        hello.instance = state.workers.find(worker)->instance;
        hello.resumed.id = worker.value;
        hello.resumed.epoch = state.workers.epoch();
        ASSERT_EQ(connect(hello), worker);
    }
    /// The worker is lost, and its process with it.
    void lose(WorkerId worker) {
        state.workers.cut_off(worker, {ErrorCode::Disconnected, "the test loses it"});
        connection_ended(worker);
    }
    void connection_ended(WorkerId worker) {
        const auto channel = state.workers.find(worker)->channel;
        channel->close();
        state.workers.connection_ended(worker, *channel, "the test ends it");
    }
    /// All messages of one type that the master has sent to a connected worker.
    template <class Type>
    [[nodiscard]] std::vector<Type> received(WorkerId worker) {
        const RemoveTree last{TreeId{~std::uint64_t{0}}};
        state.workers.find(worker)->channel->send(last);
        std::vector<Message>& came = ends.at(worker).came;
        run_until([&] {
            const auto* tree = came.empty() ? nullptr : std::get_if<RemoveTree>(&came.back());
            return tree != nullptr && tree->tree == last.tree;
        });
        came.pop_back();
        return came_so_far<Type>(worker);
    }
    /// Waits for a message of the type, after `before` others, and returns it.
    template <class Type>
    Type next(WorkerId worker, std::size_t before = 0) {
        run_until([&] { return came_so_far<Type>(worker).size() > before; });
        return came_so_far<Type>(worker).at(before);
    }
    /// Waits until all results that were written are durable.
    void run_until_committed(MasterJob& job) {
        run_until([&] { return job.results->count() == job.merged.summary().merged(); });
    }

    [[nodiscard]] std::shared_ptr<const Author> author(InstanceId process) {
        std::shared_ptr<const Author>& one = authors[process];
        if (one == nullptr) {
            one = std::make_shared<const Author>(
                Author{process, WorkerId{process}, "w" + std::to_string(process), ""});
        }
        return one;
    }
    /// A scenario of a running job.
    [[nodiscard]] static PlacedScenario placed(const MasterJob& job, std::uint64_t index) {
        return read_one(*job.run->poses, index).value();
    }
    [[nodiscard]] static std::uint64_t position_of(const MasterJob& job, std::uint64_t index) {
        return placed(job, index).position;
    }
    [[nodiscard]] static TakenResults taken(const ScenarioResult& result) {
        TakenResults one;
        one.add(result, 0, {});
        return one;
    }
    void merge(MasterJob& job, const ScenarioResult& result, InstanceId process) {
        const std::uint64_t index = result.index;
        TakenResults one = taken(result);
        one.positions_of_rows.front() =
            index < job.submit.scenarios ? position_of(job, index) : index;
        services.merger.merge(job, std::move(one), process == 0 ? nullptr : author(process));
    }

    void perform(const Action& action) {
        actions.push_back(action);
        std::visit(
            [this](const auto& one) {
                using One = std::decay_t<decltype(one)>;
                if constexpr (std::is_same_v<One, PositionsLost>) {
                    services.ranges.lost(one);
                } else if constexpr (std::is_same_v<One, GiveUp>) {
                    MasterJob& job = state.jobs.at(one.job);
                    const auto analysis = job.work()->open.find(one.position);
                    services.merger.fail(job, {analysis->scenario, analysis->position}, "given up");
                } else {
                    services.tasks.send(one);
                }
            },
            action);
    }
    /// The performed actions of one type.
    template <class Type>
    [[nodiscard]] std::vector<Type> performed() const {
        std::vector<Type> found;
        for (const Action& action : actions) {
            if (const auto* one = std::get_if<Type>(&action)) {
                found.push_back(*one);
            }
        }
        return found;
    }

    std::vector<Action> actions;
    std::size_t outcomes = 0; ///< Of background work.
    // What the journal has announced.
    std::map<WorkerId, std::vector<std::uint64_t>> kept; ///< Sequence numbers.
    std::vector<JobId> ended;
    std::vector<JobId> dropped;
    std::vector<Dispute> disputes;
    std::map<InstanceId, std::shared_ptr<const Author>> authors;

    TemporaryFolder folder;
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> pools_may_post{
        context.get_executor()};
    std::map<WorkerId, End> ends; ///< Their sockets end before the context.
    AsioLoop loop{context.get_executor()};
    ThreadPool compute{2};
    std::unique_ptr<GeometryStore> geometry =
        std::move(GeometryStore::open(folder.path(), compute).value());
    StoredGeometry stored{*geometry};
    std::unique_ptr<Journal> journal =
        std::move(Journal::open({.directory = folder.path(), .synced = false}).value());
    ThreadPool blocking{2};
    CoordinatorParts parts{context.get_executor(),
                           loop,
                           tcp_network(),
                           stored,
                           geometry.get(),
                           compute,
                           blocking,
                           *journal,
                           folder / "jobs",
                           {.durability = Durability::Unsynced,
                            .times = {.return_within = std::chrono::milliseconds(0)}}};
    MasterState state{
        parts, {desk, [this](const Action& action) { perform(action); }, [this] { ++outcomes; }}};
    MasterServices services{parts, state};
    WorkerDesk desk{state, services, parts.options.times.heartbeat};

  private:
    WorkerId connect(const Hello& hello) {
        const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
        asio::ip::tcp::acceptor acceptor(context, any_port);
        asio::ip::tcp::socket socket(context);
        socket.connect(acceptor.local_endpoint());
        const auto channel = Channel::make(std::make_unique<Stream>(std::move(socket)));
        channel->expect(Party::Master);
        const Reception reception = state.workers.receive(hello, "");
        ends[reception.worker] = {channel, {}};
        spawn(context.get_executor(), "a worker's end", read(channel, reception.worker));
        state.workers.join(
            reception, hello, Channel::make(std::make_unique<Stream>(acceptor.accept())));
        return reception.worker;
    }
    template <class Type>
    [[nodiscard]] std::vector<Type> came_so_far(WorkerId worker) const {
        std::vector<Type> found;
        for (const Message& message : ends.at(worker).came) {
            if (const auto* one = std::get_if<Type>(&message)) {
                found.push_back(*one);
            }
        }
        return found;
    }
    asio::awaitable<void> read(std::shared_ptr<Channel> channel, WorkerId worker) {
        for (;;) {
            Result<Message> message = co_await channel->receive(patience);
            if (!message) {
                co_return;
            }
            if (ends.at(worker).channel == channel) {
                ends.at(worker).came.push_back(std::move(message.value()));
            }
        }
    }
};

} // namespace cd::tests
