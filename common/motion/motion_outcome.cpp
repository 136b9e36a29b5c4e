#include "common/motion/motion_outcome.hpp"

#include "common/core/limits/engine.hpp"

#include <algorithm>

namespace cd {

namespace {

/// Whether the runs follow each other from 0 on, within the motion, and each has its event inside.
bool are_runs(const MotionOutcome& outcome) {
    std::uint32_t begin = 0;
    std::optional<CellState> before;
    for (const CellRun& run : outcome.runs) {
        const std::uint32_t left = (1u << outcome.depth) - begin;
        if (run.first != begin || run.count == 0 || run.count > left || before == run.state) {
            return false;
        }
        const bool has_none =
            run.event_first == CellRun{}.event_first && run.event_last == CellRun{}.event_last;
        const bool is_inside = run.state == CellState::Open && run.has_event() &&
                               run.event_first >= run.first && run.event_last <= run.end();
        if (!has_none && !is_inside) {
            return false;
        }
        begin = run.end();
        before = run.state;
    }
    return true;
}

/// The end and the bracket that runs give.
struct Conclusion {
    MotionEnd end = MotionEnd::Free;
    std::uint32_t t0 = 0;
    std::uint32_t t1 = 0;
};

Conclusion conclude_free(const MotionOutcome& outcome, bool is_whole) {
    const CellRun& last = outcome.runs.back();
    const bool is_free = last.state == CellState::Free;
    const auto event = std::find_if(outcome.runs.rbegin(),
                                    outcome.runs.rend(),
                                    [](const CellRun& run) { return run.has_event(); });
    Conclusion found;
    found.end = is_free ? MotionEnd::Free : is_whole ? MotionEnd::Contact : MotionEnd::Limit;
    found.t1 = is_free ? last.first : last.end();
    found.t0 = event == outcome.runs.rend() ? found.t1 : event->event_last;
    return found;
}

Conclusion conclude_event(const MotionOutcome& outcome, bool is_whole) {
    const auto event = std::ranges::find_if(outcome.runs, &CellRun::has_event);
    const bool is_cut = !is_whole && outcome.until == Until::End;
    if (event == outcome.runs.end()) {
        const std::uint32_t end = outcome.runs.back().end();
        return {is_whole ? MotionEnd::Free : MotionEnd::Limit, end, end};
    }
    const bool is_start = event->event_first == 0;
    return {is_cut     ? MotionEnd::Limit
            : is_start ? MotionEnd::Start
                       : MotionEnd::Contact,
            is_start ? 0 : event->first,
            event->event_first};
}

/// Whether a search for the first event, or for the first free cell, ended where it had to.
bool ends_in_time(const MotionOutcome& outcome) {
    const auto is_last = [&](const CellRun& run) { return &run == &outcome.runs.back(); };
    return std::ranges::all_of(outcome.runs, [&](const CellRun& run) {
        if (outcome.until == Until::Contact && run.has_event()) {
            return is_last(run) && run.event_first == run.end() && run.event_last == run.end();
        }
        return outcome.until != Until::Free || run.state == CellState::Open || is_last(run);
    });
}

} // namespace

std::optional<std::uint32_t> MotionOutcome::event() const {
    const bool has_event =
        end == MotionEnd::Start ||
        std::ranges::any_of(runs, [](const CellRun& run) { return run.has_event(); });
    if (!has_event) {
        return std::nullopt;
    }
    return until == Until::Free ? t0 : t1;
}

bool MotionOutcome::has_open_run() const {
    return std::ranges::any_of(runs,
                               [](const CellRun& run) { return run.state == CellState::Open; });
}

const char* outcome_problem(const MotionOutcome& outcome) {
    if (outcome.depth > limits::motion_depth_max || outcome.until > Until::End ||
        outcome.end > MotionEnd::Limit || !are_runs(outcome)) {
        return "runs that are none";
    }
    if (outcome.runs.empty()) {
        const bool is_start = outcome.until == Until::Contact && outcome.end == MotionEnd::Start;
        return is_start && outcome.t0 == 0 && outcome.t1 == 0 ? nullptr : "no runs";
    }
    const bool is_whole = outcome.runs.back().end() == 1u << outcome.depth;
    const Conclusion expected = outcome.until == Until::Free ? conclude_free(outcome, is_whole)
                                                             : conclude_event(outcome, is_whole);
    const bool fits = outcome.end == expected.end && outcome.t0 == expected.t0 &&
                      outcome.t1 == expected.t1 && ends_in_time(outcome);
    return fits ? nullptr : "an end that does not fit the runs";
}

} // namespace cd
