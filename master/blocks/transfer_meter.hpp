// Measures the rate at which blocks reach one worker, from the request to the report that it holds
// them.
#pragma once

#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace cd {

/// Has no clock: the caller passes the time in seconds. The measured time includes the decoding of
/// blocks, and does not depend on whether the master or a peer sends them.
class TransferMeter {
  public:
    /// Bytes that have arrived, and the time that they took.
    struct Measured {
        std::uint64_t bytes = 0;
        double seconds = 0;
    };

    /// Handles a request for a block of `bytes` bytes. A repetition does not restart the time.
    void wanted(TreeId tree, RootIndex root, std::uint64_t bytes, double now);
    /// Handles a report that the worker holds these blocks. Returns the bytes of the requested
    /// blocks, and the seconds since their first request or since the last measurement ended,
    /// whichever is later. Empty if none was requested.
    std::optional<Measured> held(TreeId tree, std::span<const RootIndex> roots, double now);
    /// Forgets the requests for blocks of a removed tree.
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
