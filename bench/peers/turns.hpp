// Children that work in turns. Each engine has its own process, so that a crash or a hang costs one
// row. Engines alternate, so that disturbances of the machine affect all alike.
#pragma once

#include "bench/accuracy/isolate.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>

namespace cd::bench {

/// A child process that sleeps between its turns. Only for a process with one thread.
class TurnTaker {
  public:
    /// The child keeps a copy of `work` and calls it with each turn's number. The parent sees only
    /// what it writes into a SharedArray. The child runs on the processor `cpu`, or on any if that
    /// is negative.
    TurnTaker(int cpu, const std::function<void(std::uint32_t)>& work);
    TurnTaker(const TurnTaker&) = delete;
    TurnTaker& operator=(const TurnTaker&) = delete;
    ~TurnTaker();

    /// Waits for the end of the turn. After a crash or a hang the child is gone, and every later
    /// turn ends in the same way.
    Ending take_turn(std::uint32_t number, std::chrono::seconds limit);

    [[nodiscard]] Ending ending() const { return ending_; }

  private:
    void end(Ending ending);

    pid_t child_ = -1;
    int link_ = -1;
    Ending ending_ = Ending::Done;
};

} // namespace cd::bench
