#include "master/net/client_session.hpp"

#include "common/core/errors.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/master.hpp"
#include "common/job/result/packed_records.hpp"
#include "master/base/run_on.hpp"
#include "master/identity/identity.hpp"
#include "master/net/answers.hpp"
#include "master/net/job_removal.hpp"
#include "master/net/job_requests.hpp"
#include "master/net/worker_dismissal.hpp"
#include "master/page/state_sizes.hpp"
#include "master/submission/submission.hpp"
#include "proto/codec/codec.hpp"

namespace cd {

namespace {

/// Returns the error for the client when the disk could not store its data. An Io error goes to the
/// log; the client gets a text without paths.
Error without_room(const Error& why, const std::string& what, std::uint64_t bytes) {
    if (why.code != ErrorCode::Io) {
        return why;
    }
    log_error("no room: for=\"{}\" bytes={} error=\"{}\"", what, bytes, why.detail);
    return {ErrorCode::Io, "its disk is full or cannot be written; its log says why"};
}

} // namespace

ClientSession::ClientSession(Coordinator& coordinator,
                             std::shared_ptr<Channel> channel,
                             Access access,
                             ClientQuota quota)
    : coordinator_(coordinator),
      channel_(std::move(channel)),
      access_(std::move(access)),
      quota_(std::move(quota)),
      queries_(coordinator.parts().journal, *coordinator.parts().store) {}

asio::awaitable<void> ClientSession::run() {
    const auto self = shared_from_this();
    co_await converse();
    drop_upload();
    drop_poses();
    // A channel that is closing after its last message is no longer open.
    if (channel_->is_open()) {
        channel_->close();
    }
}

asio::awaitable<void> ClientSession::converse() {
    for (;;) {
        Result<Message> message = co_await receive();
        if (!message) {
            const ErrorCode code = message.error().code;
            const bool is_wrong = code == ErrorCode::BadFrame || code == ErrorCode::TooLarge;
            log_at(is_wrong ? LogLevel::Warning : LogLevel::Debug,
                   "client left: peer={} reason=\"{}\"",
                   channel_->peer(),
                   message.error().detail);
            break;
        }
        if (const Status allowed = access_.check(message.value()); !allowed) {
            refuse(allowed.error());
            channel_->close(true);
            break;
        }
        co_await std::visit([this](auto& content) { return on(std::move(content)); },
                            message.value());
        // Waits while the client does not read its answers.
        co_await channel_->wait_until_queued_below(limits::write_queue_bytes_max);
    }
}

asio::awaitable<Result<Message>> ClientSession::receive() {
    const bool is_submitting = upload_ != nullptr || spool_ != nullptr;
    if (!is_submitting) {
        co_return co_await channel_->receive(timing::client_idle_max);
    }
    // The time limit counts from the last part of the upload: other messages do not extend it.
    const auto left = progressed_ + quota_.submission_idle_max - std::chrono::steady_clock::now();
    Result<Message> message = Error{ErrorCode::Timeout, "nothing was received in time"};
    if (left > std::chrono::steady_clock::duration::zero()) {
        message = co_await channel_->receive(left);
    }
    if (!message && message.error().code == ErrorCode::Timeout && channel_->is_open()) {
        refuse({ErrorCode::Timeout, "an upload of a mesh or of poses stopped before its end"});
        channel_->close(true);
    }
    co_return message;
}

void ClientSession::refuse(const Error& error) {
    log_info("request refused: peer={} reason=\"{}\"", channel_->peer(), error.detail);
    channel_->send(Failure{error.code, error.detail});
}

template <class Answer>
void ClientSession::answer(const Result<Answer>& found) {
    if (found) {
        channel_->send(found.value());
    } else {
        refuse(found.error());
    }
}

Status ClientSession::check_owner(JobId job) {
    const Result<JobStatus> status = coordinator_.jobs().status(job);
    return status ? access_.check_owner(status.value().turn.owner) : Status(status.error());
}

template <class Other>
asio::awaitable<void> ClientSession::on(Other message) {
    const std::string name(message_name(message_type(message)));
    refuse({ErrorCode::BadFrame, "a client does not send '" + name + "'"});
    channel_->close(true);
    co_return;
}

asio::awaitable<void> ClientSession::on(Heartbeat /*message*/) {
    co_return;
}

// ---- Meshes -------------------------------------------------------------------------------------

asio::awaitable<void> ClientSession::on(MeshesQuery message) {
    meshes_asked_for_ = coordinator_.parts().store->hold(message.meshes);
    channel_->send(MeshesMissing{coordinator_.parts().store->missing(message.meshes)});
    co_return;
}

asio::awaitable<void> ClientSession::on(MeshPart message) {
    const Sha256 mesh = message.mesh;
    const bool is_last = message.offset + message.bytes.size() == message.bytes_total;
    const bool is_begun = upload_ != nullptr && upload_->mesh() == mesh;
    if (message.offset != 0 && !is_begun) {
        // The upload has failed, and the client has got the error already.
        co_return;
    }
    const std::string name = message.name;
    const std::uint64_t bytes = message.bytes_total;
    const Status taken = co_await take_mesh_part(std::move(message));
    if (!taken) {
        drop_upload();
        refuse(without_room(taken.error(), "'" + escaped(name) + "'", bytes));
    } else if (is_last) {
        channel_->send(MeshStored{mesh});
    }
}

Status ClientSession::take_bytes(std::uint64_t bytes) {
    return quota_.quotas->take_bytes(quota_.client, bytes, std::chrono::steady_clock::now());
}

Status ClientSession::begin_upload(MeshPart& part) {
    drop_upload(); // Deletes the file of an earlier, unfinished upload.
    if (Status allowed = quota_.quotas->begin_upload(quota_.client); !allowed) {
        return allowed;
    }
    part.name.resize(std::min(part.name.size(), limits::hello_text_bytes_max));
    auto begun = coordinator_.parts().store->begin_upload(part.mesh, part.name, part.bytes_total);
    if (!begun) {
        quota_.quotas->end_upload(quota_.client);
        return begun.error();
    }
    upload_ = std::move(begun.value());
    return Done{};
}

void ClientSession::drop_upload() {
    if (upload_ != nullptr) {
        upload_.reset();
        quota_.quotas->end_upload(quota_.client);
    }
}

asio::awaitable<Status> ClientSession::take_mesh_part(MeshPart message) {
    if (const Status taken = take_bytes(message.bytes.size()); !taken) {
        co_return taken;
    }
    if (!is_printable(message.name)) {
        co_return Error{ErrorCode::BadInput, "the mesh's name is not printable"};
    }
    if (message.offset == 0) {
        if (const Status begun = begin_upload(message); !begun) {
            co_return begun;
        }
    }
    auto append = [this, &message] { return upload_->append(message.offset, message.bytes); };
    Status status = co_await run_on(coordinator_.parts().blocking, append);
    if (status && upload_->is_complete()) {
        auto finish = [this, store = coordinator_.parts().store] {
            return store->finish_upload(std::move(upload_));
        };
        status = co_await run_on(coordinator_.parts().blocking, finish);
        quota_.quotas->end_upload(quota_.client);
    }
    progressed_ = std::chrono::steady_clock::now();
    co_return status;
}

// ---- Submitting ---------------------------------------------------------------------------------

Status ClientSession::queue_bytes(std::uint64_t bytes) {
    if (Status queued = quota_.quotas->queue(quota_.client, bytes); !queued) {
        return queued;
    }
    queued_ += bytes;
    return take_bytes(bytes);
}

void ClientSession::drop_poses() {
    spool_.reset();
    meshes_submitted_.reset();
    quota_.quotas->unqueue(quota_.client, std::exchange(queued_, 0));
}

asio::awaitable<void> ClientSession::on(Submit message) {
    drop_poses();
    refused_ = false;
    message.owner = access_.owner();
    const bool poses_follow = !message.grid;
    Status begun = access_.check_priority(message.priority);
    if (begun) {
        begun = queue_bytes(bulk_bytes(message));
    }
    if (begun) {
        begun = co_await begin_poses(std::move(message));
    }
    if (!begun) {
        refuse(without_room(begun.error(), "the job's poses", queued_));
        drop_poses();
        refused_ = poses_follow;
    }
}

asio::awaitable<Status> ClientSession::begin_poses(Submit message) {
    meshes_submitted_ = coordinator_.parts().store->hold(meshes_of(message));
    const auto stored = coordinator_.parts().store->meshes();
    if (const Status checked = check_submission(message, stored); !checked) {
        co_return checked;
    }
    if (message.grid) {
        Result<Grid> grid = decode_grid(*message.grid);
        if (!grid) {
            co_return grid.error();
        }
        if (grid.value().count() != message.scenarios) {
            co_return Error{ErrorCode::BadInput,
                            "the grid has " + std::to_string(grid.value().count()) +
                                " scenarios, and " + std::to_string(message.scenarios) +
                                " were announced"};
        }
        co_await open_job(std::move(message), nullptr);
        drop_poses();
        co_return Done{};
    }
    auto spool = JobSpool::create(coordinator_.parts().directory, message);
    if (!spool) {
        co_return spool.error();
    }
    spool_ = std::move(spool.value());
    progressed_ = std::chrono::steady_clock::now();
    submit_ = std::move(message);
    co_return Done{};
}

asio::awaitable<void> ClientSession::on(PosesPart message) {
    if (refused_) {
        co_return;
    }
    if (spool_ == nullptr) {
        refuse_poses({ErrorCode::BadInput, "poses without a job before them"});
        co_return;
    }
    if (const Status taken = queue_bytes(bulk_bytes(message)); !taken) {
        refuse_poses(taken.error());
        co_return;
    }
    auto append = [spool = spool_, &message] { return spool->append(message); };
    const Status appended = co_await run_on(coordinator_.parts().blocking, append);
    progressed_ = std::chrono::steady_clock::now();
    if (!appended) {
        refuse_poses(without_room(appended.error(), "the job's poses", queued_));
    }
}

asio::awaitable<void> ClientSession::on(PosesEnd /*message*/) {
    const auto spool = std::exchange(spool_, nullptr);
    if (std::exchange(refused_, false)) {
        co_return;
    }
    if (spool == nullptr) {
        refuse({ErrorCode::BadInput, "the end of poses without a job before it"});
    } else if (!spool->poses()->is_complete()) {
        refuse({ErrorCode::BadInput,
                std::to_string(spool->poses()->count()) + " poses were received, but " +
                    std::to_string(submit_.scenarios) + " were announced"});
    } else {
        co_await open_job(std::move(submit_), spool);
    }
    drop_poses();
}

void ClientSession::refuse_poses(const Error& error) {
    drop_poses();
    refused_ = true;
    refuse(error);
}

asio::awaitable<void> ClientSession::open_job(Submit submit, std::shared_ptr<JobSpool> poses) {
    Quotas& quotas = *quota_.quotas;
    const std::uint64_t scenarios = submit.scenarios;
    if (const Status allowed = quotas.begin_job(quota_.client, scenarios); !allowed) {
        refuse(allowed.error());
        co_return;
    }
    JobRequests requests(coordinator_);
    const Result<JobId> job = co_await requests.open(std::move(submit), std::move(poses));
    if (job) {
        meshes_asked_for_.reset(); // Not needed any more: the job holds its meshes.
        quotas.add_job(quota_.client, job.value(), {scenarios, std::exchange(queued_, 0)});
        quota_.jobs_changed();
        channel_->send(Accepted{job.value()});
    } else {
        quotas.give_up_job(quota_.client, scenarios);
        refuse(job.error());
    }
}

// ---- Queries ------------------------------------------------------------------------------------

asio::awaitable<void> ClientSession::on(StatusQuery /*message*/) {
    auto measure = [state = coordinator_.parts().directory.parent_path()] {
        return measure_state(state);
    };
    const StateSizes sizes = co_await run_on(coordinator_.parts().blocking, measure);
    ClusterStatus status = coordinator_.jobs().cluster();
    status.sizes = sizes;
    channel_->send(fitting(std::move(status)));
}

asio::awaitable<void> ClientSession::on(TokenCreate message) {
    if (access_.identity() == nullptr) {
        refuse({ErrorCode::Refused,
                "this master speaks without TLS, and needs no tokens; `cdmaster init` makes it an "
                "identity"});
        co_return;
    }
    const Result<TokenCreated> token = access_.identity()->create_token(message);
    if (token) {
        log_info("token created: peer={} role={} uses={} seconds={}",
                 channel_->peer(),
                 to_text(message.role),
                 message.uses,
                 message.seconds);
        channel_->send(token.value());
    } else {
        refuse(token.error());
    }
}

asio::awaitable<void> ClientSession::on(JobQuery message) {
    auto read = [this, &message] { return queries_.description(message.job); };
    answer(co_await run_on(coordinator_.parts().blocking, read));
}

asio::awaitable<void> ClientSession::on(MeshQuery message) {
    auto read = [this, &message] { return queries_.mesh(message); };
    answer(co_await run_on(coordinator_.parts().blocking, read));
}

asio::awaitable<void> ClientSession::on(PosesQuery message) {
    auto read = [this, &message] { return queries_.poses(message); };
    answer(co_await run_on(coordinator_.parts().blocking, read));
}

asio::awaitable<void> ClientSession::on(Remove message) {
    if (const Status allowed = check_owner(message.job); !allowed) {
        refuse(allowed.error());
        co_return;
    }
    JobRemoval removal(coordinator_);
    answer(co_await removal.remove(message));
}

asio::awaitable<void> ClientSession::on(RemoveMesh message) {
    JobRemoval removal(coordinator_);
    answer(co_await removal.remove(message));
}

asio::awaitable<void> ClientSession::on(DrainWorkers message) {
    answer(dismiss_workers(coordinator_, std::move(message)));
    co_return;
}

asio::awaitable<void> ClientSession::on(Cancel message) {
    if (const Status allowed = check_owner(message.job); !allowed) {
        refuse(allowed.error());
        co_return;
    }
    JobRequests requests(coordinator_);
    if (message.scenario) {
        answer(co_await requests.cancel_scenario(message.job, *message.scenario));
    } else {
        answer(co_await requests.cancel(message.job));
    }
}

asio::awaitable<void> ClientSession::on(SetPriority message) {
    Status allowed = check_owner(message.job);
    if (allowed) {
        allowed = access_.check_priority(message.priority);
    }
    if (allowed) {
        allowed = check_priority(message.priority);
    }
    if (!allowed) {
        refuse(allowed.error());
        co_return;
    }
    JobRequests requests(coordinator_);
    answer(co_await requests.set_priority(message.job, message.priority));
}

asio::awaitable<void> ClientSession::on(ResultsQuery message) {
    const MasterJob* job = coordinator_.jobs().find(message.job);
    if (job == nullptr) {
        refuse(no_job());
        co_return;
    }
    auto read = [results = job->results,
                 message,
                 is_within_host = channel_->is_within_host()]() -> Result<ResultsPart> {
        ResultsPart part = CD_TRY(results->read(
            message.first, message.count, limits::results_part_bytes_target, message.sample));
        SentRecords sent = records_to_send(std::move(part.records), is_within_host);
        part.records = std::move(sent.bytes);
        part.are_packed = sent.are_packed;
        return part;
    };
    Result<ResultsPart> part = co_await run_on(coordinator_.parts().blocking, read);
    if (!part) {
        refuse(part.error());
        co_return;
    }
    part.value().job = message.job;
    channel_->send(part.value());
}

asio::awaitable<void> ClientSession::on(ContactMapQuery message) {
    const Result<ContactMapAnswer> map = coordinator_.jobs().contact_map(message);
    if (map) {
        channel_->send(fitting(map.value()));
    } else {
        refuse(map.error());
    }
    co_return;
}

asio::awaitable<void> ClientSession::on(Explain message) {
    JobRequests requests(coordinator_);
    const Result<Explained> explained = co_await requests.explain(message.job, message.scenario);
    if (explained) {
        channel_->send(fitting(explained.value()));
    } else {
        refuse(explained.error());
    }
}

asio::awaitable<void> ClientSession::on(Watch message) {
    if (watches_ >= limits::watches_max) {
        refuse({ErrorCode::Refused, "too many watches on one connection"});
        co_return;
    }
    ++watches_;
    spawn(coordinator_.parts().executor, "watch", watch(shared_from_this(), message.job));
}

asio::awaitable<void> ClientSession::watch(std::shared_ptr<ClientSession> self, JobId job) {
    const auto pause = std::make_shared<asio::steady_timer>(self->coordinator_.parts().executor);
    self->coordinator_.jobs().waits().notify(job, pause);
    std::optional<std::uint64_t> seen;
    while (self->channel_->is_open()) {
        const Result<JobStatus> status = self->coordinator_.jobs().status(job);
        const bool is_over = !status || status.value().state != JobState::Running;
        const MasterJob* found = self->coordinator_.jobs().find(job);
        const std::uint64_t changes = found == nullptr ? 0 : found->changes;
        if (is_over || seen != changes) {
            self->answer(status);
            seen = changes;
        }
        if (is_over) {
            break;
        }
        pause->expires_after(timing::watch_period);
        boost::system::error_code ignored;
        co_await pause->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        // Sends no updates while the client has not read the earlier ones.
        co_await self->channel_->wait_until_queued_below(limits::write_queue_bytes_max);
    }
    --self->watches_;
}

} // namespace cd
