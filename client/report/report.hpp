// The text of a run for people: the header and the summary.
#pragma once

#include "client/groups/group_sum.hpp"
#include "client/report/first_event.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/topology.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/scene/step_index.hpp"
#include "common/search/search_cost.hpp"
#include "proto/messages/traffic.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// What the header of a run says about a body.
struct BodyLine {
    std::string name;
    std::string unit; ///< The job's unit.
    std::uint64_t triangles = 0;
    Vec3 size = Vec3::Zero();
    std::uint64_t parts = 0;
    std::optional<bool> closed;          ///< Nothing if unknown.
    std::vector<std::string> notes = {}; ///< How the file was interpreted, a line each.
};

[[nodiscard]] BodyLine
describe_body(const std::string& name, const std::string& unit, const Mesh& mesh);

/// Returns the header of a run, in lines with newlines: bodies A and B, then the poses.
[[nodiscard]] std::string header_text(const BodyLine& a,
                                      const BodyLine& b,
                                      std::uint64_t scenarios,
                                      const std::string& poses);

/// Returns a warning if the bodies' sizes differ by a factor of 25.4 or 1000 within 2 %: one is
/// then likely in another unit. A body's size is the diagonal of its box.
[[nodiscard]] std::optional<std::string> unit_warning(const BodyLine& a, const BodyLine& b);

/// Where the scenarios ran, and the time and traffic that they took.
struct RunExecution {
    std::string where;            ///< "2 threads", "2 workers"; may be empty.
    double prepare_seconds = 0;   ///< Time to read inputs and build trees; not in `seconds`.
    double seconds = 0;           ///< Time to run the scenarios.
    std::uint64_t resumed_at = 0; ///< Scenarios done by an earlier run.
    std::uint64_t fetched = 0;    ///< Number of results fetched from a master.
    std::uint64_t reused = 0;     ///< Number of results taken from an earlier run.
    /// Number of scenarios run; nothing: all except the first `resumed_at`.
    std::optional<std::uint64_t> ran;
    JobStatistics statistics;
    std::optional<SearchCost> cost;    ///< Cost measured on this machine; nothing on a cluster.
    std::optional<JobTraffic> traffic; ///< Nothing for a run on this machine.
    /// The distribution depth of each body's tree; empty if no tree was cut, or depths are unknown.
    std::vector<std::uint32_t> depths;
};

/// What the summary says about the results folder.
struct FolderNote {
    std::string summary_file;          ///< Path of summary.json; may be empty.
    bool inputs_are_too_large = false; ///< The folder has no copy of the inputs.
};

/// The scenario in which a run's bodies share no point and are least apart.
struct LeastDistance {
    double distance = 0; ///< In the world.
    std::uint64_t scenario = 0;
    std::string unit; ///< The job's unit.
};

/// Replaces `least` by the distance of the result, if that is less; `unit` is the job's.
inline void note_least(const ScenarioResult& result,
                       const std::string& unit,
                       std::optional<LeastDistance>& least) {
    if (result.nearest && (!least || result.nearest->distance < least->distance)) {
        least = LeastDistance{result.nearest->distance, result.index, unit};
    }
}

/// An episode (body_episodes.hpp) by the names of its bodies.
struct EpisodeFound {
    std::string body_a;
    std::string body_b;
    std::uint64_t first_step = 0;
    std::uint64_t last_step = 0;
    ScenarioClass worst = ScenarioClass::Contact;
};

/// What the results of a scene tell about its steps.
struct SceneFindings {
    std::uint64_t steps = 0;
    StepCoverage coverage; ///< Summed over all steps.
    std::uint64_t episodes = 0;
    std::optional<EpisodeFound> worst; ///< Of equally bad episodes, the one that ended first.
    /// The step of which `learned` lists the pairs in contact as rules, a line each, if the job
    /// asks.
    std::optional<std::uint64_t> learned_step;
    std::string learned;
};

/// What lines tell of a part of A.
struct ShotPart {
    std::string name;
    bool is_closed = false;      ///< Only closed parts have a thickness.
    std::uint64_t lines = 0;     ///< Number of lines that cross it, over all directions.
    std::uint64_t crossings = 0; ///< Number of times that they do.
    std::string unit = {};       ///< The job's unit, of the lengths below.
    /// The area that lines see, in the mean over all directions; nothing for lines of a file.
    std::optional<double> area = {};
    /// The mean and the largest thickness along a line; nothing if no line enters and leaves.
    std::optional<std::array<double, 2>> thickness = {};
};

/// What a run's results, all in all, tell.
struct RunFindings {
    std::vector<TouchedPart> most_touched; ///< Parts in most scenarios, by the listed pairs.
    /// With the question of the distance; of equal distances the first scenario.
    std::optional<LeastDistance> least;
    std::optional<SceneFindings> scene; ///< Of a job with many bodies.
    /// With hits of lines: the parts that most lines cross first.
    std::vector<ShotPart> shots = {};
    /// Of motions; of equal times the first scenario.
    std::optional<FirstEvent> first_event = {};
};

/// The outcome of a run, for the summary.
struct RunReport {
    Summary summary;
    Query query;                  ///< What the job asks; the ignored ranges may be missing.
    std::optional<Sha256> digest; ///< Nothing while scenarios are missing.
    RunExecution execution;
    RunFindings findings;
    std::optional<ContactMap> map; ///< The job's contact map, if there is one.
    std::string map_withdrawn;     ///< Why a map that was asked for is missing; or empty.
    std::string hint;              ///< A line about poses without contact; may be empty.
    FolderNote folder;
};

/// Options of the summary.
struct SummaryStyle {
    bool colours = false;    ///< Use colours of the terminal.
    bool statistics = false; ///< Include search cost and network traffic.
};

/// Returns the summary of a run, in lines with newlines.
[[nodiscard]] std::string summary_text(const RunReport& report, const SummaryStyle& style = {});
/// Returns the lines of the summary that also a quiet run prints.
[[nodiscard]] std::string warnings_text(const RunReport& report);

/// True if output to the stream may be coloured: it is a terminal, and NO_COLOR is not set.
[[nodiscard]] bool colours_wanted(std::FILE* stream);

} // namespace cd
