// Measures what the search for the answer of one scenario takes, by running it on whole bodies.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "master/compute/analyser.hpp"
#include "proto/messages/client_messages.hpp"

#include <optional>

namespace cd {

/// Runs the analysed scenario of a motion or of a distance, which may take long. Returns nothing
/// for other questions, and if the run fails or `stop` ends it.
[[nodiscard]] std::optional<SearchEffort>
search_effort(const AnalysisInput& input, const Analysis& analysis, const StopCheck& stop);

} // namespace cd
