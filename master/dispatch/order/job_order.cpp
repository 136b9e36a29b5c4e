#include "master/dispatch/order/job_order.hpp"

#include "common/core/check.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace cd {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

} // namespace

double JobOrder::Job::in_flight() const {
    return cost.value_or(1) * 1e-9 * static_cast<double>(in_flight_ns);
}

double JobOrder::Job::recent_until(double now) const {
    return recent * std::exp((recent_at - now) / timing::share_shown_seconds);
}

void JobOrder::open(JobId job, JobRank rank) {
    Job added;
    added.rank = std::move(rank);
    join_owner(added);
    const bool is_new = jobs_.try_emplace(job, std::move(added)).second;
    CD_CHECK(is_new);
}

void JobOrder::set_priority(JobId job, std::int32_t priority) {
    Job& moved = jobs_.at(job);
    if (moved.rank.priority != priority) {
        leave_owner(moved);
        moved.rank.priority = priority;
        join_owner(moved);
    }
}

void JobOrder::join_owner(Job& job) {
    Owner& owner = owner_of(job.rank);
    double least = unlimited;
    for (const auto& [id, other] : jobs_) {
        least = other.owner == &owner ? std::min(least, other.used()) : least;
    }
    job.owner = &owner;
    job.settled = least == unlimited ? 0 : least;
    owner.used += job.in_flight();
    ++owner.jobs;
}

void JobOrder::leave_owner(Job& job) {
    job.owner->used -= job.in_flight();
    if (--job.owner->jobs == 0) {
        owners_.erase({job.rank.priority, job.rank.owner});
    }
    job.owner = nullptr;
}

JobOrder::Owner& JobOrder::owner_of(const JobRank& rank) {
    double least = unlimited;
    for (const auto& [key, owner] : owners_) {
        least = key.first == rank.priority ? std::min(least, owner.used) : least;
    }
    const Owner level{least == unlimited ? 0 : least, 0};
    return owners_.try_emplace(OwnerKey(rank.priority, rank.owner), level).first->second;
}

void JobOrder::close(JobId job) {
    const auto found = jobs_.find(job);
    CD_CHECK(found != jobs_.end());
    leave_owner(found->second);
    jobs_.erase(found);
}

bool JobOrder::comes_before(JobId one, JobId other) const {
    const Job& first = jobs_.at(one);
    const Job& second = jobs_.at(other);
    if (first.rank.priority != second.rank.priority) {
        return first.rank.priority > second.rank.priority;
    }
    if (first.owner != second.owner) {
        return std::tie(first.owner->used, first.rank.owner) <
               std::tie(second.owner->used, second.rank.owner);
    }
    return std::tuple(first.used(), one) < std::tuple(second.used(), other);
}

void JobOrder::sent(JobId job, std::uint64_t predicted_ns) {
    if (Job* found = find(job)) {
        charge(*found, [&](Job& to) { to.in_flight_ns += predicted_ns; });
        limit_credit(*found);
    }
}

void JobOrder::left(JobId job, std::uint64_t predicted_ns) {
    if (Job* found = find(job)) {
        charge(*found, [&](Job& from) {
            CD_CHECK(predicted_ns <= from.in_flight_ns);
            from.in_flight_ns -= predicted_ns;
        });
    }
}

void JobOrder::answered(JobId job, std::uint64_t predicted_ns, double busy_seconds, double now) {
    Job* found = find(job);
    if (found == nullptr) {
        return;
    }
    const double predicted = 1e-9 * static_cast<double>(predicted_ns);
    const double seconds = busy_seconds > 0 ? busy_seconds : found->cost.value_or(1) * predicted;
    charge(*found, [&](Job& to) {
        to.settled += seconds;
        if (busy_seconds > 0 && predicted > 0) {
            to.cost.add(busy_seconds, predicted);
        }
    });
    found->recent = found->recent_until(now) + seconds;
    found->recent_at = now;
    limit_credit(*found);
}

double JobOrder::share(JobId job, double now) const {
    const auto found = jobs_.find(job);
    double all = 0;
    for (const auto& [id, other] : jobs_) {
        all += other.recent_until(now);
    }
    return found == jobs_.end() || all <= 0 ? 0 : found->second.recent_until(now) / all;
}

JobOrder::Job* JobOrder::find(JobId job) {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

template <class Change>
void JobOrder::charge(Job& job, const Change& change) {
    const double before = job.used();
    change(job);
    job.owner->used += job.used() - before;
}

void JobOrder::limit_credit(const Job& job) {
    const double credit =
        timing::share_credit_seconds * static_cast<double>(std::max<std::uint64_t>(threads_, 1));
    for (auto& [key, owner] : owners_) {
        if (key.first == job.rank.priority) {
            owner.used = std::max(owner.used, job.owner->used - credit);
        }
    }
    const double least = job.used() - credit;
    for (auto& [id, other] : jobs_) {
        if (other.owner == job.owner) {
            other.settled += std::max(0.0, least - other.used());
        }
    }
}

} // namespace cd
