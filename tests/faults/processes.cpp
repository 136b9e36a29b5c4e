#include "tests/faults/processes.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/worker.hpp"
#include "proto/codec/codec.hpp"
#include "tests/faults/simulated_journal.hpp"
#include "tests/faults/simulated_network.hpp"
#include "tests/faults/simulated_pool.hpp"
#include "tests/support/packed_poses.hpp"

namespace cd::tests {

using namespace std::chrono_literals;

namespace {

constexpr unsigned master_threads = 2;

asio::awaitable<void> pause_for(Duration time) {
    asio::steady_timer timer(co_await asio::this_coro::executor, time);
    boost::system::error_code ignored;
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
}

} // namespace

// ---- The master -------------------------------------------------------------------------------

MasterProcess::MasterProcess(World& world) : host_(master_host, "master") {
    world.watcher.master_began();
    compute_ = std::make_unique<SimulatedPool>(world, host_, master_threads);
    blocking_ = std::make_unique<SimulatedPool>(world, host_, master_threads);
    auto journal = SimulatedJournal::open(world);
    if (!journal) {
        world.problem("the master does not start: " + journal.error().detail);
        return;
    }
    journal_ = std::move(journal.value());
    coordinator_ = std::make_unique<Coordinator>(CoordinatorParts{host_.context.get_executor(),
                                                                  loop_,
                                                                  simulated_network(),
                                                                  geometry_,
                                                                  &known_geometry(),
                                                                  *compute_,
                                                                  *blocking_,
                                                                  *journal_,
                                                                  "/state/jobs",
                                                                  {.knows_owners = true}});
    if (const Status restored = coordinator_->restore(journal_->take_recovered()); !restored) {
        coordinator_.reset();
        world.problem("the master does not start: " + restored.error().detail);
        return;
    }
    server_ = std::move(
        Server::listen(host_.context.get_executor(), {"master", master_port}, *coordinator_)
            .value());
    server_->start();
    world.wake(host_);
}

// ---- A worker ---------------------------------------------------------------------------------

WorkerProcess::WorkerProcess(World& world, std::uint64_t id, const WorkerHabits& habits)
    : world_(world), habits_(habits), host_(id, "worker-" + std::to_string(id)) {
    host_.is_odd = true;
    executor_ =
        std::make_unique<Executor>(host_.context.get_executor(),
                                   std::make_unique<SimulatedPool>(world_, host_, habits.threads));
    membership_ = std::make_unique<Membership>(*executor_, habits.cache_bytes, habits.unkept);
    spawn(host_.context.get_executor(), "worker", run());
    world.wake(host_);
}

void WorkerProcess::drain() {
    is_draining_ = true;
    has_ended_ = has_ended_ || !membership_->drain(25s, [this] { has_ended_ = true; });
    world_.wake(host_);
}

// When the bound is reached, running scenarios and finished but unsent results are still sent.
bool WorkerProcess::keeps_too_much() const {
    const std::size_t running = limits::jobs_per_thread_max * habits_.threads;
    return membership_->unkept().messages().size() >
           habits_.unkept.messages + 2 * running + limits::batches_at_worker;
}

asio::awaitable<void> WorkerProcess::run() {
    while (!has_ended_) {
        Target master{Endpoint{"master", master_port}};
        const auto channel = co_await simulated_network().connect(std::move(master), 10s);
        if (channel) {
            co_await serve(channel.value());
        }
        if (!has_ended_) {
            co_await pause_for(world_.between(100ms, 2s));
        }
    }
}

asio::awaitable<void> WorkerProcess::serve(std::shared_ptr<Channel> channel) {
    if (habits_.serves_peers && peer_server_ == nullptr) {
        const Endpoint endpoint{host_.name, static_cast<std::uint16_t>(8000 + host_.id)};
        const auto no_tls = std::make_shared<TlsSlot>();
        peer_server_ =
            PeerServer::listen(host_.context.get_executor(), endpoint, no_tls, simulated_network())
                .value();
    }
    Hello hello;
    hello.role = Role::Worker;
    hello.name = host_.name;
    hello.threads = habits_.threads;
    hello.cache_bytes = habits_.cache_bytes;
    hello.weight = habits_.weight;
    hello.instance = host_.id;
    hello.peer_port = peer_server_ == nullptr ? std::uint16_t{0} : peer_server_->port();
    PeerParts peers{peer_server_, {}, host_.name};
    peers.network = &simulated_network();
    const Result<Served> served =
        co_await membership_->serve(std::move(channel), std::move(hello), std::move(peers));
    if (served) {
        const SessionEnd how = served.value().how;
        has_ended_ = how == SessionEnd::Drained || how == SessionEnd::Terminated ||
                     (is_draining_ && !membership_->has_work());
    }
}

// ---- A client ---------------------------------------------------------------------------------

ClientProcess::ClientProcess(World& world,
                             std::uint64_t id,
                             const KnownJob& job,
                             ClusterOptions options)
    : world_(world), job_(job), options_(options), host_(id, "client-" + std::to_string(id)) {
    spawn(host_.context.get_executor(), "client", run());
    world.wake(host_);
}

asio::awaitable<void> ClientProcess::run() {
    while (!end_) {
        Target master{Endpoint{"master", master_port}};
        const auto channel = co_await simulated_network().connect(std::move(master), 10s);
        if (channel) {
            co_await converse(channel.value());
        }
        if (!end_) {
            co_await pause_for(world_.between(100ms, 1s));
        }
    }
}

void ClientProcess::submit(Channel& channel) const {
    Submit message = job_.submit;
    message.cluster = options_;
    // The priority follows from the client's number: a drawn one would change each seed's schedule.
    message.priority = static_cast<std::int32_t>(host_.id % 3) - 1;
    channel.send(message);
    if (!message.grid) {
        for (Bytes& run : packed_runs(job_.scenarios)) {
            channel.send(PosesPart{std::move(run)});
        }
        channel.send(PosesEnd{});
    }
}

asio::awaitable<void> ClientProcess::converse(std::shared_ptr<Channel> channel) {
    Hello hello;
    hello.role = Role::Client;
    hello.name = host_.name;
    const Result<Welcome> welcome = co_await greet(channel, hello);
    if (!welcome) {
        co_return;
    }
    if (id_) {
        channel->send(Watch{*id_});
    } else {
        submit(*channel);
    }
    Time said = world_.now();
    while (world_.now() - said < 30s) {
        const Result<Message> message = co_await channel->receive(500ms);
        if (!message && message.error().code != ErrorCode::Timeout) {
            co_return;
        }
        if (id_ && wants_cancel_) {
            wants_cancel_ = false;
            channel->send(Cancel{*id_});
        }
        if (!message) {
            continue;
        }
        said = id_ ? world_.now() : said;
        if (const auto* accepted = std::get_if<Accepted>(&message.value())) {
            id_ = accepted->job;
            channel->send(Watch{*id_});
        } else if (const auto* status = std::get_if<JobStatus>(&message.value())) {
            if (status->state != JobState::Running) {
                end_ = *status;
                channel->close();
                co_return;
            }
        } else if (const auto* failure = std::get_if<Failure>(&message.value())) {
            if (id_ && failure->code == ErrorCode::NotFound) {
                world_.problem("an accepted job is not known any more: " + failure->detail);
            }
            co_return;
        }
    }
}

} // namespace cd::tests
