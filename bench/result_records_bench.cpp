// Measures the work on records between the worker's search and the client's files: packing,
// unpacking, decoding, encoding and hashing.
//
//   result_records_bench MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50] [--benchmark_...]
//
// One message holds the records of all poses at level `pairs`. `record` and `pair` are the time for
// each record and for each pair; `pairs` and `packed` are the mean pairs and packed bytes of a
// record.
#include "bench/posed_trees.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"
#include "common/job/run_scenario.hpp"

#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <span>
#include <vector>

namespace cd::bench {

namespace {

/// Records of one message, in all their forms.
struct Message {
    std::vector<ScenarioResult> results;
    Bytes records; ///< Each preceded by its length.
    Bytes packed;
    std::uint64_t pairs = 0;
};

constexpr std::uint64_t bytes_max = std::uint64_t{1} << 32;

Message message_of(const PosedTrees& trees) {
    Message message;
    ByteWriter records;
    for (const PosePair& poses : trees.poses) {
        Scenario scenario;
        scenario.index = message.results.size();
        scenario.poses = poses;
        ScenarioResult result = run_scenario(trees.a, trees.b, scenario, Query{}).result;
        message.pairs += result.pairs.size();
        put_record(records, result);
        message.results.push_back(std::move(result));
    }
    message.records = records.take();
    message.packed = pack_records(message.records);
    return message;
}

/// Calls `take` for each record.
void for_each_record(const Message& message,
                     const std::function<void(std::span<const std::byte>)>& take) {
    ByteReader in(message.records);
    while (in.remaining() > 0) {
        take(in.get_bytes(in.get<std::uint32_t>()));
    }
}

void report(benchmark::State& state, const Message& message) {
    using benchmark::Counter;
    const auto records = static_cast<double>(message.results.size());
    const auto pairs = static_cast<double>(message.pairs);
    const auto inverse = Counter::kIsIterationInvariantRate | Counter::kInvert;
    state.counters["record"] = Counter(records, inverse);
    state.counters["pair"] = Counter(pairs, inverse);
    state.counters["pairs"] = pairs / records;
    state.counters["packed"] = static_cast<double>(message.packed.size()) / records;
}

void add(const char* name, const Message& message, const std::function<void()>& work) {
    benchmark::RegisterBenchmark(name, [&message, work](benchmark::State& state) {
        for (auto _ : state) {
            work();
        }
        report(state, message);
    })->Unit(benchmark::kMicrosecond);
}

void register_all(const Message& message) {
    add("pack", message, [&] { benchmark::DoNotOptimize(pack_records(message.records)); });
    add("unpack", message, [&] {
        benchmark::DoNotOptimize(unpack_records(message.packed, bytes_max));
    });
    add("decode", message, [&] {
        ScenarioResult result;
        for_each_record(message, [&](std::span<const std::byte> record) {
            benchmark::DoNotOptimize(decode_result(record, result));
        });
    });
    add("encode", message, [&] {
        ByteWriter out;
        for (const ScenarioResult& result : message.results) {
            put_record(out, result);
        }
        benchmark::DoNotOptimize(out.bytes().data());
    });
    add("hash", message, [&] {
        for_each_record(message, [](std::span<const std::byte> record) {
            benchmark::DoNotOptimize(digest_of_record(record));
        });
    });
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    cd::bench::PosedTreesOptions options;
    CLI::App app("Times the work with the records of results");
    options.add_to(app);
    CLI11_PARSE(app, argc, argv);
    const auto trees = cd::bench::load(options);
    if (!trees) {
        return 2;
    }
    const cd::bench::Message message = cd::bench::message_of(*trees);
    const auto unpacked = cd::unpack_records(message.packed, cd::bench::bytes_max);
    if (!unpacked || unpacked.value() != message.records) {
        std::fprintf(stderr, "the records are not unpacked as they were packed\n");
        return 1;
    }
    cd::bench::register_all(message);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
