// Decodes results that a master sends.
#pragma once

#include "common/core/result.hpp"
#include "common/job/result/result.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// Returns the results of scenarios [first, part.next) in order. `part` is untrusted; it must begin
/// at `first` and cover 1 to `count` scenarios. Errors: BadFrame if it does not; TooLarge.
[[nodiscard]] Result<std::vector<ScenarioResult>>
unpack_results(const ResultsPart& part, std::uint64_t first, std::uint64_t count);

} // namespace cd
