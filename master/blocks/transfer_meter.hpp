// How fast blocks reach one worker, measured from its asking for them to its holding them.
#pragma once

#include "common/tree/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace cd {

/// Takes times and returns values; no clock. Whoever gives the worker its blocks, the opening of
/// them is part of their way.
class TransferMeter {
  public:
    struct Measured {
        std::uint64_t bytes = 0;
        double seconds = 0;
    };

    /// Asking again does not begin anew.
    void wanted(TreeId tree, RootIndex root, std::uint64_t bytes, double now);
    /// What of these was wanted, and how long it took: since the worker asked, but each moment
    /// counts once, for what came after it. Nothing where nothing of it was wanted.
    std::optional<Measured> held(TreeId tree, std::span<const RootIndex> roots, double now);
    /// Its blocks come no more.
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
