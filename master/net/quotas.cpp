#include "master/net/quotas.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cd {

namespace {

Error too_much(const std::string& client,
               const std::string& what,
               std::chrono::seconds retry_after = timing::retry_after) {
    return {ErrorCode::Refused,
            "busy: quota: " + client + " has " + what + "; retry after " +
                std::to_string(retry_after.count()) + " s"};
}

std::string of(std::uint64_t count, std::uint64_t limit, const std::string& what) {
    return std::to_string(count) + " " + what + ", of " + std::to_string(limit) + " that it may";
}

} // namespace

// ---- Connections, uploads and received bytes ----------------------------------------------------

Status Quotas::connect(const std::string& client) {
    // Bounds the number of entries, because a peer without a certificate can use many names. Names
    // with connections or jobs stay.
    if (clients_.size() >= limits::connections_max && !clients_.contains(client)) {
        for (auto& [name, entry] : clients_) {
            forget_ended(entry);
        }
        std::erase_if(clients_, [](const auto& entry) {
            return entry.second.connections == 0 && entry.second.jobs.empty() &&
                   entry.second.jobs_begun == 0;
        });
    }
    Client& entry = clients_[client];
    if (entry.connections >= limits_.connections) {
        return too_much(client, of(entry.connections, limits_.connections, "connections"));
    }
    if (connections_ >= limits_.all_connections) {
        return too_much("everybody", of(connections_, limits_.all_connections, "connections"));
    }
    ++entry.connections;
    ++connections_;
    return Done{};
}

void Quotas::disconnect(const std::string& client) {
    const auto found = clients_.find(client);
    if (found != clients_.end() && found->second.connections != 0) {
        --found->second.connections;
        --connections_;
    }
}

Status Quotas::take_bytes(const std::string& client, std::uint64_t bytes, Time now) {
    Client& entry = clients_[client];
    const double sum = bytes_now(entry, now) + static_cast<double>(bytes);
    const double excess = sum - static_cast<double>(limits_.bytes);
    if (excess > 0) {
        const double seconds = excess * static_cast<double>(limits_.period.count()) /
                               static_cast<double>(limits_.bytes);
        return too_much(client,
                        "sent " + of(static_cast<std::uint64_t>(sum), limits_.bytes, "bytes") +
                            " in " + std::to_string(limits_.period.count()) + " s",
                        std::chrono::seconds(1 + static_cast<std::int64_t>(seconds)));
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

Status Quotas::begin_upload(const std::string& client) {
    Client& entry = clients_[client];
    if (entry.uploads >= limits_.uploads) {
        return too_much(client, of(entry.uploads, limits_.uploads, "meshes begun"));
    }
    ++entry.uploads;
    return Done{};
}

void Quotas::end_upload(const std::string& client) {
    --clients_[client].uploads;
}

// ---- Jobs, and the bytes of their poses ---------------------------------------------------------

Status Quotas::queue(const std::string& client, std::uint64_t bytes) {
    Client& entry = clients_[client];
    const auto is_too_much = [&] {
        return bytes > limits_.queued || entry.queued > limits_.queued - bytes;
    };
    if (is_too_much()) {
        forget_ended(entry);
    }
    if (is_too_much()) {
        return too_much(client,
                        of(entry.queued + bytes, limits_.queued, "bytes of poses not yet done"));
    }
    entry.queued += bytes;
    return Done{};
}

void Quotas::unqueue(const std::string& client, std::uint64_t bytes) {
    clients_[client].queued -= bytes;
}

Status Quotas::begin_job(const std::string& client, std::uint64_t scenarios) {
    Client& entry = clients_[client];
    forget_ended(entry);
    const std::size_t jobs = entry.jobs.size() + entry.jobs_begun;
    if (jobs >= limits_.jobs) {
        return too_much(client, of(jobs, limits_.jobs, "jobs running"));
    }
    if (scenarios > limits_.scenarios || entry.scenarios > limits_.scenarios - scenarios) {
        return too_much(client,
                        of(entry.scenarios + scenarios, limits_.scenarios, "scenarios of jobs"));
    }
    ++entry.jobs_begun;
    entry.scenarios += scenarios;
    return Done{};
}

void Quotas::add_job(const std::string& client, JobId job, const JobSize& size) {
    Client& entry = clients_[client];
    --entry.jobs_begun;
    entry.jobs[job] = size;
}

void Quotas::give_up_job(const std::string& client, std::uint64_t scenarios) {
    --clients_[client].jobs_begun;
    clients_[client].scenarios -= scenarios;
}

void Quotas::forget_ended(Client& client) const {
    std::erase_if(client.jobs, [&](const auto& job) {
        if (scenarios_of_(job.first)) {
            return false;
        }
        client.queued -= job.second.bytes;
        client.scenarios -= job.second.scenarios;
        return true;
    });
}

// ---- Restart of the master ----------------------------------------------------------------------

std::string Quotas::jobs_text() {
    std::ostringstream out;
    for (auto& [name, client] : clients_) {
        forget_ended(client);
        for (const auto& [job, size] : client.jobs) {
            out << job.value << ' ' << size.bytes << ' ' << name << '\n';
        }
    }
    return out.str();
}

void Quotas::restore_jobs(std::string_view text) {
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        JobId job;
        JobSize size;
        std::string name;
        fields >> job.value >> size.bytes >> std::ws;
        if (!std::getline(fields, name)) {
            continue;
        }
        if (const auto scenarios = scenarios_of_(job)) {
            size.scenarios = *scenarios;
            Client& client = clients_[name];
            if (client.jobs.emplace(job, size).second) {
                client.queued += size.bytes;
                client.scenarios += size.scenarios;
            }
        }
    }
}

} // namespace cd
