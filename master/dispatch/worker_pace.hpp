// Learned pace of a worker: its compute speed and its transfer rate.
#pragma once

#include <cstdint>

namespace cd {

/// Ratio of two sums with exponential decay: each addition first takes a tenth off both sums.
class LearnedRate {
  public:
    void add(double done, double seconds);
    [[nodiscard]] bool is_known() const { return seconds_ > 0; }
    /// Requires `is_known()`.
    [[nodiscard]] double value() const { return done_ / seconds_; }
    [[nodiscard]] double value_or(double otherwise) const {
        return is_known() ? value() : otherwise;
    }

  private:
    double done_ = 0;
    double seconds_ = 0;
};

struct WorkerPace {
    LearnedRate work;  ///< Predicted seconds of work that one thread does per second.
    LearnedRate bytes; ///< Bytes of blocks that the worker receives per second.
};

} // namespace cd
