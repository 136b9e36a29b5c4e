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

#include <cstdint>
#include <functional>
#include <vector>

namespace cd {

/// When a search along a motion ends. The event is that the bodies are at most the clearance apart;
/// without a clearance, that they touch. The numbers are part of the wire format.
enum class Until : std::uint8_t {
    Contact = 0, ///< At the first instant with the event.
    Free = 1,    ///< At the first free cell.
    End = 2,     ///< At the end of the motion.
};

/// Exact answers about two bodies at given poses.
struct CellQuestions {
    /// Whether the bodies are at most this far apart; those in contact are. The distance is finite.
    std::function<bool(const PosePair&, double)> is_within;
    /// Whether the event holds.
    std::function<bool(const PosePair&)> is_event;
    StopCheck stop = {}; ///< Polled after every answer, which is ignored once this is true.
};

/// How a search along a motion ended. The numbers are part of stored results.
enum class MotionEnd : std::uint8_t {
    Free = 0,    ///< Without the event; with Until::Free, at a free cell.
    Contact = 1, ///< The event was found after tau = 0; with Until::Free, no cell is free.
    Start = 2,   ///< The event holds at tau = 0 already; never with Until::Free.
    Limit = 3,   ///< More cells than `limits::motion_cells_max`: the runs end early.
};

enum class CellState : std::uint8_t { Free = 0, Open = 1 };

/// Consecutive leaves of one state, in units of 2^-K of the motion's time: [first, first + count].
struct CellRun {
    CellState state = CellState::Free;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    /// The first and the last end of a leaf at which the event holds. The first is greater if there
    /// is none, as in every free run.
    std::uint32_t event_first = 1;
    std::uint32_t event_last = 0;

    [[nodiscard]] bool has_event() const { return event_first <= event_last; }
    [[nodiscard]] std::uint32_t end() const { return first + count; }

    friend bool operator==(const CellRun&, const CellRun&) = default;
};

/// What is proven of a motion. Instants are in units of 2^-depth of its time.
struct MotionAnswer {
    unsigned depth = 0; ///< K.
    MotionEnd end = MotionEnd::Free;
    /// Until::Contact and Until::End: the event holds at t1, and before t0 no run has it; [t0, t1]
    /// is open, or both are 0. Until::Free: the event holds at t0, and the bodies are free from t1
    /// on. Both are the end of the last run where there is no event.
    std::uint32_t t0 = 0;
    std::uint32_t t1 = 0;
    /// In order, without gaps, from 0 to where the search ended; states alternate. In an open run
    /// the bodies were at most `open_within` apart at the middle of each leaf.
    std::vector<CellRun> runs;
    double open_within = 0;  ///< The largest M + clearance of an open leaf; 0 if there is none.
    std::uint32_t cells = 0; ///< Cells tested; no part of the answer.
    bool is_stopped = false; ///< True if `stop` ended the search; then the rest means nothing.
};

/// Searches a motion. `clearance` is finite and at least 0, in the job's unit.
[[nodiscard]] MotionAnswer
search_cells(const Motion& motion, Until until, double clearance, const CellQuestions& questions);

} // namespace cd
