// What a run tells a person: the lines before it, the progress, and the summary.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/topology.hpp"
#include "common/job/contact_map.hpp"
#include "common/job/merge.hpp"
#include "common/job/result.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/search_cost.hpp"
#include "proto/traffic.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// What is said of one body.
struct BodyLine {
    std::string name;
    std::string unit; ///< The job's.
    std::uint64_t triangles = 0;
    Vec3 size = Vec3::Zero();
    std::uint64_t parts = 0;
    Precision precision = Precision::Float;
    bool rounds_to_float = false; ///< As the job asks for it.
    std::optional<bool> closed;   ///< Where it is known.
};

[[nodiscard]] BodyLine
describe_body(const std::string& name, const std::string& unit, const Mesh& mesh);

/// The lines that stand before a run, each ended: bodies A and B, then the poses.
[[nodiscard]] std::string header_text(const BodyLine& a,
                                      const BodyLine& b,
                                      std::uint64_t scenarios,
                                      const std::string& poses);

/// A warning where the bodies' sizes differ by 25.4 or 1000 within 2 %: then one is likely to be in
/// another unit. Sizes are the diagonals of the boxes.
[[nodiscard]] std::optional<std::string> unit_warning(const BodyLine& a, const BodyLine& b);

/// In how many scenarios each part was touched. Fed with results of level pairs and above.
class PartTally {
  public:
    PartTally(const Mesh& a, const Mesh& b);

    void add(const ScenarioResult& result);

    struct Touched {
        std::string part;
        std::uint64_t scenarios = 0;
    };
    /// The most touched first; parts never touched are left out. Empty where neither body has more
    /// than one part.
    [[nodiscard]] std::vector<Touched> most_touched(std::size_t count) const;

  private:
    struct Body {
        std::vector<Part> parts;
        std::vector<std::uint64_t> scenarios; ///< A part's count.
        std::vector<std::uint64_t> last_seen; ///< 1 + the last scenario that touched it.
    };
    static void note(Body& body, std::uint32_t triangle, std::uint64_t stamp);

    Body a_;
    Body b_;
    std::uint64_t stamp_ = 0;
};

/// How a run went, for the lines after it.
struct RunReport {
    Summary summary;
    Level level = Level::Pairs;
    std::optional<Sha256> digest; ///< Nothing while scenarios are missing.
    double seconds = 0;
    JobStatistics statistics;
    std::optional<SearchCost> cost;       ///< Of this machine's searches; nothing on a cluster.
    std::optional<JobTraffic> traffic;    ///< Nothing where nothing travelled.
    std::optional<std::uint32_t> depth_a; ///< Where trees were cut for the cluster, if they were
    std::optional<std::uint32_t> depth_b; ///< and it is known.
    std::string where;                    ///< "2 threads", "2 workers"; may be empty.
    std::optional<ContactMap> map;        ///< Where one was asked for,
    std::string map_withdrawn;            ///< or why there is none.
    std::vector<PartTally::Touched> most_touched;
    std::string hint; ///< A line about poses that bring no contact; empty where there is none.
};

/// The lines after a run, each ended; with colours for a terminal that takes them.
[[nodiscard]] std::string summary_text(const RunReport& report, bool colours = false);

/// Of the subtrees that scenarios needed at workers, those that were there.
[[nodiscard]] double hit_share(const BlockTraffic& blocks);

/// How far a run is.
struct ProgressState {
    std::string name; ///< Of the job.
    Summary summary;
    double seconds = 0; ///< Since it began.
};

/// One line without its end; with a bar for a terminal.
[[nodiscard]] std::string progress_text(const ProgressState& state, bool with_bar);

/// Writes progress to stderr: a bar that is redrawn on a terminal, otherwise a line each 10 s.
class ProgressPrinter {
  public:
    enum class Style : std::uint8_t { Silent, Lines, Bar };

    /// Silent when quiet; a bar when stderr is a terminal that can redraw.
    [[nodiscard]] static Style style_for(bool quiet);

    explicit ProgressPrinter(Style style, std::FILE* stream = stderr)
        : style_(style), stream_(stream) {}
    ProgressPrinter(const ProgressPrinter&) = delete;
    ProgressPrinter& operator=(const ProgressPrinter&) = delete;
    /// Ends the line of a bar.
    ~ProgressPrinter();

    /// Prints where it is due, judged by `state.seconds`.
    void update(const ProgressState& state);
    /// Prints the last state and ends the line of a bar.
    void finish(const ProgressState& state);

  private:
    void draw(const ProgressState& state);

    Style style_;
    std::FILE* stream_;
    double next_seconds_ = 0;
    bool line_is_open_ = false;
};

/// True when what goes to the stream may be coloured: a terminal, and NO_COLOR is not set.
[[nodiscard]] bool colours_wanted(std::FILE* stream);

} // namespace cd
