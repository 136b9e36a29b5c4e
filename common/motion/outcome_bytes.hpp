// What is proven of a motion, as a record has it.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/motion/motion_outcome.hpp"

#include <cstdint>

namespace cd {

/// Encodes an outcome: u8 until, u8 depth, u8 end, u32 t0, u32 t1, u32 n, then n runs of u8 state,
/// u32 first, u32 count, u32 first and u32 last instant with the event.
void put_motion(ByteWriter& out, const MotionOutcome& outcome);
/// Decodes the bytes of `put_motion`. Errors: BadFrame, also for what no search finds
/// (`outcome_problem`).
[[nodiscard]] Status get_motion(ByteReader& in, MotionOutcome& outcome);
/// Returns the number of bytes that `put_motion` writes.
[[nodiscard]] std::uint64_t bytes_of_motion(const MotionOutcome& outcome);

} // namespace cd
