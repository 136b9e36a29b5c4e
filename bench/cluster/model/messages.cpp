#include "bench/cluster/model/messages.hpp"

#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"

#include <algorithm>

namespace cd::bench {

namespace {

std::uint64_t on_wire(const Message& message) {
    return frame_header_bytes + encode_message(message).size();
}

/// Bytes of an analysed unit of work without its scenarios.
std::uint64_t batch_overhead() {
    WorkUnit one;
    one.count = 1;
    one.pair_offsets = {0, 0};
    return on_wire(one) - sizeof(one.pair_offsets.front());
}

/// Bytes of the messages without content, and the overhead of a block.
struct Overheads {
    std::uint64_t batch = batch_overhead();
    std::uint64_t tree = on_wire(AddTree{});
    std::uint64_t blocks = on_wire(Subtrees{});
    std::uint64_t block = on_wire(Subtrees{TreeId{}, {SubtreeBlock{}}}) - blocks;
    std::uint64_t directed = on_wire(FetchFromPeers{TreeId{}, {}, {}, {PeerSource{}}});
    std::uint64_t asked = on_wire(PeerFetch{});
    std::uint64_t want = on_wire(WantSubtrees{});
    std::uint64_t held = on_wire(Held{});
    std::uint64_t evicted = on_wire(Evicted{});
    std::uint64_t failed = on_wire(FetchFailed{});
    std::uint64_t results = on_wire(Results{});
    std::uint64_t end_of_task = on_wire(EndOfTask{});
    std::uint64_t terminate = on_wire(Terminate{});
    std::uint64_t recall = on_wire(Recall{});
    std::uint64_t recalled = on_wire(Recalled{});
    std::uint64_t drop = on_wire(DropScenario{});
    std::uint64_t hint = on_wire(Hint{});
};

const Overheads& overheads() {
    static const Overheads measured;
    return measured;
}

/// Returns the number of trees: a message names one tree.
std::uint64_t trees_in(const std::vector<BlockId>& blocks) {
    const auto second = std::ranges::count(blocks, 1, &BlockId::tree);
    const bool has_second = second != 0;
    const bool has_first = static_cast<std::size_t>(second) != blocks.size();
    return (has_first ? 1u : 0u) + (has_second ? 1u : 0u);
}

std::uint64_t bytes_in(const BatchSent& message, const Workload& workload) {
    std::uint64_t bytes = overheads().batch;
    for (const std::uint64_t scenario : message.scenarios) {
        bytes += workload.scenario(scenario).batch_bytes;
    }
    return bytes + (message.is_first ? 2 * overheads().tree : 0);
}

std::uint64_t bytes_in(const BlocksSent& message, const Workload& workload) {
    std::uint64_t bytes = trees_in(message.blocks) * overheads().blocks;
    for (const BlockId& block : message.blocks) {
        bytes += overheads().block + workload.block(block).bytes;
    }
    return bytes;
}

std::uint64_t bytes_in(const FetchDirected& message, const Workload& /*workload*/) {
    return overheads().directed + message.blocks.size() * (sizeof(RootIndex) + sizeof(Sha256));
}

std::uint64_t bytes_in(const PeerAsked& message, const Workload& /*workload*/) {
    return overheads().asked + message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const Hinted& message, const Workload& /*workload*/) {
    return overheads().hint + message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const AskedBack& message, const Workload& /*workload*/) {
    return overheads().recall + message.scenarios.size() * sizeof(std::uint64_t);
}

std::uint64_t bytes_in(const CalledOff& /*message*/, const Workload& /*workload*/) {
    return overheads().drop;
}

std::uint64_t bytes_in(const GaveBack& message, const Workload& /*workload*/) {
    return overheads().recalled + message.scenarios.size() * sizeof(std::uint64_t);
}

std::uint64_t bytes_in(const Ended& /*message*/, const Workload& /*workload*/) {
    return overheads().terminate;
}

std::uint64_t bytes_in(const BlocksWanted& message, const Workload& /*workload*/) {
    return trees_in(message.blocks) * overheads().want + message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const BlocksHeld& message, const Workload& /*workload*/) {
    return trees_in(message.blocks) * overheads().held + message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const BlocksEvicted& message, const Workload& /*workload*/) {
    return trees_in(message.blocks) * overheads().evicted +
           message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const PeerFailed& message, const Workload& /*workload*/) {
    return overheads().failed + message.blocks.size() * sizeof(RootIndex);
}

std::uint64_t bytes_in(const ResultsSent& message, const Workload& workload) {
    std::uint64_t bytes = message.scenarios.empty() ? 0 : overheads().results;
    for (const std::uint64_t scenario : message.scenarios) {
        bytes += sizeof(std::uint32_t) + workload.scenario(scenario).result_bytes;
    }
    return bytes + (message.ends_task ? overheads().end_of_task : 0);
}

std::uint64_t bytes_in(const Analysed& /*message*/, const Workload& /*workload*/) {
    return 0;
}

} // namespace

std::uint64_t bytes_of(const ToWorker& message, const Workload& workload) {
    return std::visit([&](const auto& content) { return bytes_in(content, workload); }, message);
}

std::uint64_t bytes_of(const ToMaster& message, const Workload& workload) {
    return std::visit([&](const auto& content) { return bytes_in(content, workload); }, message);
}

} // namespace cd::bench
