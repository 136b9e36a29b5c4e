// Checks the hits of lines that a worker found.
#pragma once

#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "master/compute/result_check.hpp"
#include "master/compute/task_content.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Returns what is wrong with the hits of a decoded result to Question::Shots, whose lines and
/// triangles exist; null if nothing. No line has a depth beyond its length, or ranks that skip a
/// number; and where only first hits were asked for, each line has one, which crosses.
[[nodiscard]] const char* problem_of_hits(const JobMaterial& material,
                                          const ScenarioResult& result);

/// Returns how many of the results to Question::Shots surely have a crossing: lists of hits tell
/// it, and first hits all cross.
[[nodiscard]] std::uint64_t crossed_scenarios(const Query& query,
                                              std::span<const ScenarioResult> results);

/// Checks that a map of crossings can be that of the results: it counts each of them for a triangle
/// and for a line. Errors: BadFrame.
[[nodiscard]] Status
check_crossings(const Query& query, std::span<const ScenarioResult> results, const ContactMap& map);

} // namespace cd
