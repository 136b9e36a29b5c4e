// The verdict of a run in words.
#pragma once

#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"

#include <string>
#include <vector>

namespace cd {

/// Returns one sentence about whether contacts were found, and in how many scenarios. `clearance`
/// is that of the query with its unit, such as "0.005 m", or empty.
[[nodiscard]] std::string verdict_text(const Summary& summary, const std::string& clearance = "");

/// Returns one sentence about how many bundles of lines hit anything: `target` is "A", or in a
/// scene "a body".
[[nodiscard]] std::string shots_verdict_text(const Summary& summary, const std::string& target);

/// Returns a sentence for each thing that the run did not test, or did not list. `no_groups`
/// says why the groups are unknown, and is empty if they are known.
[[nodiscard]] std::vector<std::string>
untested_texts(const Summary& summary, const Query& query, const std::string& no_groups);

} // namespace cd
