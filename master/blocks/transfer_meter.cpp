#include "master/blocks/transfer_meter.hpp"

#include <algorithm>

namespace cd {

void TransferMeter::wanted(TreeId tree, RootIndex root, std::uint64_t bytes, double now) {
    wanted_.try_emplace({tree, root}, Wanted{bytes, now});
}

std::optional<TransferMeter::Measured>
TransferMeter::held(TreeId tree, std::span<const RootIndex> roots, double now) {
    Measured measured;
    double since = now;
    for (const RootIndex root : roots) {
        if (const auto found = wanted_.find({tree, root}); found != wanted_.end()) {
            measured.bytes += found->second.bytes;
            since = std::min(since, found->second.since);
            wanted_.erase(found);
        }
    }
    if (measured.bytes == 0) {
        return std::nullopt;
    }
    measured.seconds = now - std::max(since, measured_until_);
    measured_until_ = now;
    return measured;
}

void TransferMeter::tree_removed(TreeId tree) {
    std::erase_if(wanted_, [&](const auto& entry) { return entry.first.first == tree; });
}

} // namespace cd
