// Children that work in turns: each engine in a process of its own, so that a crash or a hang is a
// row, and all of them round by round, so that what disturbs the machine disturbs all alike.
#pragma once

#include "bench/accuracy/isolate.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>

namespace cd::bench {

/// A child of this process that sleeps but for its turns. Only for a process with one thread.
class TurnTaker {
  public:
    /// The child keeps a copy of `work` and calls it for each turn with the turn's number. What it
    /// writes is seen here only in a SharedArray. It runs on the processor `cpu` alone; on any if
    /// that is negative.
    TurnTaker(int cpu, const std::function<void(std::uint32_t)>& work);
    TurnTaker(const TurnTaker&) = delete;
    TurnTaker& operator=(const TurnTaker&) = delete;
    ~TurnTaker();

    /// Waits for the end of the turn. After a crash or a hang the child is gone, and every later
    /// turn ends as that one did.
    Ending take_turn(std::uint32_t number, std::chrono::seconds limit);

    [[nodiscard]] Ending ending() const { return ending_; }

  private:
    void end(Ending ending);

    pid_t child_ = -1;
    int link_ = -1;
    Ending ending_ = Ending::Done;
};

} // namespace cd::bench
