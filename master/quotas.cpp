#include "master/quotas.hpp"

#include <algorithm>

namespace cd {

namespace {

Error too_much(const std::string& client, const std::string& what) {
    return {ErrorCode::Refused, "quota: " + client + " has " + what};
}

} // namespace

Status Quotas::connect(const std::string& client) {
    // Names are the peer's choice: more of them are not remembered than there may be connections.
    if (clients_.size() >= limits::connections_max && !clients_.contains(client)) {
        std::erase_if(clients_, [](const auto& entry) { return entry.second.connections == 0; });
    }
    Client& entry = clients_[client];
    if (entry.connections >= limits_.connections) {
        return too_much(client, std::to_string(entry.connections) + " connections");
    }
    ++entry.connections;
    return Done{};
}

void Quotas::disconnect(const std::string& client) {
    const auto found = clients_.find(client);
    if (found != clients_.end() && found->second.connections != 0) {
        --found->second.connections;
    }
}

Status Quotas::check_jobs(const std::string& client, const std::function<bool(JobId)>& is_running) {
    std::vector<JobId>& jobs = clients_[client].jobs;
    if (jobs.size() >= limits_.jobs) {
        std::erase_if(jobs, [&](JobId job) { return !is_running(job); });
    }
    if (jobs.size() >= limits_.jobs) {
        return too_much(client, std::to_string(jobs.size()) + " jobs running");
    }
    return Done{};
}

void Quotas::add_job(const std::string& client, JobId job) {
    clients_[client].jobs.push_back(job);
}

Status Quotas::take_bytes(const std::string& client, std::uint64_t bytes, Time now) {
    Client& entry = clients_[client];
    const double sum = bytes_now(entry, now) + static_cast<double>(bytes);
    if (sum > static_cast<double>(limits_.bytes)) {
        return too_much(client,
                        "sent " + std::to_string(static_cast<std::uint64_t>(sum)) +
                            " bytes of the " + std::to_string(limits_.bytes) + " that it may in " +
                            std::to_string(limits_.period.count()) + " s");
    }
    entry.bytes = sum;
    entry.since = now;
    return Done{};
}

double Quotas::bytes_now(const Client& client, Time now) const {
    const double passed = std::chrono::duration<double>(now - client.since).count();
    const double leaked =
        static_cast<double>(limits_.bytes) * passed / static_cast<double>(limits_.period.count());
    return std::max(0.0, client.bytes - leaked);
}

} // namespace cd
