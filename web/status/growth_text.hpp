// Tells how much more workers would help.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace cd {

/// Returns a line with newline: how many more workers are worth it, and by how much. Empty if
/// nothing is known.
[[nodiscard]] std::string growth_text(const std::optional<Growth>& growth);
/// Returns the estimate for each number of more workers, as time left and as a factor of speed;
/// null if nothing is known.
[[nodiscard]] nlohmann::ordered_json growth_json(const std::optional<Growth>& growth);

} // namespace cd
