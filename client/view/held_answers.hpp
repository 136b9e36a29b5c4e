// What the page asks of its server to show some scenarios of a run.
#pragma once

#include "client/view/viewed_run.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>

namespace cd {

/// The answer to a request, as `cdctl view` gives it.
struct HeldAnswer {
    std::string path; ///< Of the request, below `page_api`.
    Bytes bytes;
    bool is_cut = false; ///< Rows are missing, as the header X-Cut says.
};

/// Returns the numbers of the bodies of these scenarios. Errors: those of reading poses.
[[nodiscard]] Result<std::set<std::uint32_t>> bodies_of(ViewedRun& run,
                                                        std::span<const std::uint64_t> scenarios);

/// Calls `take` with all that the page's viewer needs to show these scenarios: the origin, the job,
/// meshes and parts of their bodies, maps, and each scenario as it is after it was run again. An
/// error of `take` ends all. The job's id is that of `origin`; unless that is a folder, no folder
/// is named. Errors: as `ViewedRun::scenario` and `take`; Interrupted.
[[nodiscard]] Status for_each_answer(ViewedRun& run,
                                     const PageOrigin& origin,
                                     std::span<const std::uint64_t> scenarios,
                                     const std::function<Status(const HeldAnswer&)>& take,
                                     const StopCheck& stop);

} // namespace cd
