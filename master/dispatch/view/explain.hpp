// Explains how a job's policy would place a scenario.
#pragma once

#include "master/dispatch/policy/matching_policy.hpp"
#include "proto/messages/client_messages.hpp"

namespace cd {

/// Scores every worker for the scenario in the present state, and names the worker that would be
/// chosen. Changes nothing.
[[nodiscard]] Explained explain_choice(const MatchingContext& context,
                                       const DispatchJob& job,
                                       const AnalysedScenario& analysed);

} // namespace cd
