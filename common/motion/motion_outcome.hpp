// What is proven of a motion: the free and open parts of its time, and the event.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace cd {

/// When a search along a motion ends. The event is that the bodies are at most the clearance apart;
/// without a clearance, that they touch. The numbers are part of the wire format.
enum class Until : std::uint8_t {
    Contact = 0, ///< At the first instant with the event.
    Free = 1,    ///< At the first free cell.
    End = 2,     ///< At the end of the motion.
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
struct MotionOutcome {
    Until until = Until::Contact; ///< What the search was for.
    unsigned depth = 0;           ///< K.
    MotionEnd end = MotionEnd::Free;
    /// Until::Contact and Until::End: the event holds at t1, and before t0 no run has it; [t0, t1]
    /// is open, or both are 0. Until::Free: the event holds at t0, and the bodies are free from t1
    /// on. Both are the end of the last run where there is no event.
    std::uint32_t t0 = 0;
    std::uint32_t t1 = 0;
    /// In order, without gaps, from 0 to where the search ended; states alternate.
    std::vector<CellRun> runs;

    /// Returns the instant whose contacts the answer is about: the first with the event, or, with
    /// Until::Free, the last before the way out. Nothing if no instant is known to have the event.
    [[nodiscard]] std::optional<std::uint32_t> event() const;
    /// Whether a run is open.
    [[nodiscard]] bool has_open_run() const;

    friend bool operator==(const MotionOutcome&, const MotionOutcome&) = default;
};

/// Returns what no search along a motion finds: runs with gaps or of equal states, instants outside
/// of their runs, or an end or bracket that the runs do not give. Null if there is nothing.
[[nodiscard]] const char* outcome_problem(const MotionOutcome& outcome);

} // namespace cd
