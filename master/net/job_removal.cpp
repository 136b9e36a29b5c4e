#include "master/net/job_removal.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/net/job_requests.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace cd {

namespace {

std::uint64_t bytes_in(const std::vector<std::filesystem::path>& files) {
    std::uint64_t bytes = 0;
    for (const auto& file : files) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(file, missing);
        bytes += missing ? 0 : size;
    }
    return bytes;
}

} // namespace

asio::awaitable<Result<JobStatus>> JobRemoval::ended(Remove wish) {
    Result<JobStatus> status = coordinator_.jobs().status(wish.job);
    if (!status || status.value().state != JobState::Running) {
        co_return status;
    }
    if (!wish.cancel) {
        co_return Error{ErrorCode::Refused, "it is running; with --cancel it is ended first"};
    }
    JobRequests requests(coordinator_);
    status = co_await requests.cancel(wish.job);
    if (status && status.value().state == JobState::Running) {
        co_return Error{ErrorCode::Io, "the end of the job was not written to the disk in time"};
    }
    co_return status;
}

asio::awaitable<Result<Removed>> JobRemoval::remove(Remove wish) {
    const Result<JobStatus> status = co_await ended(wish);
    if (!status) {
        co_return status.error();
    }
    const auto files = coordinator_.parts().journal.files_of(wish.job);
    auto measure = [files] { return bytes_in(files); };
    Removed removed;
    removed.bytes = co_await run_on(coordinator_.parts().blocking, measure);
    if (const Status forgotten = coordinator_.jobs().forget(wish.job); !forgotten) {
        co_return forgotten.error();
    }
    const auto until = JobWaits::Time::clock::now() + timing::cancel_wait_max;
    if (!co_await coordinator_.jobs().waits().wait(wish.job, until)) {
        co_return Error{ErrorCode::Io, "the removal was not written to the disk in time"};
    }
    for (const Sha256& mesh : status.value().bodies) {
        // An error is ignored: another job needs the mesh, or both bodies have one mesh.
        auto free = [store = coordinator_.parts().store, mesh] { return store->remove(mesh); };
        const Result<std::uint64_t> freed = co_await run_on(coordinator_.parts().blocking, free);
        removed.bytes += freed ? freed.value() : 0;
    }
    log_info("job removed: job={} bytes={}", wish.job.value, removed.bytes);
    co_return removed;
}

asio::awaitable<Result<Removed>> JobRemoval::remove(RemoveMesh wish) {
    auto free = [store = coordinator_.parts().store, mesh = wish.mesh] {
        return store->remove(mesh);
    };
    const Result<std::uint64_t> freed = co_await run_on(coordinator_.parts().blocking, free);
    if (!freed) {
        co_return freed.error();
    }
    log_info("mesh removed: mesh={} bytes={}", to_short_hex(wish.mesh), freed.value());
    co_return Removed{freed.value()};
}

} // namespace cd
