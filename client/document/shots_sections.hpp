// What a report says of shot lines: a table of the parts that they cross, and pictures of how thick
// the bodies are.
#pragma once

#include "client/document/html.hpp"
#include "client/export/shots/shot_sums.hpp"
#include "client/export/shots/thickness_pictures.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cd {

/// The sections of a run that lists the hits of lines.
class ShotsSections {
  public:
    /// Reads all records of the run of a job with lines. Errors: Io; Interrupted.
    [[nodiscard]] static Result<ShotsSections>
    read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop);

    /// Returns the table of parts; those that most lines cross come first.
    [[nodiscard]] Html parts() const;
    /// Returns the pictures of the first directions; empty for lines of a file.
    [[nodiscard]] Html pictures() const;

  private:
    ShotsSections() = default;

    /// A picture and what is below it.
    struct View {
        std::string png;
        std::string caption;
    };

    [[nodiscard]] std::string length(double value) const;

    std::string unit_;
    std::vector<ShotPart> parts_;
    std::vector<View> views_;
    std::size_t directions_ = 0;
    bool is_scene_ = false;
};

/// Writes a large picture of the thickness in each of the first 64 directions into a folder, such
/// as `thickness-az30-el-15.png` of azimuth 30 and elevation -15 degrees; none for lines of a file.
/// A line is a square of pixels. Errors: Io; Interrupted.
[[nodiscard]] Status write_thickness_pictures(const std::filesystem::path& folder,
                                              const RecordFile& records,
                                              const PreparedJob& job,
                                              const StopCheck& stop);

} // namespace cd
