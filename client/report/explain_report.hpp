// What `cdctl explain` shows: how each worker scores for a scenario.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

/// For people; times in milliseconds. Each line is ended.
[[nodiscard]] std::string explained_text(const Explained& explained, const std::string& job);
[[nodiscard]] std::string explained_json(const Explained& explained, const std::string& job);

} // namespace cd
