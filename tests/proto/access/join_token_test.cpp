// Proves that exactly the written form of a token is read, and that its proof holds only on its
// connection, for its request, with its secret.
#include "proto/access/join_token.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

JoinToken some_token() {
    return {0x0123456789abcdefu, random_secret(), random_secret()};
}

TEST(JoinToken, IsReadAsItWasWritten) {
    const JoinToken token = some_token();
    const std::string text = to_text(token);
    const auto read = parse_join_token(text);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().id, token.id);
    EXPECT_EQ(read.value().secret, token.secret);
    EXPECT_EQ(read.value().authority, token.authority);
}

TEST(JoinToken, WhatIsNoneIsRefusedAndNotRepeated) {
    const std::string good = to_text(some_token());
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string damaged = good;
        damaged[i] = '?';
        const auto read = parse_join_token(damaged);
        ASSERT_FALSE(read) << i;
        EXPECT_EQ(read.error().code, ErrorCode::BadInput);
        EXPECT_EQ(read.error().detail.find(good.substr(30, 8)), std::string::npos);
    }
    EXPECT_FALSE(parse_join_token(""));
    EXPECT_FALSE(parse_join_token(good + "0"));
    EXPECT_FALSE(parse_join_token(good.substr(1)));
}

TEST(JoinToken, AProofHoldsOnItsConnectionForItsRequestAlone) {
    const JoinToken token = some_token();
    const Sha256 stored = stored_secret(token);
    const Sha256 binding = random_secret();
    const Sha256 proof = join_proof(token, binding, "request");
    EXPECT_TRUE(is_join_proof(proof, stored, binding, "request"));
    EXPECT_FALSE(is_join_proof(proof, stored, random_secret(), "request")) << "replayed";
    EXPECT_FALSE(is_join_proof(proof, stored, binding, "requests"));
    EXPECT_FALSE(is_join_proof(proof, stored_secret(some_token()), binding, "request"));
    EXPECT_FALSE(is_join_proof(Sha256{}, stored, binding, "request"));
    // Neither the master's stored value nor the transmitted one is the secret or proves it.
    EXPECT_NE(stored, token.secret);
    EXPECT_NE(proof, token.secret);
    EXPECT_FALSE(is_join_proof(join_proof({token.id, stored, token.authority}, binding, "request"),
                               stored,
                               binding,
                               "request"));
}

} // namespace
} // namespace cd::tests
