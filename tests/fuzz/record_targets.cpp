#include "common/core/compress.hpp"
#include "common/core/limits.hpp"
#include "common/job/packed_map.hpp"
#include "common/job/packed_records.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/result.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/subtree_block.hpp"
#include "common/tree/top_block.hpp"
#include "master/alarm_record.hpp"
#include "master/journal_records.hpp"
#include "master/result_group.hpp"
#include "master/result_store.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <fstream>

namespace cd::fuzz {

namespace {

constexpr std::uint64_t unpacked_bytes_max = 1u << 20;
constexpr JobId segment_job{7};
constexpr std::uint64_t segment_scenarios = 1000;
constexpr std::uint64_t scenarios_max = 1000;

/// Of forms in which the same can be said in several ways: a hash or a database vouches for them.
template <class Decode, class Encode>
void check_repeats(Input input, const Decode& decode, const Encode& encode) {
    const auto decoded = decode(input);
    if (!decoded) {
        return;
    }
    const Bytes bytes = encode(decoded.value());
    const auto again = decode(bytes);
    require(again && encode(again.value()) == bytes,
            "what was accepted can be written, and read again");
}

/// Where the records of a segment would stand if their lengths are right.
void restore_all(ResultStore& store, Input records) {
    std::uint64_t end = store.end() - records.size();
    ByteReader in(records);
    while (!in.failed() && in.remaining() != 0) {
        const auto length = in.get<std::uint64_t>();
        const auto scenario = in.get<std::uint64_t>();
        const RecordPlace place = ResultStore::place_at(end, length);
        if (scenario >= segment_scenarios || !store.restore(scenario, place)) {
            return;
        }
        end = ResultStore::end_of(place);
        static_cast<void>(in.get_bytes(length));
        static_cast<void>(in.get<std::uint64_t>());
    }
}

} // namespace

void block(Input input) {
    check_repeats(input, decode_subtree, encode_subtree);
}

void top(Input input) {
    check_repeats(input, decode_top, encode_top);
}

void result(Input input) {
    const auto decoded = decode_result(input);
    if (decoded) {
        require(std::ranges::equal(encode_result(decoded.value()), input),
                "a record that is accepted is what the encoder writes");
    }
}

void packed(Input input) {
    const auto unpacked = unpack_records(input, unpacked_bytes_max);
    require(!unpacked || unpacked.value().size() <= unpacked_bytes_max,
            "nothing unpacks to more than it may");
}

void map(Input input) {
    constexpr ContactMapBounds bounds{1u << 20, 1u << 20, 1u << 20};
    const auto unpacked = unpack_map(compress(input, compression_level_fast), bounds);
    if (unpacked) {
        const auto bytes = decompress(pack_map(unpacked.value()), input.size());
        require(bytes && std::ranges::equal(bytes.value(), input),
                "a map that is accepted is what the encoder writes");
    }
}

void journal_row(Input input) {
    if (input.empty()) {
        return;
    }
    const Input row = input.subspan(1);
    switch (std::to_integer<unsigned>(input.front()) % 5) {
    case 0:
        check_repeats(row, decode_job, encode_job);
        break;
    case 1:
        check_repeats(row, decode_progress, encode_progress);
        break;
    case 2:
        check_repeats(row, decode_end, encode_end);
        break;
    case 3:
        check_repeats(row, decode_group, encode_group);
        break;
    default:
        check_repeats(row, decode_alarms, encode_alarms);
        break;
    }
}

/// The bytes are what follows the file's header, which a fuzzer would not guess.
void segment(Input input) {
    const MemoryFile file({});
    const auto made = ResultStore::create(file.path(), segment_job, segment_scenarios);
    const std::byte any{1};
    const StoredRecord first{0, {&any, 1}};
    require(made->write({&first, 1}).has_value(), "a segment in memory can be written");
    made->commit();
    const std::uint64_t begin = made->end();
    std::ofstream(file.path(), std::ios::app | std::ios::binary) << text_of(input);
    const auto opened =
        ResultStore::open(file.path(), segment_job, segment_scenarios, begin + input.size());
    require(opened.has_value(), "a segment with its header is opened");
    ResultStore& store = *opened.value();
    restore_all(store, input);
    if (store.verify()) {
        const auto all = store.read(0, segment_scenarios, unpacked_bytes_max);
        require(all.has_value(), "records that are verified can be read");
    }
}

void grid(Input input) {
    const auto decoded = decode_grid(input);
    if (decoded) {
        require(std::ranges::equal(encode_grid(decoded.value()), input),
                "a grid that is accepted is what the encoder writes");
        const std::uint64_t last = decoded.value().count() - 1;
        require(scenario_on(decoded.value(), last).index == last, "the last place can be had");
    }
}

/// Runs may be cut anywhere, so the same poses have several forms.
void scenarios(Input input) {
    const auto decode = [](Input bytes) { return unpack_scenarios(bytes, scenarios_max); };
    check_repeats(input, decode, [](const std::vector<Scenario>& all) {
        require(all.size() <= scenarios_max, "no more come than may");
        return pack_scenarios(all);
    });
}

} // namespace cd::fuzz
