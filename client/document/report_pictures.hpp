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

/// A body that a report shows in place of all that have its mesh.
struct ShownBody {
    std::size_t body = 0;
    std::size_t others = 0; ///< Number of further bodies that have the mesh.
};

/// Returns the bodies that a report shows: of a scene the first body of each mesh, else both.
[[nodiscard]] std::vector<ShownBody> shown_bodies(const PreparedJob& job);

/// Draws the small pictures in a report.
class ReportPictures {
  public:
    static constexpr std::size_t bodies_max = 100;

    /// Draws the bodies, then the results' scenarios. Errors: Io; from reading poses; Interrupted.
    [[nodiscard]] Status
    draw(const PreparedJob& job, const std::vector<ScenarioResult>& results, const StopCheck& stop);

    /// Returns the PNG file of each of the first `bodies_max` of the `shown_bodies`; of an empty
    /// text, the report has no room for the picture.
    [[nodiscard]] const std::vector<std::string>& bodies() const { return bodies_; }
    /// Returns the PNG file of each result's scenario; empty texts as for `bodies`.
    [[nodiscard]] const std::vector<std::string>& scenarios() const { return scenarios_; }

  private:
    [[nodiscard]] Result<std::string> png_within_limit(const Image& image);

    std::vector<std::string> bodies_;
    std::vector<std::string> scenarios_;
    std::size_t bytes_ = 0; ///< Size of all pictures so far.
};

/// Draws large pictures into a folder: a.png and b.png, of a scene body-N.png of each of the
/// `shown_bodies`, and N.png of scenario N. Errors: Io;
/// from reading poses; Interrupted.
[[nodiscard]] Status write_pictures(const std::filesystem::path& folder,
                                    const PreparedJob& job,
                                    const std::vector<ScenarioResult>& results,
                                    const StopCheck& stop);

} // namespace cd
