#include "proto/access/refusals.hpp"

#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"

#include <tuple>
#include <utility>

namespace cd {

std::optional<std::uint64_t> Refusals::admit(const std::string& host, Time now) {
    const auto is_due = [now](const Host& each) {
        return now - each.since >= timing::refusal_log_period;
    };
    auto known = hosts_.find(host);
    if (known == hosts_.end() && hosts_.size() >= limits::refusal_hosts_max) {
        std::erase_if(hosts_, [&](const auto& entry) { return is_due(entry.second); });
    }
    if (known == hosts_.end()) {
        const bool is_full = hosts_.size() >= limits::refusal_hosts_max;
        bool is_new = false;
        std::tie(known, is_new) = hosts_.try_emplace(is_full ? std::string() : host, Host{now, 1});
        if (is_new) {
            return 0;
        }
    }
    Host& entry = known->second;
    if (is_due(entry)) {
        entry.since = now;
        entry.lines = 1;
        return std::exchange(entry.left_out, 0);
    }
    if (entry.lines < limits::refusal_lines_max) {
        ++entry.lines;
        return 0;
    }
    ++entry.left_out;
    return std::nullopt;
}

void Refusals::log(LogLevel level,
                   const char* what,
                   const std::string& peer,
                   const std::string& reason) {
    const std::string host = peer.substr(0, peer.rfind(':'));
    const auto left_out = admit(host, std::chrono::steady_clock::now());
    if (!left_out) {
        return;
    }
    if (*left_out == 0) {
        log_at(level, "{}: peer={} reason=\"{}\"", what, peer, reason);
    } else {
        log_at(level, "{}: peer={} reason=\"{}\" left_out={}", what, peer, reason, *left_out);
    }
}

} // namespace cd
