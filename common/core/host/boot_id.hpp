// Tells whether two programs run on the same host.
#pragma once

#include <cstdint>

namespace cd {

/// Returns a number of the running kernel: a hash of Linux's random boot id. Programs on one host
/// have the same one, also in containers. Returns 0 if the kernel does not tell it.
[[nodiscard]] std::uint64_t boot_id();

} // namespace cd
