// Queues the positions, in a job's hand-out order, that have not been handed out yet.
#pragma once

#include "common/job/poses/ordered_poses.hpp"
#include "master/base/instance_id.hpp"

#include <cstdint>
#include <deque>
#include <span>

namespace cd {

/// Holds each position at most once. Positions that were put back come first.
class PositionQueue {
  public:
    /// Queues all positions of a job. `lost`: positions lost with workers before a master restart.
    explicit PositionQueue(std::uint64_t scenarios = 0, std::span<const LostPositions> lost = {});

    struct Piece {
        PositionRange positions;
        Losses losses = {}; ///< Worker processes that were lost with these positions.
    };

    [[nodiscard]] bool empty() const { return pieces_.empty(); }
    /// Number of positions in the queue.
    [[nodiscard]] std::uint64_t left() const { return left_; }
    /// The queue must not be empty.
    [[nodiscard]] const Piece& front() const { return pieces_.front(); }
    /// Removes up to `most` positions of the first piece, all from one pose window. The queue must
    /// not be empty.
    [[nodiscard]] Piece take(std::uint64_t most);
    /// Puts the piece at the head.
    void put_back(const Piece& piece);
    /// Pieces in the order in which they are taken.
    [[nodiscard]] const std::deque<Piece>& pieces() const { return pieces_; }

  private:
    std::deque<Piece> pieces_; ///< None is empty.
    std::uint64_t left_ = 0;
};

} // namespace cd
