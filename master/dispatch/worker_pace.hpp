// What the dispatcher learns of a worker's pace: how fast it computes, how fast blocks reach it.
#pragma once

#include <cstdint>

namespace cd {

/// A ratio of two sums in which what was added last counts most: each addition first takes a tenth
/// from both sums.
class LearnedRate {
  public:
    void add(double done, double seconds);
    [[nodiscard]] bool is_known() const { return seconds_ > 0; }
    /// Something has been added.
    [[nodiscard]] double value() const { return done_ / seconds_; }
    [[nodiscard]] double value_or(double otherwise) const {
        return is_known() ? value() : otherwise;
    }

  private:
    double done_ = 0;
    double seconds_ = 0;
};

struct WorkerPace {
    LearnedRate work;  ///< Predicted seconds that one thread does in a second.
    LearnedRate bytes; ///< Of blocks, in a second.
};

} // namespace cd
