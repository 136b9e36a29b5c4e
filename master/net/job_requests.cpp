#include "master/net/job_requests.hpp"

#include "common/core/host/wall_clock.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/run_on.hpp"
#include "master/compute/placed_scenario.hpp"
#include "master/compute/search_effort.hpp"
#include "master/coordinator/coordinator.hpp"

#include <chrono>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// What is computed about one scenario of a running job.
struct Examined {
    Analysis analysis;
    std::optional<SearchEffort> effort;
};

Result<Examined> examined(const AnalysisInput& input, OrderedPoses& poses, std::uint64_t scenario) {
    const Result<PlacedScenario> read = read_one(poses, scenario);
    if (!read) {
        return read.error();
    }
    Analysis analysis = analyse(input, read.value().scenario);
    analysis.position = read.value().position;
    const auto until = std::chrono::steady_clock::now() + timing::explained_search_max;
    const auto effort = search_effort(
        input, analysis, [until] { return std::chrono::steady_clock::now() > until; });
    return Examined{std::move(analysis), effort};
}

} // namespace

asio::awaitable<Result<JobId>> JobRequests::open(Submit submit, std::shared_ptr<JobSpool> spool) {
    const Result<JobId> next = coordinator_.jobs().allot(submit.scenarios);
    if (!next) {
        co_return next.error();
    }
    const JobId id = next.value();
    std::shared_ptr<OrderedPoses> poses;
    if (spool != nullptr) {
        auto seal = [&coordinator = coordinator_, id, spool] {
            return spool->seal(
                coordinator.parts().journal, id, coordinator.parts().options.durability);
        };
        if (const Status sealed = co_await run_on(coordinator_.parts().blocking, seal); !sealed) {
            coordinator_.jobs().give_up(id);
            co_return sealed.error();
        }
        poses = std::make_shared<OrderedPoses>(spool->poses());
    } else {
        poses = std::make_shared<OrderedPoses>(decode_grid(*submit.grid).value());
    }
    auto results =
        ResultStore::create(coordinator_.parts().journal.results_path(id), id, submit.scenarios);
    const JobRecord record{id, std::move(submit), unix_seconds()};
    coordinator_.jobs().write(record);
    (void)co_await coordinator_.jobs().waits().wait(id);
    coordinator_.jobs().begin(record, std::move(results), std::move(poses));
    co_return id;
}

asio::awaitable<Result<JobStatus>> JobRequests::set_priority(JobId job, std::int32_t priority) {
    const Result<std::uint64_t> change = coordinator_.jobs().set_priority(job, priority);
    if (!change) {
        co_return change.error();
    }
    const auto until = JobWaits::Time::clock::now() + timing::cancel_wait_max;
    while (!coordinator_.jobs().is_durable(change.value())) {
        // Another event of the job ends the wait as well.
        const bool is_woken = co_await coordinator_.jobs().waits().wait(job, until);
        if (!is_woken) {
            co_return Error{ErrorCode::Io, "the new priority counts, but is not on the disk yet"};
        }
    }
    co_return coordinator_.jobs().status(job);
}

asio::awaitable<Result<JobStatus>> JobRequests::cancel(JobId job) {
    const Result<JobStatus> status = coordinator_.jobs().cancel(job);
    if (!status || status.value().state != JobState::Running) {
        co_return status;
    }
    // The job counts as running until its end is durable.
    const auto until = JobWaits::Time::clock::now() + timing::cancel_wait_max;
    (void)co_await coordinator_.jobs().waits().wait(job, until);
    co_return coordinator_.jobs().status(job);
}

asio::awaitable<Result<JobStatus>> JobRequests::cancel_scenario(JobId job, std::uint64_t scenario) {
    if (coordinator_.jobs().cancel_disputed(job, scenario)) {
        co_return coordinator_.jobs().status(job);
    }
    const auto poses = coordinator_.jobs().poses_of_unanswered(job, scenario);
    if (!poses) {
        co_return poses.error();
    }
    auto read = [&poses, scenario] { return read_one(*poses.value(), scenario); };
    const Result<PlacedScenario> pose = co_await run_on(coordinator_.parts().blocking, read);
    if (!pose) {
        co_return pose.error();
    }
    if (const Status done = coordinator_.jobs().cancel_scenario(job, pose.value()); !done) {
        co_return done.error();
    }
    co_return coordinator_.jobs().status(job);
}

asio::awaitable<Result<Explained>> JobRequests::explain(JobId job, std::uint64_t scenario) {
    const auto needed = coordinator_.jobs().explainer().needed(job, scenario);
    if (!needed) {
        co_return needed.error();
    }
    if (!needed.value()) {
        co_return coordinator_.jobs().explainer().explain(job, scenario, {});
    }
    auto run = [&needed, poses = coordinator_.jobs().find(job)->run->poses, scenario] {
        return examined(*needed.value(), *poses, scenario);
    };
    Result<Examined> found = co_await run_on(coordinator_.parts().blocking, run);
    if (!found) {
        co_return found.error();
    }
    auto explained =
        coordinator_.jobs().explainer().explain(job, scenario, std::move(found.value().analysis));
    if (explained) {
        explained.value().effort = found.value().effort;
    }
    co_return explained;
}

} // namespace cd
