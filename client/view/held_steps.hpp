// What the page asks of its server to show the other bodies of some scenarios' steps.
#pragma once

#include "client/view/held_answers.hpp"
#include "client/view/viewed_run.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "web/server/page_values.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace cd {

/// Takes answers that are of use only together: all or none of them. Returns whether it took them.
using OfferAnswers = std::function<bool(std::span<const HeldAnswer>)>;

/// What found no room.
struct LeftOut {
    std::size_t steps = 0;  ///< Steps whose other bodies are not shown.
    std::size_t meshes = 0; ///< Meshes of which the page draws boxes instead.

    [[nodiscard]] bool is_empty() const { return steps == 0 && meshes == 0; }
    /// Says what is left out: "the other bodies of 2 steps, and 1 mesh, drawn as boxes".
    [[nodiscard]] std::string text() const;
};

/// Offers what the page's viewer needs to show, beside the two bodies of these scenarios of a
/// scene, the others of their steps: of each step where the bodies are, then each mesh of theirs
/// once, the smallest first. Offers nothing of a run that is no scene. Errors: those of reading;
/// Interrupted.
[[nodiscard]] Result<LeftOut> offer_steps(ViewedRun& run,
                                          const std::string& job,
                                          std::span<const std::uint64_t> scenarios,
                                          const OfferAnswers& offer,
                                          const StopCheck& stop);

} // namespace cd
