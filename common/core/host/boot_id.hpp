// Identifies the running kernel, so that two programs can find out whether they share a host.
#pragma once

#include <cstdint>

namespace cd {

/// Returns a hash of the random id that Linux draws at each boot. All programs on one host get the
/// same value, also in containers. Returns 0 if the id cannot be read.
[[nodiscard]] std::uint64_t boot_id();

} // namespace cd
