// Proves that no answer exceeds the message size: a status is shortened, all else fails.
#include "master/net/answers.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/codec/codec.hpp"

#include <gtest/gtest.h>

#include <string>

namespace cd::tests {
namespace {

TEST(Answers, NoAnswerIsLargerThanAMessage) {
    ClusterStatus status;
    status.meshes.resize(100);
    EXPECT_EQ(encode_message(fitting(status)), encode_message(status));
    status.meshes.resize(300'000);
    for (MeshStatus& mesh : status.meshes) {
        mesh.name = std::string(limits::hello_text_bytes_max, 'n');
    }
    const Message shorter = fitting(status);
    const std::size_t kept = std::get<ClusterStatus>(shorter).meshes.size();
    EXPECT_GT(kept, 0u);
    EXPECT_LT(kept, status.meshes.size());
    EXPECT_LE(encode_message(shorter).size(), payload_bytes_max(message_type(shorter)));

    ContactMapAnswer map;
    map.map.resize(1000);
    EXPECT_TRUE(std::holds_alternative<ContactMapAnswer>(fitting(map)));
    map.map.resize(payload_bytes_max(message_type(map)));
    const Message failure = fitting(map);
    EXPECT_EQ(std::get<Failure>(failure).code, ErrorCode::TooLarge);
}

} // namespace
} // namespace cd::tests
