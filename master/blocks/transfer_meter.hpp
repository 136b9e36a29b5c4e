// Measures how fast blocks reach one worker, from its request to its report of holding them.
#pragma once

#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace cd {

/// Takes times and returns values; no clock. The time includes the opening of blocks, whether the
/// master or a peer sends them.
class TransferMeter {
  public:
    struct Measured {
        std::uint64_t bytes = 0;
        double seconds = 0;
    };

    /// A repeated request does not restart the measurement.
    void wanted(TreeId tree, RootIndex root, std::uint64_t bytes, double now);
    /// Returns the bytes of the wanted blocks among these, and the seconds since the request. Each
    /// moment counts once, for the blocks that came after it. Empty if none was wanted.
    std::optional<Measured> held(TreeId tree, std::span<const RootIndex> roots, double now);
    /// Drops the measurements of a removed tree's blocks.
    void tree_removed(TreeId tree);

  private:
    struct Wanted {
        std::uint64_t bytes = 0;
        double since = 0;
    };
    std::map<std::pair<TreeId, RootIndex>, Wanted> wanted_;
    double measured_until_ = 0;
};

} // namespace cd
