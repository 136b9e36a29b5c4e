// The pictures of a report.
#pragma once

#include "client/job/prepared_job.hpp"
#include "client/picture/image.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/result.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cd {

/// Draws the pictures of a report: small ones into memory and, if wanted, large ones into a folder.
class ReportPictures {
  public:
    /// `folder` is the folder for large pictures; empty: none.
    explicit ReportPictures(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Draws the bodies, then the results' scenarios. Large pictures are NAME.png of a body, and
    /// N.png of scenario N. Errors: Io; from reading poses; Interrupted.
    [[nodiscard]] Status
    draw(const PreparedJob& job, const std::vector<ScenarioResult>& results, const StopCheck& stop);

    /// Returns the PNG file of each body; of an empty text, the report has no room for the picture.
    [[nodiscard]] const std::vector<std::string>& bodies() const { return bodies_; }
    /// Returns the PNG file of each result's scenario; empty texts as for `bodies`.
    [[nodiscard]] const std::vector<std::string>& scenarios() const { return scenarios_; }

  private:
    [[nodiscard]] Result<std::string> png_within_limit(const Image& image);

    std::filesystem::path folder_;
    std::vector<std::string> bodies_;
    std::vector<std::string> scenarios_;
    std::size_t bytes_ = 0; ///< Size of all pictures so far.
};

} // namespace cd
