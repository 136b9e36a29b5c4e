// Reads the table [motion] of a job file.
#pragma once

#include "client/spec/toml_fields.hpp"
#include "common/job/query.hpp"

#include <array>
#include <string_view>

namespace cd {

/// The words of the key `until`, in the order of `Until`.
inline constexpr std::array<std::string_view, 3> until_words{"contact", "free", "end"};

[[nodiscard]] constexpr std::string_view to_text(Until until) {
    return until_words[static_cast<std::size_t>(until)];
}

/// Reads [motion], if the job has it, and refuses the tables that do not go together with it. Sets
/// the question and the motion of the query. Throws a `Refusal`.
void read_motion(const TomlFields& job, Query& query);

} // namespace cd
