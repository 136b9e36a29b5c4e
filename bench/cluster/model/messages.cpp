#include "bench/cluster/model/messages.hpp"

#include "common/core/check.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/scenario.hpp"
#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"

#include <numeric>
#include <span>

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

} // namespace

std::vector<std::uint64_t> scenarios_in(const WorkUnit& unit) {
    std::vector<std::uint64_t> scenarios;
    if (unit.scenarios.empty()) {
        scenarios.resize(unit.count);
        std::iota(scenarios.begin(), scenarios.end(), unit.first);
        return scenarios;
    }
    const auto unpacked = unpack_scenarios(unit.scenarios, unit.count);
    for (const Scenario& one : unpacked.value()) {
        scenarios.push_back(one.index);
    }
    return scenarios;
}

std::vector<std::uint64_t> scenarios_in(const Results& results) {
    std::vector<std::uint64_t> scenarios(results.count);
    ByteReader reader(results.records);
    for (std::uint64_t& scenario : scenarios) {
        scenario = reader.get<std::uint64_t>();
    }
    CD_CHECK(reader.complete());
    return scenarios;
}

void set_scenarios(Results& results, const std::vector<std::uint64_t>& scenarios) {
    ByteWriter records;
    records.put_array(std::span(scenarios));
    results.count = static_cast<std::uint32_t>(scenarios.size());
    results.records = records.take();
}

std::uint64_t bytes_of(const Message& message, const Workload& workload) {
    if (const auto* unit = std::get_if<WorkUnit>(&message);
        unit != nullptr && !unit->scenarios.empty()) {
        static const std::uint64_t overhead = batch_overhead();
        std::uint64_t bytes = overhead;
        for (const std::uint64_t scenario : scenarios_in(*unit)) {
            bytes += workload.scenario(scenario).batch_bytes;
        }
        return bytes;
    }
    std::uint64_t bytes = on_wire(message);
    if (const auto* subtrees = std::get_if<Subtrees>(&message)) {
        for (const SubtreeBlock& block : subtrees->blocks) {
            bytes += workload.block(block_id(subtrees->tree, block.root)).bytes;
        }
    } else if (const auto* results = std::get_if<Results>(&message)) {
        for (const std::uint64_t scenario : scenarios_in(*results)) {
            bytes += workload.scenario(scenario).result_bytes;
        }
        bytes += results->count * sizeof(std::uint32_t);
        bytes -= results->records.size();
    }
    return bytes;
}

} // namespace cd::bench
