#include "master/client_session.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/printable.hpp"
#include "master/answers.hpp"
#include "master/identity.hpp"
#include "master/run_on.hpp"
#include "master/submission.hpp"
#include "proto/codec.hpp"

namespace cd {

ClientSession::ClientSession(Coordinator& coordinator,
                             std::shared_ptr<Channel> channel,
                             Access access,
                             ClientQuota quota)
    : coordinator_(coordinator),
      channel_(std::move(channel)),
      access_(std::move(access)),
      quota_(std::move(quota)) {}

asio::awaitable<void> ClientSession::run() {
    const auto self = shared_from_this();
    for (;;) {
        Result<Message> message = co_await channel_->receive(limits::client_idle_max);
        if (!message) {
            const ErrorCode code = message.error().code;
            const bool is_wrong = code == ErrorCode::BadFrame || code == ErrorCode::TooLarge;
            spdlog::log(is_wrong ? spdlog::level::warn : spdlog::level::debug,
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
        // Who does not read the answers is not asked for more questions.
        co_await channel_->wait_until_queued_below(limits::write_queue_bytes_max);
    }
    // One that is being flushed closes by itself.
    if (channel_->is_open()) {
        channel_->close();
    }
}

void ClientSession::refuse(const Error& error) {
    spdlog::info("request refused: peer={} reason=\"{}\"", channel_->peer(), error.detail);
    channel_->send(Failure{error.code, error.detail});
}

void ClientSession::answer(const Result<JobStatus>& status) {
    if (status) {
        channel_->send(status.value());
    } else {
        refuse(status.error());
    }
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
    channel_->send(MeshesMissing{coordinator_.geometry().missing(message.meshes)});
    co_return;
}

asio::awaitable<void> ClientSession::on(MeshPart message) {
    const Sha256 mesh = message.mesh;
    const bool is_last = message.offset + message.bytes.size() == message.bytes_total;
    const bool is_begun = upload_ != nullptr && upload_->mesh() == mesh;
    if (message.offset != 0 && !is_begun) {
        // The rest of an upload that failed: its failure has been answered.
        co_return;
    }
    const Status taken = co_await take_mesh_part(std::move(message));
    if (!taken) {
        upload_.reset();
        refuse(taken.error());
    } else if (is_last) {
        channel_->send(MeshStored{mesh});
    }
}

Status ClientSession::take_bytes(std::uint64_t bytes) {
    return quota_.quotas->take_bytes(quota_.client, bytes, std::chrono::steady_clock::now());
}

asio::awaitable<Status> ClientSession::take_mesh_part(MeshPart message) {
    if (const Status taken = take_bytes(message.bytes.size()); !taken) {
        co_return taken;
    }
    if (!is_printable(message.name)) {
        co_return Error{ErrorCode::BadInput, "the mesh's name has control characters in it"};
    }
    GeometryStore& store = coordinator_.geometry();
    if (message.offset == 0) {
        upload_.reset(); // One at a time; its temporary file goes.
        message.name.resize(std::min(message.name.size(), limits::hello_text_bytes_max));
        auto begun = store.begin_upload(message.mesh, message.name, message.bytes_total);
        if (!begun) {
            co_return begun.error();
        }
        upload_ = std::move(begun.value());
    }
    auto append = [this, &message] { return upload_->append(message.offset, message.bytes); };
    Status status = co_await run_on(coordinator_.blocking(), append);
    if (status && upload_->is_complete()) {
        auto finish = [this, &store] { return store.finish_upload(std::move(upload_)); };
        status = co_await run_on(coordinator_.blocking(), finish);
    }
    co_return status;
}

// ---- Submitting ---------------------------------------------------------------------------------

asio::awaitable<void> ClientSession::on(Submit message) {
    spool_.reset();
    refused_ = false;
    const bool poses_follow = !message.grid;
    const Status begun = co_await begin_poses(std::move(message));
    if (!begun) {
        refuse(begun.error());
        refused_ = poses_follow;
    }
}

asio::awaitable<Status> ClientSession::begin_poses(Submit message) {
    const auto stored = coordinator_.geometry().meshes();
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
        co_return Done{};
    }
    auto spool = PoseSpool::create(coordinator_.directory(), message.scenarios);
    if (!spool) {
        co_return spool.error();
    }
    spool_ = std::move(spool.value());
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
    if (const Status taken = take_bytes(message.scenarios.size()); !taken) {
        refuse_poses(taken.error());
        co_return;
    }
    auto append = [spool = spool_, &message] { return spool->append(message.scenarios); };
    const Status appended = co_await run_on(coordinator_.blocking(), append);
    if (!appended) {
        refuse_poses(appended.error());
    }
}

asio::awaitable<void> ClientSession::on(PosesEnd /*message*/) {
    const auto spool = std::exchange(spool_, nullptr);
    if (std::exchange(refused_, false)) {
        co_return;
    }
    if (spool == nullptr) {
        refuse({ErrorCode::BadInput, "the end of poses without a job before it"});
    } else if (!spool->is_complete()) {
        refuse({ErrorCode::BadInput,
                std::to_string(spool->count()) + " poses came, and " +
                    std::to_string(submit_.scenarios) + " were announced"});
    } else {
        co_await open_job(std::move(submit_), spool);
    }
}

void ClientSession::refuse_poses(const Error& error) {
    spool_.reset();
    refused_ = true;
    refuse(error);
}

asio::awaitable<void> ClientSession::open_job(Submit submit, std::shared_ptr<PoseSpool> poses) {
    const auto is_running = [this](JobId earlier) {
        const Result<JobStatus> status = coordinator_.job_status(earlier);
        return status && status.value().state == JobState::Running;
    };
    if (const Status allowed = quota_.quotas->check_jobs(quota_.client, is_running); !allowed) {
        refuse(allowed.error());
        co_return;
    }
    const Result<JobId> job = co_await coordinator_.open_job(std::move(submit), std::move(poses));
    if (job) {
        quota_.quotas->add_job(quota_.client, job.value());
        channel_->send(Accepted{job.value()});
    } else {
        refuse(job.error());
    }
}

// ---- Asking -------------------------------------------------------------------------------------

asio::awaitable<void> ClientSession::on(StatusQuery /*message*/) {
    channel_->send(fitting(coordinator_.cluster_status()));
    co_return;
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
        spdlog::info("token created: peer={} role={} uses={} seconds={}",
                     channel_->peer(),
                     to_text(message.role),
                     message.uses,
                     message.seconds);
        channel_->send(token.value());
    } else {
        refuse(token.error());
    }
}

asio::awaitable<void> ClientSession::on(Cancel message) {
    if (message.scenario) {
        answer(co_await coordinator_.cancel_scenario(message.job, *message.scenario));
    } else {
        answer(co_await coordinator_.cancel_job(message.job));
    }
}

asio::awaitable<void> ClientSession::on(ResultsQuery message) {
    const auto results = coordinator_.results_of(message.job);
    if (results == nullptr) {
        refuse(coordinator_.job_status(message.job).error());
        co_return;
    }
    auto read = [results, message] {
        return results->read(message.first, message.count, limits::results_part_bytes_target);
    };
    Result<ResultsPart> part = co_await run_on(coordinator_.blocking(), read);
    if (!part) {
        refuse(part.error());
        co_return;
    }
    part.value().job = message.job;
    channel_->send(part.value());
}

asio::awaitable<void> ClientSession::on(ContactMapQuery message) {
    const Result<ContactMapAnswer> map = coordinator_.contact_map(message.job);
    if (map) {
        channel_->send(fitting(map.value()));
    } else {
        refuse(map.error());
    }
    co_return;
}

asio::awaitable<void> ClientSession::on(Explain message) {
    const Result<Explained> explained =
        co_await coordinator_.explain(message.job, message.scenario);
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
    spawn(coordinator_.executor(), "watch", watch(shared_from_this(), message.job));
}

asio::awaitable<void> ClientSession::watch(std::shared_ptr<ClientSession> self, JobId job) {
    const auto pause = std::make_shared<asio::steady_timer>(self->coordinator_.executor());
    self->coordinator_.notify_at_end(job, pause);
    std::optional<std::uint64_t> seen;
    while (self->channel_->is_open()) {
        const Result<JobStatus> status = self->coordinator_.job_status(job);
        const bool is_over = !status || status.value().state != JobState::Running;
        const std::uint64_t changes = self->coordinator_.job_changes(job);
        if (is_over || seen != changes) {
            self->answer(status);
            seen = changes;
        }
        if (is_over) {
            break;
        }
        pause->expires_after(limits::watch_period);
        boost::system::error_code ignored;
        co_await pause->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        // A watcher that does not read misses what it could not have read in time.
        co_await self->channel_->wait_until_queued_below(limits::write_queue_bytes_max);
    }
    --self->watches_;
}

} // namespace cd
