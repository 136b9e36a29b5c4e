#include "client/commands/doctor/own_checks.hpp"

#include "client/trees/tree_cache.hpp"
#include "common/core/host/memory_limit.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/words.hpp"
#include "web/status/table.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace cd {

namespace {

namespace fs = std::filesystem;
using Grade = Finding::Grade;

/// Below this, a large mesh may not fit.
constexpr std::uint64_t free_memory_min = 1u << 30;

/// Returns why no file can be written into the folder or, if it does not exist, why it cannot be
/// made; empty if nothing is in the way.
std::string obstacle_to_writing(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder != folder.parent_path()) {
        if (error && error != std::errc::not_a_directory) {
            return error.message();
        }
        folder = folder.parent_path();
    }
    if (!fs::is_directory(folder, error)) {
        return folder.string() + " is no folder";
    }
    return ::access(folder.c_str(), W_OK | X_OK) == 0
               ? ""
               : std::error_code(errno, std::generic_category()).message();
}

} // namespace

std::uint64_t free_memory() {
    std::ifstream file("/proc/meminfo");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string key;
        std::uint64_t kilobytes = 0;
        if (words >> key >> kilobytes && key == "MemAvailable:") {
            return std::min(kilobytes << 10, memory_limit());
        }
    }
    return 0;
}

Finding machine_finding(const MachineFacts& facts) {
    Finding finding{
        Grade::Ok, "this machine", facts.target + ", " + counted(facts.threads, "thread")};
    if (facts.free_bytes != 0) {
        finding.text += ", " + cell_text(facts.free_bytes, CellKind::Size) + " free memory";
        if (facts.free_bytes < free_memory_min) {
            finding.grade = Grade::Warn;
            finding.text += ": large meshes may not fit";
        }
    }
    if (!facts.simd) {
        finding.grade = Grade::Fail;
        finding.text = facts.simd.error().detail;
    }
    return finding;
}

Finding tree_cache_finding(const fs::path& folder) {
    Finding finding{Grade::Ok, "tree cache", "off: each run builds its trees"};
    if (folder.empty()) {
        return finding;
    }
    finding.text = folder.string() + ", " + cell_text(kept_tree_bytes(folder), CellKind::Size) +
                   " of " + cell_text(limits::tree_cache_bytes_max, CellKind::Size);
    if (const std::string why = obstacle_to_writing(folder); !why.empty()) {
        finding.grade = Grade::Warn;
        finding.text = folder.string() + " cannot be written (" + why +
                       "), so each run builds its trees; --tree-cache names another folder";
    }
    return finding;
}

Finding credential_finding(const Result<std::optional<Identity>>& identity,
                           std::chrono::system_clock::time_point now) {
    Finding finding{Grade::Ok, "credential", ""};
    if (!identity) {
        finding.grade = Grade::Fail;
        finding.text = identity.error().detail;
        return finding;
    }
    if (!identity.value()) {
        finding.text = "none, which suits a master without TLS";
        return finding;
    }
    const auto seconds = [&](WallTime time) {
        return std::chrono::duration_cast<std::chrono::seconds>(time - now);
    };
    const std::chrono::seconds left = seconds(identity.value()->until);
    const std::chrono::seconds until_valid = seconds(identity.value()->from);
    if (left.count() <= 0) {
        finding.grade = Grade::Fail;
        finding.text = "ended " + lasting(-left) + " ago; `cdctl join` gets another";
    } else if (until_valid.count() > 0) {
        finding.grade = Grade::Fail;
        finding.text = "valid only in " + lasting(until_valid) + ": is this machine's clock right?";
    } else {
        finding.grade = left < timing::doctor_certificate_left_min ? Grade::Warn : Grade::Ok;
        finding.text = "good for " + lasting(left) + "; it renews when cdctl is used";
    }
    return finding;
}

std::string lasting(std::chrono::seconds time) {
    constexpr std::array<std::pair<std::int64_t, const char*>, 3> units{
        {{86400, "day"}, {3600, "hour"}, {60, "minute"}}};
    const std::int64_t seconds = std::max<std::int64_t>(0, time.count());
    for (const auto& [unit, name] : units) {
        if (seconds >= unit) {
            return counted(static_cast<std::uint64_t>(seconds / unit), name);
        }
    }
    return counted(static_cast<std::uint64_t>(seconds), "second");
}

} // namespace cd
