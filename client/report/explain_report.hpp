// The report of `cdctl explain`: how each worker scores for a scenario.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

/// Returns the report for people, in lines with newlines; times are in milliseconds.
[[nodiscard]] std::string explained_text(const Explained& explained, const std::string& job);
[[nodiscard]] std::string explained_json(const Explained& explained, const std::string& job);

} // namespace cd
