#include "common/motion/outcome_bytes.hpp"

#include "common/core/errors.hpp"

#include <string>

namespace cd {

namespace {

constexpr std::uint64_t head_bytes = 3 * sizeof(std::uint8_t) + 3 * sizeof(std::uint32_t);
constexpr std::uint64_t run_bytes = sizeof(std::uint8_t) + 4 * sizeof(std::uint32_t);

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

CellRun get_run(ByteReader& in) {
    CellRun run;
    run.state = static_cast<CellState>(in.get<std::uint8_t>());
    run.first = in.get<std::uint32_t>();
    run.count = in.get<std::uint32_t>();
    run.event_first = in.get<std::uint32_t>();
    run.event_last = in.get<std::uint32_t>();
    return run;
}

} // namespace

void put_motion(ByteWriter& out, const MotionOutcome& outcome) {
    out.put(static_cast<std::uint8_t>(outcome.until));
    out.put(static_cast<std::uint8_t>(outcome.depth));
    out.put(static_cast<std::uint8_t>(outcome.end));
    out.put(outcome.t0);
    out.put(outcome.t1);
    out.put(static_cast<std::uint32_t>(outcome.runs.size()));
    for (const CellRun& run : outcome.runs) {
        out.put(static_cast<std::uint8_t>(run.state));
        out.put(run.first);
        out.put(run.count);
        out.put(run.event_first);
        out.put(run.event_last);
    }
}

Status get_motion(ByteReader& in, MotionOutcome& outcome) {
    outcome.until = static_cast<Until>(in.get<std::uint8_t>());
    outcome.depth = in.get<std::uint8_t>();
    outcome.end = static_cast<MotionEnd>(in.get<std::uint8_t>());
    outcome.t0 = in.get<std::uint32_t>();
    outcome.t1 = in.get<std::uint32_t>();
    const auto runs = in.get<std::uint32_t>();
    if (in.failed() || runs > in.remaining() / run_bytes) {
        return bad("runs cut short");
    }
    outcome.runs.reserve(runs);
    for (std::uint32_t i = 0; i < runs; ++i) {
        outcome.runs.push_back(get_run(in));
        if (outcome.runs.back().state > CellState::Open) {
            return bad("unknown state of a run");
        }
    }
    const char* const problem = outcome_problem(outcome);
    return problem == nullptr ? Status(Done{}) : bad(problem);
}

std::uint64_t bytes_of_motion(const MotionOutcome& outcome) {
    return head_bytes + run_bytes * outcome.runs.size();
}

} // namespace cd
