// Checks of `cdctl doctor` on this machine: processor, memory, tree cache, credential.
#pragma once

#include "client/commands/doctor/finding.hpp"
#include "client/remote/membership.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace cd {

/// What decides how well this machine runs scenarios.
struct MachineFacts {
    Status simd = Done{}; ///< Whether CD_SIMD names a target of this machine.
    std::string target;   ///< The SIMD target in use.
    std::uint64_t threads = 1;
    std::uint64_t free_bytes = 0; ///< Memory that can be had; 0: unknown.
};

/// Returns how much memory this process can still get: at most what its control group allows.
/// 0 if /proc does not say it.
[[nodiscard]] std::uint64_t free_memory();

[[nodiscard]] Finding machine_finding(const MachineFacts& facts);

/// Looks at the folder of built trees without changing it. An empty path: there is none.
[[nodiscard]] Finding tree_cache_finding(const std::filesystem::path& folder);

/// Judges the holder and validity in the user's credential, if there is one, at a time.
[[nodiscard]] Finding credential_finding(const Result<std::optional<Identity>>& identity,
                                         std::chrono::system_clock::time_point now);

/// Returns a time in its largest fitting unit: "9 hours", "6 days".
[[nodiscard]] std::string lasting(std::chrono::seconds time);

} // namespace cd
