// Answers of the page as JSON documents.
#pragma once

#include "web/server/page_values.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace cd {

[[nodiscard]] std::string origin_json(const PageOrigin& origin);
[[nodiscard]] std::string cluster_json(const ClusterView& cluster);
[[nodiscard]] std::string history_json(std::span<const HistorySample> samples);
[[nodiscard]] std::string jobs_json(std::span<const JobRow> jobs);
/// Tells what changes of a job while it runs, with the keys that `job_view_json` has for it.
[[nodiscard]] std::string progress_json(const JobRow& job);
[[nodiscard]] std::string job_view_json(const JobView& job);
[[nodiscard]] std::string scenario_json(std::uint64_t number, const ScenarioView& scenario);
[[nodiscard]] std::string part_names_json(std::span<const std::string> names);
[[nodiscard]] std::string next_json(const NextFound& next);
[[nodiscard]] std::string error_json(const std::string& text);

} // namespace cd
