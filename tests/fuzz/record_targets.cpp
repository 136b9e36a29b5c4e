#include "common/core/files/compress.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/varint.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "common/tree/wire/top_block.hpp"
#include "master/journal/alarm_record.hpp"
#include "master/journal/journal_records.hpp"
#include "master/journal/result_group.hpp"
#include "master/journal/result_store.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"
#include "web/server/cluster/result_records.hpp"
#include "worker/cache/subtree_cache.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>

namespace cd::fuzz {

namespace {

constexpr std::uint64_t unpacked_bytes_max = 1u << 20;
constexpr JobId segment_job{7};
constexpr std::uint64_t segment_scenarios = 1000;
constexpr std::uint64_t scenarios_max = 1000;

/// Checks encodings that are not unique; a hash or a database protects their bytes.
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

/// Packs columns, each a length (two bytes) and its bytes, into records.
Bytes pack_columns(Input columns) {
    constexpr std::size_t column_count = 8;
    ByteReader in(columns);
    std::array<Bytes, column_count> compressed;
    ByteWriter out;
    for (Bytes& column : compressed) {
        const auto length = in.get<std::uint16_t>();
        const Input bytes = in.get_bytes(std::min<std::size_t>(length, in.remaining()));
        column = bytes.empty() ? Bytes() : compress(bytes, compression_level_fast);
        put_varint(out, column.size());
    }
    for (const Bytes& column : compressed) {
        put_bytes(out, column);
    }
    return out.take();
}

std::vector<Input> records_in(Input unpacked) {
    std::vector<Input> records;
    ByteReader in(unpacked);
    while (in.remaining() != 0) {
        records.push_back(in.get_bytes(in.get<std::uint32_t>()));
        require(!in.failed(), "what was unpacked is whole records");
    }
    return records;
}

/// Reads a master's records as a client does.
void check_results(Input packed, const std::vector<Input>& records) {
    ResultsPart part;
    part.count = static_cast<std::uint32_t>(records.size());
    part.next = part.count;
    part.held = {{0, part.count}};
    part.records.assign(packed.begin(), packed.end());
    const auto results = unpack_results(part, {{}, 0, part.count}, part.count);
    if (!results) {
        return;
    }
    require(results.value().size() == records.size(), "each record is a result");
    for (std::size_t i = 0; i < records.size(); ++i) {
        require(results.value()[i].result.index == i, "results come in their order");
        require_canonical(encode_result(results.value()[i].result), records[i]);
    }
}

/// A record of a segment in the input: u64 length, u64 scenario, the record, its footer.
struct SegmentRecord {
    std::uint64_t scenario = 0;
    Input record;
    std::uint64_t footer = 0;
};

/// Reads records as far as the input has whole ones.
std::vector<SegmentRecord> segment_records(Input input) {
    std::vector<SegmentRecord> records;
    for (ByteReader in(input);;) {
        const auto length = in.get<std::uint64_t>();
        SegmentRecord one;
        one.scenario = in.get<std::uint64_t>();
        one.record = in.get_bytes(length);
        one.footer = in.get<std::uint64_t>();
        if (in.failed()) {
            return records;
        }
        records.push_back(one);
    }
}

Bytes segment_of(std::span<const SegmentRecord> records) {
    ByteWriter out;
    for (const SegmentRecord& one : records) {
        put_bytes(out, one.record);
        out.put(one.footer);
    }
    return out.take();
}

using RecordsOfScenarios = std::map<std::uint64_t, Input>;

/// Restores the records of a segment, as far as the store takes them.
RecordsOfScenarios
restore_all(ResultStore& store, std::uint64_t end, std::span<const SegmentRecord> records) {
    RecordsOfScenarios restored;
    for (const SegmentRecord& one : records) {
        const RecordPlace place = ResultStore::place_at(end, one.record.size());
        if (!store.restore(one.scenario, place)) {
            break;
        }
        end = ResultStore::end_of(place);
        restored[one.scenario] = one.record;
    }
    return restored;
}

} // namespace

void block(Input input) {
    check_repeats(input, decode_subtree, encode_subtree);
}

void top(Input input) {
    check_repeats(input, decode_top, encode_top);
}

/// The hash is right: the sender of a block supplies it.
void sent_block(Input input) {
    SubtreeBlock block;
    block.root = is_odd(input) ? top_root : 0;
    const Input rest = rest_of(input);
    block.compressed.assign(rest.begin(), rest.end());
    const auto bytes = decompress(block.compressed, unpacked_bytes_max);
    if (!bytes) {
        return;
    }
    require(!open_block(block), "a block with another hash is refused");
    block.hash = sha256(bytes.value());
    const auto opened = open_block(block);
    if (!opened) {
        return;
    }
    using Top = std::shared_ptr<const TreeTop>;
    using Tree = std::shared_ptr<const Subtree>;
    const bool can_be_written =
        block.root == top_root
            ? decode_top(encode_top(*std::get<Top>(opened.value()))).has_value()
            : decode_subtree(encode_subtree(*std::get<Tree>(opened.value()))).has_value();
    require(can_be_written, "what was opened can be written");
}

void result(Input input) {
    const auto decoded = decode_result(input);
    if (decoded) {
        require_canonical(encode_result(decoded.value()), input);
    }
}

void packed(Input input) {
    const Input rest = rest_of(input);
    const Bytes packed = is_odd(input) ? pack_columns(rest) : Bytes(rest.begin(), rest.end());
    const auto unpacked = unpack_records(packed, unpacked_bytes_max);
    if (!unpacked) {
        return;
    }
    require(unpacked.value().size() <= unpacked_bytes_max, "nothing unpacks to more than it may");
    const auto again = unpack_records(pack_records(unpacked.value()), unpacked_bytes_max);
    require(again && again.value() == unpacked.value(), "what was unpacked can be packed");
    check_results(packed, records_in(unpacked.value()));
}

void map(Input input) {
    constexpr ContactMapBounds bounds{1u << 20, 1u << 20, 1u << 20};
    const Bytes sent(input.begin(), input.end());
    for (const Bytes& packed : {compress(input, compression_level_fast), sent}) {
        const auto unpacked = unpack_map(packed, bounds);
        if (unpacked) {
            const auto written = decompress(pack_map(unpacked.value()), unpacked_bytes_max);
            require(written.has_value(), "a map that is written can be read");
            require_canonical(written.value(), decompress(packed, unpacked_bytes_max).value());
        }
    }
}

void journal_row(Input input) {
    if (input.empty()) {
        return;
    }
    const Input row = input.subspan(1);
    switch (std::to_integer<unsigned>(input.front()) % 5) {
    case 0:
        return check_repeats(row, decode_job, encode_job);
    case 1:
        return check_repeats(row, decode_progress, encode_progress);
    case 2:
        return check_repeats(row, decode_end, encode_end);
    case 3:
        return check_repeats(row, decode_group, encode_group);
    default:
        return check_repeats(row, decode_alarms, encode_alarms);
    }
}

/// Adds the file's header, which no fuzzer would guess.
void segment(Input input) {
    std::vector<SegmentRecord> records = segment_records(rest_of(input));
    for (SegmentRecord& one : records) {
        one.footer = is_odd(input) ? record_footer(one.scenario, one.record) : one.footer;
    }
    const Bytes bytes = segment_of(records);
    const MemoryFile file({});
    const auto made = ResultStore::create(file.path(), segment_job, segment_scenarios);
    const std::byte any{1};
    ResultBatch first;
    first.add(0, {}, {&any, 1});
    require(made->write(std::vector<const ResultBatch*>{&first}).has_value(),
            "a segment in memory can be written");
    made->commit();
    const std::uint64_t begin = made->end();
    std::ofstream(file.path(), std::ios::app | std::ios::binary) << text_of(bytes);
    const auto opened =
        ResultStore::open(file.path(), segment_job, segment_scenarios, begin + bytes.size());
    require(opened.has_value(), "a segment with its header is opened");
    ResultStore& store = *opened.value();
    const RecordsOfScenarios restored = restore_all(store, begin, records);
    const bool is_verified = store.verify().has_value();
    require(is_verified || !is_odd(input), "records with their checksums are verified");
    if (!is_verified) {
        return;
    }
    for (const auto& [scenario, record] : restored) {
        const auto part = store.read(scenario, 1, unpacked_bytes_max);
        require(part.has_value(), "records that are verified can be read");
        require(std::ranges::equal(records_in(part.value().records).front(), record),
                "the last record of a scenario is the one that is read");
    }
}

void grid(Input input) {
    const auto decoded = decode_grid(input);
    if (decoded) {
        require_canonical(encode_grid(decoded.value()), input);
        const std::uint64_t last = decoded.value().count() - 1;
        require(scenario_on(decoded.value(), last).index == last, "the last place can be had");
    }
}

/// Runs may be split anywhere, so poses have several encodings.
void scenarios(Input input) {
    const auto decode = [](Input bytes) { return unpack_scenarios(bytes, scenarios_max); };
    check_repeats(input, decode, [](const std::vector<Scenario>& all) {
        require(all.size() <= scenarios_max, "no more come than may");
        return pack_scenarios(all);
    });
}

} // namespace cd::fuzz
