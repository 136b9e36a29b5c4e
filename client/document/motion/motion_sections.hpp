// What a report says of motions: their time lines, the first contact or the way out, and what stays
// open.
#pragma once

#include "client/document/html.hpp"
#include "client/document/motion/time_strip.hpp"
#include "client/document/run_names.hpp"
#include "client/export/motion_times.hpp"
#include "client/job/prepared_job.hpp"
#include "client/report/first_event.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// The sections of a run of motions. Memory: the lines that are shown.
class MotionSections {
  public:
    /// At most so many motions have a line.
    static constexpr std::size_t lines_max = 200;

    /// Reads all records of the run of a job with motions. Errors: Io; from reading poses;
    /// Interrupted.
    [[nodiscard]] static Result<MotionSections>
    read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop);

    /// Returns one sentence about the first contact or the first way out, and one about what stays
    /// open, if anything does. `names` are those of the run.
    [[nodiscard]] std::string verdict(const RunNames& names) const;
    /// Returns the section with the time lines, in a table: of all motions, or if they are many of
    /// the first that are not free throughout.
    [[nodiscard]] Html lines(const RunNames& names) const;
    /// Says what is proven of a motion of the run; empty if it failed.
    [[nodiscard]] std::string text(const ScenarioResult& result) const;

  private:
    MotionSections(const PreparedJob& job, MotionTimes times);

    /// A motion's line.
    struct Line {
        std::uint64_t scenario = 0;
        std::array<double, 2> span{}; ///< The motion's begin and end in the poses' time.
        TimeStrip strip;
        std::string text;  ///< What is proven.
        std::string moved; ///< How far B's origin moves until it is free; or empty.
    };

    /// The undecided motion whose open parts are known least.
    struct Open {
        std::uint64_t scenario = 0;
        double bound = 0; ///< May be infinite.
    };

    [[nodiscard]] Status add(const ScenarioResult& result, const PreparedJob& job);
    [[nodiscard]] Result<std::string> moved_text(const ScenarioResult& result,
                                                 const PreparedJob& job) const;
    [[nodiscard]] std::string open_text(const RunNames& names) const;
    [[nodiscard]] std::string about() const;

    std::string unit_;
    std::optional<Until> until_; ///< What is asked of each motion.
    bool shows_all_;             ///< Motions without an event have lines, too.
    MotionTimes times_;
    std::uint64_t motions_ = 0; ///< That did not fail.
    std::uint64_t told_ = 0;    ///< Of these, those that lines may tell of.
    std::uint64_t undecided_ = 0;
    std::optional<FirstEvent> first_;
    std::optional<Open> open_;
    std::vector<Line> lines_;
};

} // namespace cd
