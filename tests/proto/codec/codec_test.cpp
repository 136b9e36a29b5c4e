// Proves that every message survives the wire, that its bytes do not change unnoticed, and that
// invalid bytes only end in an error: no crash, no large allocation; accepted bytes are exactly
// what the encoder would write.
#include "proto/codec/codec.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/limits/wire.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/support/damage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using Messages = std::initializer_list<Message>;

// Bytes that this version writes for `sample_messages`. A change here is a new protocol version.
struct Golden {
    std::string_view name;
    std::size_t bytes;
    std::string_view hash;
};
constexpr std::array<Golden, std::variant_size_v<Message>> golden{{
    {"hello", 103, "f28bf34859460c84"},
    {"welcome", 124, "c157decedac7a82f"},
    {"failure", 17, "b9807aeea9fe9795"},
    {"heartbeat", 105, "83c163ab958245e5"},
    {"add tree", 81, "396e36e8490fc0d5"},
    {"remove tree", 8, "f13ee6ed54ea2aae"},
    {"subtrees", 144, "da0189eff0ecbd68"},
    {"work unit", 150, "2c20d0c30ffc3ea2"},
    {"drain", 0, "e3b0c44298fc1c14"},
    {"terminate", 28, "d6d079848cb90ca3"},
    {"want subtrees", 28, "22f2d0e6837120f2"},
    {"results", 238, "0869fa9e9df46df0"},
    {"end of task", 8, "aae89fc0f03e2959"},
    {"evicted", 24, "21c53776fb477163"},
    {"meshes query", 72, "e1381bfba176d2ec"},
    {"meshes missing", 40, "6a083ddafa5d3162"},
    {"mesh part", 133, "2325c9eac764b872"},
    {"mesh stored", 32, "ae216c2ef5247a37"},
    {"submit", 629, "b4ab4c69d3873bd7"},
    {"poses part", 161, "df3fb88cf20ca156"},
    {"poses end", 0, "e3b0c44298fc1c14"},
    {"accepted", 8, "35be322d094f9d15"},
    {"watch", 8, "f0a0278e4372459c"},
    {"job status", 601, "5ef95e61008d05fb"},
    {"status query", 0, "e3b0c44298fc1c14"},
    {"cluster status", 1098, "669a744d54ca2a0f"},
    {"results query", 32, "73e200e2b048c86d"},
    {"results part", 107, "4eafd0bf67a8904f"},
    {"cancel", 17, "6450d3157de527b9"},
    {"fetch from peers", 170, "a0d47f54a15913e3"},
    {"held", 24, "ed580f119631830c"},
    {"fetch failed", 33, "b221f708a2001c78"},
    {"peer fetch", 64, "1fa3b1fe14bda8bc"},
    {"peer fetched", 21, "81af26b24d9034b4"},
    {"explain", 16, "609f0a17cfd7829b"},
    {"explained", 263, "01af8fa51f9e2071"},
    {"add job", 162, "a662b7bc8539d8c0"},
    {"remove job", 8, "d86e8112f3c4c444"},
    {"results kept", 32, "85f896738b831cb7"},
    {"holding", 72, "e1381bfba176d2ec"},
    {"join", 72, "dd181e348f65f2e4"},
    {"renew", 15, "b8682712f5ce92e8"},
    {"certified", 48, "d7f558c7fad6ff0a"},
    {"token create", 13, "10083b346e6438bc"},
    {"token created", 12, "58ed39fec02eb736"},
    {"inventory", 120, "002e149f06099adc"},
    {"drop scenario", 24, "f5f38eb8784416cd"},
    {"recall", 40, "c4be813caf236978"},
    {"recalled", 32, "c779e5841532473c"},
    {"hint", 32, "efd67ebf8cf6f660"},
    {"contact map query", 9, "39c4bda09747729a"},
    {"contact map", 55, "46a208d4be794e94"},
    {"job query", 8, "6cc16abd70eefb90"},
    {"job description", 645, "2553e0b388380301"},
    {"mesh query", 40, "f7d21511aea24080"},
    {"mesh bytes", 116, "fccdf5c70818c47b"},
    {"poses query", 32, "f1efd35118dc9d45"},
    {"job poses", 141, "934b0d82990af873"},
    {"remove", 9, "39c4bda09747729a"},
    {"remove mesh", 32, "ae216c2ef5247a37"},
    {"removed", 8, "5fd1b79ebdef9619"},
    {"drain workers", 25, "4d17a7068176c24d"},
    {"draining", 24, "0db93153587a4d4c"},
    {"set priority", 12, "6b0468e82586b6ac"},
}};

/// Why these bytes are not this message; nothing if they are.
std::string refusal_of(const Message& message, const Bytes& bytes) {
    const auto decoded = decode_message(message_type(message), bytes);
    return decoded ? "" : decoded.error().detail;
}

void expect_refused(std::uint16_t type, std::span<const std::byte> payload) {
    const auto decoded = decode_message(type, payload);
    const auto* hello = decoded ? std::get_if<Hello>(&decoded.value()) : nullptr;
    if (hello != nullptr && hello->version != protocol_version) {
        return; // Only the version was read.
    }
    if (decoded) {
        // Accepted bytes contain nothing beyond the message.
        const Bytes again = encode_message(decoded.value());
        EXPECT_TRUE(std::equal(again.begin(), again.end(), payload.begin(), payload.end()))
            << message_name(type);
    } else {
        EXPECT_EQ(decoded.error().code, ErrorCode::BadFrame);
    }
}

TEST(Codec, NumbersAndNamesFollowTheOrderOfTheVariant) {
    EXPECT_EQ(message_type(Hello{}), 1);
    EXPECT_EQ(message_type(SetPriority{}), std::variant_size_v<Message>);
    EXPECT_EQ(message_name(message_type(WorkUnit{})), "work unit");
    EXPECT_EQ(message_name(message_type(EndOfTask{})), "end of task");
    EXPECT_EQ(message_name(message_type(ResultsPart{})), "results part");
    EXPECT_EQ(message_name(0), "unknown");
    EXPECT_EQ(payload_bytes_max(0), 0u);
    EXPECT_EQ(payload_bytes_max(std::variant_size_v<Message> + 1), 0u);
    EXPECT_EQ(payload_bytes_max(message_type(Heartbeat{})), limits::message_control_bytes_max);
}

TEST(Codec, WhatEndsSomethingDoesNotOvertakeIt) {
    for (const Message& message : Messages{AddTree{},
                                           Subtrees{},
                                           WorkUnit{},
                                           Hint{},
                                           RemoveTree{},
                                           Drain{},
                                           Results{},
                                           EndOfTask{},
                                           Recall{},
                                           Recalled{},
                                           Submit{},
                                           PosesPart{},
                                           PosesEnd{}}) {
        EXPECT_TRUE(travels_as_data(message_type(message))) << message.index();
    }
    for (const Message& message :
         Messages{Heartbeat{}, Terminate{}, WantSubtrees{}, Evicted{}, Failure{}, JobStatus{}}) {
        EXPECT_FALSE(travels_as_data(message_type(message))) << message.index();
    }
}

TEST(Codec, EveryMessageComesBackAsItWas) {
    for (const Message& message : sample_messages()) {
        const Bytes bytes = encode_message(message);
        const auto decoded = decode_message(message_type(message), bytes);
        ASSERT_TRUE(decoded) << decoded.error().detail;
        ASSERT_EQ(decoded.value().index(), message.index());
        EXPECT_EQ(encode_message(decoded.value()), bytes) << message_name(message_type(message));
    }
}

TEST(Codec, MembersComeBackInTheirPlaces) {
    const Bytes bytes = encode_message(some_batch());
    const auto decoded = decode_message(message_type(WorkUnit{}), bytes);
    ASSERT_TRUE(decoded);
    const auto& batch = std::get<WorkUnit>(decoded.value());
    EXPECT_EQ(batch.pair_offsets, some_batch().pair_offsets);
    EXPECT_EQ(batch.pairs, some_batch().pairs);
    EXPECT_EQ(batch.scenarios, some_batch().scenarios);
}

TEST(Codec, TheBytesOfEachMessageAreThoseOfThisVersion) {
    const auto samples = sample_messages();
    ASSERT_EQ(samples.size(), golden.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(samples[i].index(), i);
        const Bytes bytes = encode_message(samples[i]);
        EXPECT_EQ(message_name(message_type(samples[i])), golden[i].name);
        EXPECT_EQ(bytes.size(), golden[i].bytes) << golden[i].name;
        EXPECT_EQ(to_short_hex(sha256(bytes)), golden[i].hash) << golden[i].name;
    }
}

TEST(Codec, NumbersAreLittleEndianAndCountsHaveEightBytes) {
    const Bytes bytes = encode_message(WantSubtrees{TreeId{0x0102}, {3, 0x0405}});
    const std::array<unsigned, 24> expected{2, 1, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0,
                                            0, 0, 0, 0, 3, 0, 0, 0, 5, 4, 0, 0};
    ASSERT_EQ(bytes.size(), expected.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        EXPECT_EQ(std::to_integer<unsigned>(bytes[i]), expected[i]) << i;
    }
}

TEST(Codec, EveryTruncationAndEveryExtraByteIsRefused) {
    for (const Message& message : sample_messages()) {
        const std::uint16_t type = message_type(message);
        SCOPED_TRACE(message_name(type));
        expect_no_other_length(encode_message(message), [type](std::span<const std::byte> bytes) {
            return decode_message(type, bytes);
        });
    }
}

TEST(Codec, FlippedBytesAreRefusedOrMeanExactlyWhatTheySay) {
    std::mt19937_64 random(1);
    for (const Message& message : sample_messages()) {
        const std::uint16_t type = message_type(message);
        const Bytes bytes = encode_message(message);
        for (int round = 0; round < 400 && !bytes.empty(); ++round) {
            Bytes damaged = bytes;
            for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
                damaged[random() % damaged.size()] = static_cast<std::byte>(random());
            }
            expect_refused(type, damaged);
        }
    }
}

TEST(Codec, RandomBytesOfAnyTypeAreRefusedOrMeanExactlyWhatTheySay) {
    std::mt19937_64 random(2);
    for (int round = 0; round < 5000; ++round) {
        Bytes bytes(random() % 200);
        for (std::byte& byte : bytes) {
            // Small numbers make sizes that fit now and then.
            byte = static_cast<std::byte>(random() % 4 == 0 ? random() : random() % 3);
        }
        expect_refused(static_cast<std::uint16_t>(random() % 32), bytes);
    }
}

TEST(Codec, AnAbsurdSizeAllocatesNothing) {
    // Without a refusal before the allocation, this ends in bad_alloc or gigabytes.
    for (const std::uint64_t size : {std::uint64_t{1} << 60,
                                     std::uint64_t{1} << 33,
                                     std::numeric_limits<std::uint64_t>::max(),
                                     std::uint64_t{100}}) {
        ByteWriter out;
        out.put(std::uint64_t{1}); // The tree.
        out.put(size);
        out.put(std::uint64_t{0});
        for (const Message& message : Messages{AddTree{}, Subtrees{}, WantSubtrees{}, Evicted{}}) {
            EXPECT_FALSE(decode_message(message_type(message), out.bytes()));
        }
        ByteWriter list;
        list.put(size);
        for (const Message& message :
             Messages{MeshesQuery{}, MeshesMissing{}, PosesPart{}, Terminate{}, ClusterStatus{}}) {
            EXPECT_FALSE(decode_message(message_type(message), list.bytes()));
        }
    }
}

TEST(Codec, ValuesOutOfRangeAreRefused) {
    Bytes hello = encode_message(Hello{});
    hello[4] = std::byte{5}; // The role, after the two versions.
    EXPECT_FALSE(decode_message(message_type(Hello{}), hello));

    Bytes results = encode_message(Results{TaskId{1}, JobId{1}, 0, {}, true, {}, 1.0, 0, {}, {}});
    // The value of 1.0 before the sequence, the job's cost and the map's length becomes a NaN.
    const std::size_t behind = 2 * sizeof(std::uint64_t) + sizeof(BlockTraffic);
    results[results.size() - behind - 1] = std::byte{0x7f};
    results[results.size() - behind - 2] = std::byte{0xff};
    EXPECT_FALSE(decode_message(message_type(Results{}), results));
}

// The encoder asserts valid messages, so these are broken on the wire.
struct BatchBytes {
    Bytes bytes = encode_message(some_batch());
    std::size_t results_wait = bytes.size() - 4;
    std::size_t pairs = results_wait - 3 * 8;
    std::size_t offsets = pairs - 8 - 4 * 4;

    void set(std::size_t place, std::uint32_t value) {
        std::memcpy(bytes.data() + place, &value, sizeof value);
    }
    [[nodiscard]] std::string refusal() const { return refusal_of(WorkUnit{}, bytes); }
};

TEST(Codec, ABatchWhoseOffsetsDoNotFitItsPairsIsRefused) {
    EXPECT_EQ(BatchBytes().refusal(), "");
    BatchBytes first;
    first.set(first.offsets, 1);
    EXPECT_THAT(first.refusal(), HasSubstr("span"));
    BatchBytes last;
    last.set(last.offsets + 12, 2);
    EXPECT_THAT(last.refusal(), HasSubstr("span"));
    BatchBytes descending;
    descending.set(descending.offsets + 4, 3);
    EXPECT_THAT(descending.refusal(), HasSubstr("descend"));
    BatchBytes beyond;
    beyond.set(beyond.offsets + 8, 0xffffffff);
    EXPECT_THAT(beyond.refusal(), HasSubstr("descend"));
    BatchBytes repeated;
    repeated.set(repeated.pairs, 1);
    repeated.set(repeated.pairs + 4, 0);
    EXPECT_THAT(repeated.refusal(), HasSubstr("ascend"));
}

TEST(Codec, ABatchWhoseResultsWaitTooLongIsRefused) {
    BatchBytes batch;
    batch.set(batch.results_wait, 10'000);
    EXPECT_EQ(batch.refusal(), "");
    batch.set(batch.results_wait, 10'001);
    EXPECT_THAT(batch.refusal(), HasSubstr("wait too long"));
}

TEST(Codec, ARangeIsOfSomeScenariosAndOfABoundedNumber) {
    Bytes bytes = encode_message(WorkUnit{TaskId{1}, JobId{2}, 0, 4, {}, {}, {}});
    const std::size_t count = 3 * 8; // After two ids and the first position.
    EXPECT_TRUE(decode_message(message_type(WorkUnit{}), bytes));
    bytes[count] = std::byte{0};
    EXPECT_FALSE(decode_message(message_type(WorkUnit{}), bytes));
    bytes[count + 4] = std::byte{1};
    EXPECT_FALSE(decode_message(message_type(WorkUnit{}), bytes));
}

TEST(Codec, RootsThatDoNotAscendAreRefused) {
    Bytes bytes = encode_message(WantSubtrees{TreeId{2}, {1, 5}});
    bytes[bytes.size() - 4] = std::byte{1};
    EXPECT_FALSE(decode_message(message_type(WantSubtrees{}), bytes));
}

TEST(Codec, AFetchThatGaveAllBlocksHasNotFailed) {
    Bytes bytes = encode_message(FetchFailed{TreeId{2}, {1, 5}, WorkerId{3}, PeerOutcome::Busy});
    bytes.back() = static_cast<std::byte>(PeerOutcome::Given);
    EXPECT_FALSE(decode_message(message_type(FetchFailed{}), bytes));
}

TEST(Codec, NoTokenMakesAMaster) {
    Bytes bytes = encode_message(TokenCreate{CertifiedRole::Worker, 3600, 1});
    bytes.front() = static_cast<std::byte>(CertifiedRole::Master);
    EXPECT_FALSE(decode_message(message_type(TokenCreate{}), bytes));
}

TEST(Codec, AMeshPartLiesWithinItsMesh) {
    Bytes bytes = encode_message(MeshPart{some_hash(1), "", 100, 40, some_bytes(60)});
    EXPECT_TRUE(decode_message(message_type(MeshPart{}), bytes));
    bytes[32 + 8 + 8] = std::byte{41}; // The offset.
    EXPECT_FALSE(decode_message(message_type(MeshPart{}), bytes));
}

/// Returns whether a message is accepted if these eight bytes are replaced by another number.
template <class T>
bool is_taken_with(const Message& message, T marker, T number) {
    Bytes bytes = encode_message(message);
    const auto wanted = std::as_bytes(std::span(&marker, 1));
    const auto found = std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end());
    EXPECT_NE(found, bytes.end());
    std::ranges::copy(std::as_bytes(std::span(&number, 1)), found);
    return decode_message(message_type(message), bytes).has_value();
}

TEST(Codec, ATimeOfComputingIsOneThatCanBeAddedUp) {
    Results results;
    results.compute_seconds = 1234.5678;
    for (const double seconds : {0.0, 1e-9, 1e7}) {
        EXPECT_TRUE(is_taken_with(results, 1234.5678, seconds)) << seconds;
    }
    for (const double seconds : {-1.0, 1.0001e7, 1.7e308, std::nan("")}) {
        EXPECT_FALSE(is_taken_with(results, 1234.5678, seconds)) << seconds;
    }
}

TEST(Codec, AClearanceIsFiniteAndNotNegative) {
    AddJob add;
    Submit submit;
    add.query.clearance = submit.query.clearance = 1234.5678;
    for (const Message& message : Messages{add, submit, JobDescription{JobId{8}, 9, submit}}) {
        for (const double clearance : {0.0, 5e-324, 1.7e308}) {
            EXPECT_TRUE(is_taken_with(message, 1234.5678, clearance)) << clearance;
        }
        for (const double clearance :
             {-5e-324, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            EXPECT_FALSE(is_taken_with(message, 1234.5678, clearance)) << clearance;
        }
    }
}

TEST(Codec, AnUpToIsFiniteAndNotNegative) {
    AddJob add;
    Submit submit;
    add.query = submit.query = some_distance_query();
    add.query.up_to = submit.query.up_to = 1234.5678;
    for (const Message& message : Messages{add, submit, JobDescription{JobId{8}, 9, submit}}) {
        for (const double up_to : {0.0, 5e-324, 1.7e308}) {
            EXPECT_TRUE(is_taken_with(message, 1234.5678, up_to)) << up_to;
        }
        for (const double up_to :
             {-5e-324, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            EXPECT_FALSE(is_taken_with(message, 1234.5678, up_to)) << up_to;
        }
    }
}

/// Returns the first byte in which the messages of two queries differ.
std::size_t first_difference(const Query& one, const Query& other) {
    AddJob add;
    add.query = one;
    const Bytes bytes = encode_message(add);
    add.query = other;
    const Bytes others = encode_message(add);
    const auto [at, at_other] = std::ranges::mismatch(bytes, others);
    return static_cast<std::size_t>(at - bytes.begin());
}

TEST(Codec, AQueryHasAQuestionThatExistsAndAllowsTheRest) {
    Query contacts;
    contacts.level = Level::Any;
    Query distance = contacts;
    distance.question = Question::Distance;
    Query counted = contacts;
    counted.level = Level::Count;
    Query limited = contacts;
    limited.limit_pairs = 1;
    distance.up_to = 2.5;
    AddJob add;
    add.query = distance;
    const Bytes bytes = encode_message(add);
    const auto refusal_with = [&](const Query& other, std::uint8_t value) {
        Bytes changed = bytes;
        changed.at(first_difference(contacts, other)) = std::byte{value};
        return refusal_of(add, changed);
    };
    EXPECT_EQ(refusal_with(distance, 1), "");
    EXPECT_THAT(refusal_with(distance, 0), HasSubstr("an up_to without the question"));
    EXPECT_THAT(refusal_with(distance, 2), HasSubstr("an up_to without the question"));
    EXPECT_EQ(refusal_with(counted, 0), "");
    EXPECT_THAT(refusal_with(counted, 1), HasSubstr("a distance with a level"));
    EXPECT_THAT(refusal_with(limited, 1), HasSubstr("limit_pairs"));
}

TEST(Codec, AResolutionIsPositiveAndFinite) {
    AddJob add;
    Submit submit;
    add.query = submit.query = some_motion_query();
    add.query.motion->resolution = submit.query.motion->resolution = 1234.5678;
    for (const Message& message : Messages{add, submit, JobDescription{JobId{8}, 9, submit}}) {
        for (const double resolution : {5e-324, 1.7e308}) {
            EXPECT_TRUE(is_taken_with(message, 1234.5678, resolution)) << resolution;
        }
        for (const double resolution :
             {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
            EXPECT_FALSE(is_taken_with(message, 1234.5678, resolution)) << resolution;
        }
    }
}

TEST(Codec, FirstHitsBelongToTheQuestionOfShots) {
    Query all = some_shots_query();
    all.first_hits = false;
    AddJob add;
    add.query = some_shots_query();
    const Bytes bytes = encode_message(add);
    const auto read = decode_message(message_type(add), bytes);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(std::get<AddJob>(read.value()).query.question, Question::Shots);
    EXPECT_TRUE(std::get<AddJob>(read.value()).query.first_hits);
    Query counted = all;
    counted.question = Question::Contacts;
    Bytes changed = bytes;
    changed.at(first_difference(all, counted)) = std::byte{0};
    EXPECT_THAT(refusal_of(add, changed), HasSubstr("first hits without the question of shots"));
}

TEST(Codec, AWorkerHasNoMoreThreadsThanThereMayBe) {
    Hello hello;
    hello.threads = 0xabc;
    EXPECT_TRUE(is_taken_with<std::uint32_t>(hello, 0xabc, limits::worker_threads_max));
    EXPECT_FALSE(is_taken_with<std::uint32_t>(hello, 0xabc, limits::worker_threads_max + 1));
    EXPECT_FALSE(is_taken_with<std::uint32_t>(hello, 0xabc, 0xffffffff));
}

TEST(Codec, AWeightIsAboveZeroAndBounded) {
    Hello hello;
    for (const double weight : {0.5, 1000.0}) {
        hello.weight = weight;
        EXPECT_TRUE(decode_message(message_type(hello), encode_message(hello)));
    }
    // A refused message cannot be encoded either; its weight precedes three numbers, a text's
    // length and another number.
    Bytes bytes = encode_message(hello);
    for (const double weight : {0.0, -1.0, 1001.0}) {
        std::memcpy(bytes.data() + bytes.size() - 6 * sizeof(weight), &weight, sizeof(weight));
        EXPECT_FALSE(decode_message(message_type(hello), bytes)) << weight;
    }
}

TEST(Codec, AHelloOfAnotherVersionIsReadForVersionRoleAndName) {
    for (const int step : {-1, 0, 1}) {
        const int other = protocol_version + step;
        Hello hello;
        hello.version = static_cast<std::uint16_t>(other);
        hello.role = Role::Worker;
        hello.name = "node";
        hello.build = "1.2";
        Bytes bytes = encode_message(hello);
        bytes.insert(bytes.end(), 20, std::byte{1});
        const auto decoded = decode_message(message_type(hello), bytes);
        ASSERT_EQ(decoded.has_value(), other != protocol_version);
        if (decoded) {
            EXPECT_EQ(std::get<Hello>(decoded.value()).version, other);
            EXPECT_EQ(std::get<Hello>(decoded.value()).role, Role::Worker);
            EXPECT_EQ(std::get<Hello>(decoded.value()).name, "node");
            EXPECT_EQ(std::get<Hello>(decoded.value()).build, "");
        }
    }
}

TEST(Codec, RecordsOfResultsAreOfAscendingScenariosOfTheirRange) {
    const auto refusal = [](std::vector<ScenarioInterval> held, std::uint32_t count) {
        ResultsPart good{JobId{1}, 10, 20, {{10, 2}, {15, 5}}, 7, {}};
        Bytes bytes = encode_message(good);
        const std::size_t runs = 3 * 8 + 8; // After the job, the range and the number of runs.
        const auto set = [&](std::size_t at, const auto& value) {
            std::memcpy(bytes.data() + at, &value, sizeof value);
        };
        for (std::size_t i = 0; i < held.size(); ++i) {
            set(runs + 16 * i, held[i].first);
            set(runs + 16 * i + 8, held[i].count);
        }
        set(runs + 16 * held.size(), count);
        return refusal_of(good, bytes);
    };
    EXPECT_EQ(refusal({{10, 2}, {15, 5}}, 7), "");
    EXPECT_THAT(refusal({{9, 2}, {15, 5}}, 7), HasSubstr("outside"));
    EXPECT_THAT(refusal({{10, 2}, {15, 6}}, 8), HasSubstr("outside"));
    EXPECT_THAT(refusal({{10, 2}, {11, 5}}, 7), HasSubstr("do not ascend"));
    EXPECT_THAT(refusal({{10, 2}, {15, ~0ull}}, 7), HasSubstr("outside"));
    EXPECT_THAT(refusal({{10, 2}, {15, 5}}, 8), HasSubstr("another number of records"));
}

TEST(Codec, ASampleIsBounded) {
    const auto refusal = [](const auto& query, std::uint64_t sample) {
        Bytes bytes = encode_message(query);
        std::memcpy(bytes.data() + bytes.size() - sizeof sample, &sample, sizeof sample);
        return refusal_of(query, bytes);
    };
    EXPECT_EQ(refusal(ResultsQuery{}, limits::page_sample_max), "");
    EXPECT_THAT(refusal(ResultsQuery{}, limits::page_sample_max + 1), HasSubstr("too many"));
    EXPECT_EQ(refusal(PosesQuery{}, limits::page_sample_max), "");
    EXPECT_THAT(refusal(PosesQuery{}, limits::page_sample_max + 1), HasSubstr("too many"));
}

TEST(Codec, AStrategyIsABoundedName) {
    const auto refusal = [](std::string_view name) {
        Explained explained;
        explained.strategy = std::string(name.size(), 'a');
        Bytes bytes = encode_message(explained);
        std::memcpy(bytes.data() + 3 * 8, name.data(), name.size()); // After two ids and its size.
        return refusal_of(explained, bytes);
    };
    EXPECT_EQ(refusal("best-match-2"), "");
    EXPECT_EQ(refusal(std::string(limits::strategy_name_bytes_max, 'z')), "");
    EXPECT_FALSE(is_strategy_name(std::string(limits::strategy_name_bytes_max + 1, 'z')));
    for (const std::string_view name : {"Best", "best match", "best\n", "best_match"}) {
        EXPECT_THAT(refusal(name), HasSubstr("strategy's name"));
    }
    EXPECT_FALSE(is_strategy_name(""));
}

} // namespace
} // namespace cd::tests
