// Proves that any records are unpacked byte for byte; that lists of pairs take few bytes; and that
// arbitrary bytes end in an error or in records within the limit.

#include "common/job/result/packed_records.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"
#include "common/job/result/result.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace cd::tests {
namespace {

constexpr std::uint64_t unlimited = std::uint64_t{1} << 30;

void append(Bytes& records, const Bytes& record) {
    const auto size = static_cast<std::uint32_t>(record.size());
    const auto size_bytes = std::as_bytes(std::span(&size, 1));
    records.insert(records.end(), size_bytes.begin(), size_bytes.end());
    records.insert(records.end(), record.begin(), record.end());
}

ScenarioResult some_result(std::mt19937_64& random, std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.level = static_cast<Level>(random() % 4);
    if (random() % 10 == 0) {
        result.kind = ScenarioClass::Failed;
        result.failure = "scenario lost";
        return result;
    }
    if (result.level == Level::Any || random() % 4 == 0) {
        if (result.level == Level::Contacts) {
            result.point_offsets = {0};
        }
        return result;
    }
    result.kind = random() % 3 == 0 ? ScenarioClass::Undecided : ScenarioClass::Cross;
    result.pair_count = 100;
    if (result.level == Level::Count) {
        return result;
    }
    std::uint32_t a = 0;
    result.point_offsets = result.level == Level::Contacts ? std::vector<std::uint32_t>{0}
                                                           : std::vector<std::uint32_t>{};
    while (result.pairs.size() < random() % 100) {
        a += static_cast<std::uint32_t>(1 + random() % (random() % 8 == 0 ? 1u << 28 : 3u));
        std::uint32_t b = static_cast<std::uint32_t>(random());
        for (std::uint64_t more = random() % 4; more > 0 && b < UINT32_MAX - 1000; --more) {
            result.pairs.push_back({a, b, static_cast<PairClass>(1 + random() % 3)});
            b += static_cast<std::uint32_t>(1 + random() % 300);
            if (result.level == Level::Contacts) {
                result.point_origins.push_back(random_point(random, 1));
                result.points.push_back(random_point(random, 1));
                result.point_offsets.push_back(static_cast<std::uint32_t>(result.points.size()));
            }
        }
    }
    return result;
}

Bytes some_records(std::mt19937_64& random, std::size_t count) {
    Bytes records;
    for (std::size_t i = 0; i < count; ++i) {
        append(records, encode_result(some_result(random, i)));
    }
    return records;
}

} // namespace

TEST(PackedRecords, ComeBackByteForByte) {
    for (SeededRandom random : seeds(200)) {
        const Bytes records = some_records(random, random.seed % 20);
        const auto unpacked = unpack_records(pack_records(records), unlimited);
        ASSERT_TRUE(unpacked) << random.seed << ' ' << unpacked.error().detail;
        EXPECT_EQ(unpacked.value(), records);
    }
}

TEST(PackedRecords, NeedNotBeCanonical) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 300; ++round) {
        ScenarioResult result = some_result(random, 7);
        std::shuffle(result.pairs.begin(), result.pairs.end(), random);
        Bytes record = encode_result(result);
        for (std::uint64_t flips = random() % 4; flips > 0; --flips) {
            record[random() % record.size()] ^= static_cast<std::byte>(random());
        }
        record.resize(random() % 2 == 0 ? record.size() : random() % record.size());
        Bytes records;
        append(records, record);
        append(records, {});
        const auto unpacked = unpack_records(pack_records(records), unlimited);
        ASSERT_TRUE(unpacked) << round;
        EXPECT_EQ(unpacked.value(), records) << round;
    }
}

TEST(PackedRecords, ListsOfPairsTakeFewBytes) {
    // Triangles of a torus in strips, as files order them.
    const ObbTree tree = [] {
        ThreadPool pool(1);
        return build_tree(share(make_torus(1, 0.4, 60, 30)), BuildOptions{}, pool);
    }();
    std::mt19937_64 random(5);
    Bytes records;
    std::size_t pairs = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
        Scenario scenario;
        scenario.index = i;
        scenario.poses.b = make_pose(random, 0.8);
        const ScenarioResult result = run_scenario(tree, tree, scenario, Query{}).result;
        pairs += result.pairs.size();
        append(records, encode_result(result));
    }
    ASSERT_GT(pairs, 5000u);
    const auto bytes = static_cast<double>(pack_records(records).size());
    EXPECT_LT(bytes, 2.6 * static_cast<double>(pairs));
    EXPECT_LT(bytes, 0.8 * static_cast<double>(compress(records, compression_level_fast).size()));
}

TEST(PackedRecords, StayWithinTheLimit) {
    std::mt19937_64 random(6);
    const Bytes records = some_records(random, 20);
    const Bytes packed = pack_records(records);
    EXPECT_TRUE(unpack_records(packed, records.size()));
    const auto refused = unpack_records(packed, records.size() - 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
}

TEST(PackedRecords, AreSentPlainWithinAHost) {
    std::mt19937_64 random(9);
    const Bytes records = some_records(random, 20);
    for (const bool is_within_host : {false, true}) {
        const SentRecords sent = records_to_send(records, is_within_host);
        EXPECT_EQ(sent.are_packed, !is_within_host);
        EXPECT_EQ(sent.bytes, is_within_host ? records : pack_records(records));
        Bytes unpacked;
        const auto received = received_records(sent.bytes, sent.are_packed, unpacked);
        ASSERT_TRUE(received);
        EXPECT_TRUE(std::ranges::equal(received.value(), records));
    }
}

TEST(PackedRecords, ManyBytesAreSentPackedEvenWithinAHost) {
    Bytes records;
    append(records, Bytes(limits::plain_records_bytes_max - sizeof(std::uint32_t)));
    EXPECT_FALSE(records_to_send(records, true).are_packed);
    append(records, {});
    const SentRecords sent = records_to_send(records, true);
    EXPECT_TRUE(sent.are_packed);
    Bytes unpacked;
    const auto received = received_records(sent.bytes, sent.are_packed, unpacked);
    ASSERT_TRUE(received);
    EXPECT_TRUE(std::ranges::equal(received.value(), records));
}

/// Returns the packed bytes with a column changed before its compression.
template <class Change>
Bytes with_column(const Bytes& packed, std::size_t changed, const Change& change) {
    ByteReader in(packed);
    std::array<std::uint64_t, 8> sizes{};
    for (std::uint64_t& size : sizes) {
        size = get_varint(in).value();
    }
    std::array<Bytes, 8> columns;
    ByteWriter out;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto compressed = in.get_bytes(sizes[i]);
        columns[i] = Bytes(compressed.begin(), compressed.end());
        if (i == changed && !compressed.empty()) {
            Bytes column = decompress(compressed, unlimited).value();
            change(column);
            columns[i] = compress(column, compression_level_fast);
        }
        put_varint(out, columns[i].size());
    }
    Bytes bytes = out.take();
    for (const Bytes& column : columns) {
        bytes.insert(bytes.end(), column.begin(), column.end());
    }
    return bytes;
}

TEST(PackedRecords, DamageEndsInAnErrorOrInRecords) {
    std::mt19937_64 random(7);
    const Bytes records = some_records(random, 12);
    const Bytes good = pack_records(records);
    std::size_t unpacked_count = 0;
    for (int round = 0; round < 5'000; ++round) {
        const Bytes bytes = with_column(good, random() % 8, [&](Bytes& column) {
            for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
                column[random() % column.size()] ^= static_cast<std::byte>(1u << (random() % 8));
            }
            column.resize(column.size() - (random() % 4 == 0 ? 1 : 0));
        });
        const auto unpacked = unpack_records(bytes, 3 * records.size());
        unpacked_count += unpacked ? 1 : 0;
        EXPECT_TRUE(!unpacked || unpacked.value().size() <= 3 * records.size());
    }
    EXPECT_GT(unpacked_count, 500u);
}

TEST(PackedRecords, DamageOfWhatIsCompressedDoesNoHarm) {
    std::mt19937_64 random(8);
    const Bytes good = pack_records(some_records(random, 12));
    for (int round = 0; round < 5'000; ++round) {
        Bytes bytes = good;
        bytes[random() % (round % 2 == 0 ? 20 : bytes.size())] ^=
            static_cast<std::byte>(1u << (random() % 8));
        (void)unpack_records(bytes, unlimited);
    }
    for (std::size_t size = 0; size < good.size(); ++size) {
        EXPECT_FALSE(unpack_records(std::span(good).first(size), unlimited)) << size;
    }
}

} // namespace cd::tests
