// Finds where two moving bodies are free of each other, by halving the time.
//
// A cell of time is free if and only if the bodies are farther apart at its middle than M + d0,
// with M the bound of motion_bound.hpp and d0 the clearance: then they are farther apart than d0 in
// all of the cell. Other cells are halved while M exceeds the resolution; the rest are open. All
// decisions are exact, so the answer depends neither on the search nor on the host.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/geometry/pose.hpp"
#include "common/motion/motion.hpp"
#include "common/motion/motion_outcome.hpp"

#include <cstdint>
#include <functional>

namespace cd {

/// Exact answers about two bodies at given poses.
struct CellQuestions {
    /// Whether the bodies are at most this far apart; those in contact are. The distance is finite.
    std::function<bool(const PosePair&, double)> is_within;
    /// Whether the event holds.
    std::function<bool(const PosePair&)> is_event;
    StopCheck stop = {}; ///< Polled after every answer, which is ignored once this is true.
};

/// The outcome of a search along a motion, with its bound and its cost. In an open run the bodies
/// were at most `open_within` apart at the middle of each leaf.
struct MotionAnswer : MotionOutcome {
    double open_within = 0;   ///< The largest M + clearance of an open leaf; 0 if there is none.
    std::uint32_t cells = 0;  ///< Cells tested; no part of the answer.
    std::uint32_t leaves = 0; ///< Tested cells that are not halved; no part of the answer.
    bool is_stopped = false;  ///< True if `stop` ended the search; then the rest means nothing.
};

/// Searches a motion. `clearance` is finite and at least 0, in the job's unit.
[[nodiscard]] MotionAnswer
search_cells(const Motion& motion, Until until, double clearance, const CellQuestions& questions);

} // namespace cd
