// What of a job has not been handed out yet.
#pragma once

#include "common/job/poses/ordered_poses.hpp"
#include "master/base/worker_process.hpp"

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace cd {

/// What of the runs is not in `hole`.
[[nodiscard]] std::vector<PlaceRange> without(std::span<const PlaceRange> runs,
                                              const PlaceRange& hole);

/// Places of a job's order, each once; first those that came back.
class PlaceQueue {
  public:
    /// `lost`: before; their places are places of the job.
    explicit PlaceQueue(std::uint64_t scenarios = 0, std::span<const LostPlaces> lost = {});

    struct Piece {
        PlaceRange places;
        Losses losses = {}; ///< With whom these were lost.
    };

    [[nodiscard]] bool empty() const { return pieces_.empty(); }
    [[nodiscard]] std::uint64_t left() const { return left_; }
    /// There is one.
    [[nodiscard]] const Piece& front() const { return pieces_.front(); }
    /// Up to `most` of the first piece, all of one window.
    [[nodiscard]] Piece take(std::uint64_t most);
    void put_back(const Piece& piece);
    /// In the order in which they are taken.
    [[nodiscard]] const std::deque<Piece>& pieces() const { return pieces_; }

  private:
    std::deque<Piece> pieces_; ///< None empty.
    std::uint64_t left_ = 0;
};

} // namespace cd
