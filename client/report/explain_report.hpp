// The report of `cdctl explain`: the score of each worker for a scenario.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

/// The report as lines for people, each with a newline; times are in milliseconds.
[[nodiscard]] std::string explained_text(const Explained& explained, const std::string& job);
[[nodiscard]] std::string explained_json(const Explained& explained, const std::string& job);

} // namespace cd
