// Size limit of result records in the journal.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Checks a record's size. Errors: TooLarge over `limits::result_record_bytes_max`, with a remedy.
[[nodiscard]] inline Status check_record_size(std::uint64_t scenario, std::uint64_t bytes) {
    if (bytes > limits::result_record_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "the result of scenario " + std::to_string(scenario) + " takes " +
                         std::to_string(bytes) + " bytes; at most " +
                         std::to_string(limits::result_record_bytes_max) +
                         " are allowed: ask for a lower level or set limit_pairs"};
    }
    return Done{};
}

} // namespace cd
