#include "client/remote/connection.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/timing/engine.hpp"
#include "common/core/version.hpp"
#include "common/core/words.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_order.hpp"
#include "proto/channel/channel.hpp"
#include "web/server/cluster/result_records.hpp"
#include "web/status/table.hpp"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the error for a master that cannot write `what` to its disk.
Error no_room(const std::string& what, const Error& error) {
    return {ErrorCode::Incomplete, "the master has no room for " + what + ": " + error.detail};
}

std::string host_name() {
    std::array<char, 256> host{};
    if (::gethostname(host.data(), host.size() - 1) != 0) {
        host[0] = '\0';
    }
    return escaped(std::string(host.data())).substr(0, 150);
}

/// Returns the name of the effective user's account, which the environment may lack.
std::string user_name() {
    std::array<char, 4096> texts{};
    passwd entry{};
    passwd* found = nullptr;
    const bool is_known =
        ::getpwuid_r(::geteuid(), &entry, texts.data(), texts.size(), &found) == 0 &&
        found != nullptr;
    return is_known ? escaped(std::string(found->pw_name)).substr(0, 100)
                    : std::to_string(::geteuid());
}

/// Numbers the meshes of a job's bodies, and returns the number of each body's mesh.
std::vector<std::uint32_t> mesh_numbers(const Submit& submit) {
    std::map<Sha256, std::uint32_t> numbers;
    std::vector<std::uint32_t> of_bodies;
    for (const JobBody& body : submit.bodies) {
        const auto next = static_cast<std::uint32_t>(numbers.size());
        of_bodies.push_back(numbers.try_emplace(body.mesh, next).first->second);
    }
    return of_bodies;
}

Hello make_hello() {
    Hello hello;
    hello.role = Role::Client;
    hello.name = "cdctl " + host_name() + " " + std::to_string(::getpid());
    hello.user = user_name() + "@" + host_name();
    hello.build = std::string(version);
    return hello;
}

Error other_poses() {
    return {ErrorCode::BadFrame, "the master sent other poses than were asked for"};
}

/// Appends the poses in `part` to `all`. `part` must begin at the query's first place and have 1 to
/// `query.count` scenarios; the job has `total`. Errors: BadFrame.
Status take_poses(const JobPoses& part,
                  const PosesQuery& query,
                  std::uint64_t total,
                  LabelledScenarios& all) {
    if (part.first != query.first || part.count == 0 || part.count > query.count) {
        return other_poses();
    }
    const auto scenarios = CD_TRY(unpack_scenarios(part.scenarios, part.count));
    const auto fits = [&](std::size_t labels) { return labels == 0 || labels == part.count; };
    const PoseLabels& labels = part.labels;
    if (scenarios.size() != part.count || !fits(labels.integers.size()) ||
        !fits(labels.texts.size()) || !fits(labels.times.size()) ||
        !fits(labels.end_times.size())) {
        return other_poses();
    }
    for (std::uint64_t i = 0; i < part.count; ++i) {
        if (scenarios[i].index != sampled_scenario(part.first + i, query.sample, total)) {
            return other_poses();
        }
    }
    all.scenarios.insert(all.scenarios.end(), scenarios.begin(), scenarios.end());
    all.labels.append(labels);
    return Done{};
}

/// Stores the result of a coroutine in `result`. co_spawn could not pass it to its completion
/// handler, since a Result has no default constructor.
template <class T>
asio::awaitable<void> keep(asio::awaitable<Result<T>> coroutine, std::optional<Result<T>>& result) {
    result = co_await std::move(coroutine);
}

} // namespace

struct Connection::State {
    asio::io_context context{1};
    std::function<bool()> stopped;
    bool heeds_stop = true;
    bool is_tls = false;
    std::string address;
    std::string owner;
    std::shared_ptr<Channel> channel;
    /// Status queries sent by `watch` that the master has not answered. A watch may end before
    /// their answers arrive, so `answer` skips these.
    std::size_t cluster_statuses_due = 0;

    [[nodiscard]] bool is_stopped() const { return heeds_stop && stopped(); }

    /// Runs the coroutine to completion on this thread.
    template <class T>
    Result<T> run(asio::awaitable<Result<T>> coroutine) {
        std::optional<Result<T>> result;
        bool done = false;
        asio::co_spawn(
            context,
            keep(std::move(coroutine), result),
            [this, &done](const std::exception_ptr& thrown) {
                if (thrown) {
                    std::rethrow_exception(thrown);
                }
                done = true;
                context.stop(); // Ends `run_for`, which would wait for the channel's read.
            });
        run_until(done);
        return done ? std::move(*result) : Result<T>(interrupted());
    }

    /// Runs the context until `done`. After a stop, most coroutines end by themselves, since their
    /// waits poll `stopped`. Closing the channel ends the ones that wait for a peer that does not
    /// read. Before a channel exists, a stop ends the loop at once, and the destructor abandons
    /// pending operations.
    void run_until(const bool& done) {
        std::optional<Clock::time_point> stopped_at;
        while (!done) {
            context.restart();
            context.run_for(timing::stop_check_period);
            if (done || !is_stopped()) {
                continue;
            }
            stopped_at = stopped_at.value_or(Clock::now());
            if (channel == nullptr) {
                return;
            }
            if (Clock::now() - *stopped_at > timing::stop_patience) {
                channel->close();
            }
        }
    }

    asio::awaitable<Result<Message>> receive(Clock::duration timeout) {
        const auto deadline = Clock::now() + timeout;
        while (true) {
            if (is_stopped()) {
                co_return interrupted();
            }
            const Clock::duration left = deadline - Clock::now();
            Result<Message> message = co_await channel->receive(
                std::clamp<Clock::duration>(left, Clock::duration(0), timing::stop_check_period));
            if (message || message.error().code != ErrorCode::Timeout) {
                co_return message;
            }
            if (left <= Clock::duration(0)) {
                co_return Error{ErrorCode::Timeout,
                                "the master at " + address + " does not answer"};
            }
        }
    }

    /// Waits until the send queue has room. Errors: Interrupted.
    asio::awaitable<Status> make_room() {
        if (is_stopped()) {
            co_return interrupted();
        }
        co_await channel->wait_until_queued_below(limits::client_write_queue_bytes_max);
        if (is_stopped()) {
            co_return interrupted();
        }
        co_return Done{};
    }

    template <class T>
    asio::awaitable<Result<T>> answer(Clock::duration timeout) {
        Result<Message> message = co_await receive(timeout);
        while (message && cluster_statuses_due != 0 &&
               std::holds_alternative<ClusterStatus>(message.value())) {
            --cluster_statuses_due;
            message = co_await receive(timeout);
        }
        if (!message) {
            co_return message.error();
        }
        if (auto* expected = std::get_if<T>(&message.value())) {
            co_return std::move(*expected);
        }
        if (const auto* failure = std::get_if<Failure>(&message.value())) {
            co_return Error{failure->code, failure->detail};
        }
        co_return Error{ErrorCode::BadFrame,
                        "the master at " + address + " answers something else"};
    }

    template <class T>
    asio::awaitable<Result<T>> ask(Message question) {
        channel->send(question);
        co_return co_await answer<T>(timing::answer_timeout);
    }

    asio::awaitable<Status> open(Target target) {
        Result<std::shared_ptr<Channel>> connected = co_await connect(std::move(target));
        if (!connected) {
            co_return connected.error();
        }
        channel = std::move(connected.value());
        const Result<Welcome> welcome = co_await greet(channel, make_hello());
        if (!welcome) {
            co_return welcome.error();
        }
        owner = welcome.value().owner;
        co_return Done{};
    }

    asio::awaitable<Status> upload(std::span<const NamedMesh> meshes,
                                   const UploadProgress& progress) {
        MeshesQuery query;
        for (const NamedMesh& mesh : meshes) {
            query.meshes.push_back(mesh.mesh->hash());
        }
        const auto missing = co_await ask<MeshesMissing>(query);
        if (!missing) {
            co_return missing.error();
        }
        std::set<Sha256> wanted(missing.value().meshes.begin(), missing.value().meshes.end());
        for (const NamedMesh& mesh : meshes) {
            if (wanted.erase(mesh.mesh->hash()) == 0) {
                continue;
            }
            if (Status status = co_await upload_one(mesh, progress); !status) {
                co_return status;
            }
        }
        co_return Done{};
    }

    asio::awaitable<Status> upload_one(const NamedMesh& mesh, const UploadProgress& progress) {
        const Bytes bytes = mesh.mesh->canonical_bytes();
        progress(mesh, 0, bytes.size());
        for (std::size_t offset = 0; offset < bytes.size(); offset += limits::mesh_piece_bytes) {
            if (Status status = co_await make_room(); !status) {
                co_return status;
            }
            const auto piece = std::span(bytes).subspan(
                offset, std::min(limits::mesh_piece_bytes, bytes.size() - offset));
            channel->send(MeshPart{mesh.mesh->hash(),
                                   escaped(mesh.name),
                                   bytes.size(),
                                   offset,
                                   Bytes(piece.begin(), piece.end())});
            progress(mesh, offset + piece.size(), bytes.size());
        }
        const auto stored = co_await answer<MeshStored>(timing::mesh_stored_timeout);
        if (!stored) {
            const std::string what = mesh.name + " (" +
                                     cell_text(static_cast<double>(bytes.size()), CellKind::Size) +
                                     ")";
            co_return stored.error().code == ErrorCode::Io ? no_room(what, stored.error())
                                                           : stored.error();
        }
        if (stored.value().mesh != mesh.mesh->hash()) {
            co_return Error{ErrorCode::BadFrame,
                            "the master confirms another mesh than it was sent"};
        }
        co_return Done{};
    }

    /// Reads the window of scenarios that begins at `first`, of which at most `left` exist. Reads
    /// it in pieces, to notice a stop between them.
    Result<std::vector<Scenario>>
    read_window(PoseSource& poses, std::uint64_t first, std::uint64_t left) const {
        std::vector<Scenario> window;
        const std::uint64_t size = std::min(left, limits::order_window_scenarios);
        while (window.size() < size) {
            if (is_stopped()) {
                return interrupted();
            }
            const auto piece = CD_TRY(poses.read(
                first + window.size(), std::min(limits::pose_run_scenarios, size - window.size())));
            window.insert(window.end(), piece.begin(), piece.end());
        }
        return window;
    }

    asio::awaitable<Result<JobId>>
    submit(Submit submit, PoseSource* poses, const PoseLabels& labels) {
        channel->send(submit);
        const std::vector<std::uint32_t> trees = mesh_numbers(submit);
        for (std::uint64_t sent = 0; poses != nullptr && sent < submit.scenarios;) {
            const auto window = read_window(*poses, sent, submit.scenarios - sent);
            if (!window) {
                co_return window.error();
            }
            for (Bytes& run : pack_in_order(window.value(), trees)) {
                if (const Status status = co_await make_room(); !status) {
                    co_return status.error();
                }
                const std::uint64_t count =
                    std::min(limits::pose_run_scenarios, submit.scenarios - sent);
                channel->send(PosesPart{std::move(run), labels.slice(sent, count)});
                sent += count;
            }
        }
        if (poses != nullptr) {
            channel->send(PosesEnd{});
        }
        const auto accepted = co_await answer<Accepted>(timing::mesh_stored_timeout);
        if (!accepted) {
            const std::string what = "the poses of " + counted(submit.scenarios, "scenario");
            co_return accepted.error().code == ErrorCode::Io ? no_room(what, accepted.error())
                                                             : accepted.error();
        }
        co_return accepted.value().job;
    }

    /// Watches a job to its end. Since the master may send no status of the job for a long time,
    /// the client asks for the cluster's status after each silence and, if `looked` is set,
    /// periodically. A query without an answer reveals a dead master.
    asio::awaitable<Result<JobStatus>>
    watch(JobId job,
          const std::function<void(const JobStatus&)>& changed,
          const std::function<void(const ClusterStatus&)>& looked) {
        channel->send(Watch{job});
        auto heard = Clock::now();
        auto asked = heard;
        const auto look = [&] {
            channel->send(StatusQuery{});
            ++cluster_statuses_due;
        };
        if (looked) {
            look();
        }
        while (true) {
            const Result<Message> message =
                co_await receive(looked ? timing::watch_look_period : timing::answer_timeout);
            const auto now = Clock::now();
            if (!message && (message.error().code != ErrorCode::Timeout ||
                             now - heard > 2 * timing::answer_timeout)) {
                co_return message.error();
            }
            if (!message || (looked && now - asked > timing::watch_look_period_going_on)) {
                look();
                asked = now;
            }
            if (!message) {
                continue;
            }
            heard = now;
            if (const auto* cluster = std::get_if<ClusterStatus>(&message.value())) {
                cluster_statuses_due -= cluster_statuses_due == 0 ? 0 : 1;
                if (looked) {
                    looked(*cluster);
                }
                continue;
            }
            if (const auto* failure = std::get_if<Failure>(&message.value())) {
                co_return Error{failure->code, failure->detail};
            }
            const auto* status = std::get_if<JobStatus>(&message.value());
            if (status == nullptr) {
                continue;
            }
            changed(*status);
            if (status->state != JobState::Running) {
                co_return *status;
            }
        }
    }

    /// Cancels a job. Statuses that an interrupted `watch` requested may arrive before the answer
    /// to Cancel, so statuses of a running job are skipped.
    asio::awaitable<Result<JobStatus>> cancel(JobId job) {
        channel->send(Cancel{job});
        while (true) {
            Result<JobStatus> status = co_await answer<JobStatus>(timing::answer_timeout);
            if (!status || status.value().state != JobState::Running) {
                co_return status;
            }
        }
    }
};

Connection::Connection(std::unique_ptr<State> state) : state_(std::move(state)) {}

Connection::~Connection() {
    // A call that ended well has left no messages in the queue. The master drops this client when
    // the socket closes.
    if (state_->channel != nullptr) {
        state_->channel->close();
    }
    state_->context.restart();
    state_->context.poll();
}

Result<std::unique_ptr<Connection>> Connection::open(const std::string& address,
                                                     bool insecure,
                                                     std::function<bool()> stopped,
                                                     std::shared_ptr<const Tls> tls) {
    const Endpoint endpoint = CD_TRY(parse_endpoint(address));
    const Exposure exposure{tls != nullptr, insecure, false};
    CD_TRY(check_exposure(endpoint, exposure));
    auto state = std::make_unique<State>();
    state->address = address;
    state->is_tls = exposure.secured;
    state->stopped = std::move(stopped);
    CD_TRY(state->run(state->open({endpoint, std::move(tls)})));
    return std::unique_ptr<Connection>(new Connection(std::move(state)));
}

Status Connection::upload(std::span<const NamedMesh> meshes, const UploadProgress& progress) {
    return state_->run(state_->upload(meshes, progress));
}

Result<JobId> Connection::submit(const Submit& submit) {
    return state_->run(state_->submit(submit, nullptr, {}));
}

Result<JobId> Connection::submit(Submit submit, PoseSource& poses, const PoseLabels& labels) {
    submit.grid.reset();
    submit.scenarios = poses.count();
    submit.poses.labels = labels.columns();
    CD_CHECK(submit.poses.labels.fit(labels, submit.scenarios));
    return state_->run(state_->submit(std::move(submit), &poses, labels));
}

Result<JobStatus> Connection::watch(JobId job,
                                    const std::function<void(const JobStatus&)>& changed,
                                    const std::function<void(const ClusterStatus&)>& looked) {
    return state_->run(state_->watch(job, changed, looked));
}

Status Connection::fetch(JobId job,
                         std::uint64_t first,
                         std::uint64_t count,
                         const std::function<Status(const ScenarioResult&)>& take) {
    return fetch(ResultsQuery{job, first, count},
                 0,
                 [&](std::uint64_t, const ScenarioResult& result) { return take(result); });
}

Status Connection::fetch(const ResultsQuery& query,
                         std::uint64_t scenarios,
                         const std::function<Status(std::uint64_t, const ScenarioResult&)>& take) {
    const auto ask = [&](const ResultsQuery& next) {
        return state_->run(state_->ask<ResultsPart>(next));
    };
    return for_each_result(query, scenarios, ask, take);
}

Result<JobDescription> Connection::job_description(JobId job) {
    Result<JobDescription> described = state_->run(state_->ask<JobDescription>(JobQuery{job}));
    if (described && described.value().job != job) {
        return Error{ErrorCode::BadFrame, "the master describes another job than was asked for"};
    }
    return described;
}

Result<Mesh> Connection::fetch_mesh(const Sha256& mesh) {
    Bytes bytes;
    std::uint64_t total = 0;
    do {
        const auto part =
            CD_TRY(state_->run(state_->ask<MeshBytes>(MeshQuery{mesh, bytes.size()})));
        const MeshBytes& came = part;
        total = came.bytes_total;
        if (came.mesh != mesh || came.offset != bytes.size() || came.bytes.empty()) {
            return Error{ErrorCode::BadFrame, "the master sent another mesh than was asked for"};
        }
        bytes.insert(bytes.end(), came.bytes.begin(), came.bytes.end());
    } while (bytes.size() < total);
    if (sha256(bytes) != mesh) {
        return Error{ErrorCode::BadFrame, "the received mesh does not have the requested hash"};
    }
    return Mesh::from_canonical_bytes(bytes);
}

Result<LabelledScenarios>
Connection::fetch_poses(JobId job, std::uint64_t first, std::uint64_t count) {
    return fetch_poses(PosesQuery{job, first, count}, 0);
}

Result<LabelledScenarios> Connection::fetch_poses(const PosesQuery& query,
                                                  std::uint64_t scenarios) {
    LabelledScenarios all;
    while (all.scenarios.size() < query.count) {
        PosesQuery next = query;
        next.first += all.scenarios.size();
        next.count -= all.scenarios.size();
        const auto part = CD_TRY(state_->run(state_->ask<JobPoses>(next)));
        CD_TRY(take_poses(part, next, scenarios, all));
    }
    return all;
}

bool Connection::is_tls() const {
    return state_->is_tls;
}

const std::string& Connection::owner() const {
    return state_->owner;
}

Result<ContactMapAnswer> Connection::contact_map(const ContactMapQuery& query) {
    return state_->run(state_->ask<ContactMapAnswer>(query));
}

Result<ClusterStatus> Connection::status() {
    return state_->run(state_->ask<ClusterStatus>(StatusQuery{}));
}

Result<JobStatus> Connection::cancel(JobId job) {
    // Cancelling must work even after `stopped` has returned true.
    state_->heeds_stop = false;
    Result<JobStatus> status = state_->run(state_->cancel(job));
    state_->heeds_stop = true;
    return status;
}

Result<JobStatus> Connection::cancel_scenario(JobId job, std::uint64_t scenario) {
    return state_->run(state_->ask<JobStatus>(Cancel{job, scenario}));
}

Result<JobStatus> Connection::set_priority(JobId job, std::int32_t priority) {
    return state_->run(state_->ask<JobStatus>(SetPriority{job, priority}));
}

Result<Removed> Connection::remove_job(JobId job, bool cancel) {
    return state_->run(state_->ask<Removed>(Remove{job, cancel}));
}

Result<Removed> Connection::remove_mesh(const Sha256& mesh) {
    return state_->run(state_->ask<Removed>(RemoveMesh{mesh}));
}

Result<Draining> Connection::drain(const DrainWorkers& wish) {
    return state_->run(state_->ask<Draining>(wish));
}

Result<Explained> Connection::explain(JobId job, std::uint64_t scenario) {
    return state_->run(state_->ask<Explained>(Explain{job, scenario}));
}

Result<TokenCreated> Connection::create_token(const TokenCreate& terms) {
    return state_->run(state_->ask<TokenCreated>(terms));
}

Status Connection::pause(std::chrono::milliseconds time) {
    const auto end = Clock::now() + time;
    while (Clock::now() < end) {
        if (state_->is_stopped()) {
            return interrupted();
        }
        state_->context.restart();
        asio::steady_timer timer(
            state_->context,
            std::min<Clock::duration>(timing::stop_check_period, end - Clock::now()));
        bool is_over = false;
        timer.async_wait([&is_over](const boost::system::error_code&) { is_over = true; });
        // Runs handlers only until the timer fires; `run` would also wait for the deadlines of the
        // channel, which may be far away.
        while (!is_over) {
            state_->context.run_one();
        }
    }
    return Done{};
}

bool is_of_the_network(const Error& error) {
    return error.code == ErrorCode::Disconnected || error.code == ErrorCode::Timeout ||
           error.code == ErrorCode::BadFrame;
}

} // namespace cd
