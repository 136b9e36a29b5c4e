// Holds results until all results with lower indices are taken.
#pragma once

#include "client/local/done_block.hpp"

#include <cstdint>
#include <map>

namespace cd {

class ResultQueue {
  public:
    /// `first` is the index of the first result to take.
    explicit ResultQueue(std::uint64_t first) : next_(first) {}

    /// Returns the index of the next result to take.
    [[nodiscard]] std::uint64_t next() const { return next_; }
    [[nodiscard]] bool is_next_here() const {
        return !waiting_.empty() && waiting_.begin()->first == next_;
    }
    /// True if the waiting results and the results that the last `take` returned have at least
    /// `limits::run_bytes_ahead_max` bytes together.
    [[nodiscard]] bool is_full() const;

    /// Adds results, if any. Their indices are new.
    void add(DoneBlock results);
    /// Takes the next results in order, as many as were added together; none if they are not here.
    [[nodiscard]] DoneBlock take();
    /// Stops counting the bytes of the results that the last `take` returned.
    void release_taken();

  private:
    std::map<std::uint64_t, DoneBlock> waiting_; ///< By the index of the first result.
    std::uint64_t next_ = 0;
    std::uint64_t bytes_ = 0;
    std::uint64_t bytes_taken_ = 0; ///< The part of `bytes_` that the last `take` returned.
};

} // namespace cd
