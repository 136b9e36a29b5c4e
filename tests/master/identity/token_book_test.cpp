// Proves that a token admits as many as it says, until it expires, each on a proof of its own, and
// that this outlasts the process without any secret on disk.
#include "master/identity/token_book.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

const WallTime start = WallTime(1'000'000'000s);

struct Joining {
    Sha256 binding = random_secret();
    std::string request = "request";

    [[nodiscard]] TokenBook::Proof proof(const JoinToken& token) const {
        return {token.id, join_proof(token, binding, request), binding, request};
    }
};

JoinToken create(TokenBook& book, std::uint32_t uses, CertifiedRole role = CertifiedRole::Worker) {
    return book.create({role, uses, start + 1h}, Sha256{}, start).value();
}

TEST(TokenBook, ATokenAdmitsItsNumberOfHolders) {
    TokenBook book;
    const JoinToken token = create(book, 2, CertifiedRole::Metrics);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(book.redeem(Joining().proof(token), start).value(), CertifiedRole::Metrics);
    }
    const auto third = book.redeem(Joining().proof(token), start);
    EXPECT_EQ(third.error().code, ErrorCode::Refused);
    EXPECT_THAT(third.error().detail, HasSubstr("exhausted"));
}

TEST(TokenBook, AReplayIsRefusedAndCostsNoUse) {
    TokenBook book;
    const JoinToken token = create(book, 2);
    const Joining joining;
    auto proof = joining.proof(token);
    EXPECT_TRUE(book.redeem(proof, start));
    const Sha256 another = random_secret();
    proof.binding = another;
    const auto replayed = book.redeem(proof, start);
    EXPECT_EQ(replayed.error().code, ErrorCode::Refused);
    EXPECT_THAT(replayed.error().detail, HasSubstr("replayed"));
    EXPECT_TRUE(book.redeem(Joining().proof(token), start));
}

TEST(TokenBook, ATokenExpires) {
    TokenBook book;
    const JoinToken token = create(book, 9);
    EXPECT_TRUE(book.redeem(Joining().proof(token), start + 1h - 1s));
    const auto late = book.redeem(Joining().proof(token), start + 1h);
    EXPECT_THAT(late.error().detail, HasSubstr("expired"));
}

TEST(TokenBook, AnotherSecretOrAnUnknownTokenIsRefused) {
    TokenBook book;
    JoinToken token = create(book, 1);
    token.secret = random_secret();
    EXPECT_EQ(book.redeem(Joining().proof(token), start).error().code, ErrorCode::Refused);
    ++token.id;
    EXPECT_THAT(book.redeem(Joining().proof(token), start).error().detail, HasSubstr("not known"));
}

TEST(TokenBook, TermsHaveBounds) {
    TokenBook book;
    const auto asked = [&](CertifiedRole role, std::uint32_t uses, WallTime until) {
        return book.create({role, uses, until}, Sha256{}, start).has_value();
    };
    EXPECT_FALSE(asked(CertifiedRole::Master, 1, start + 1h));
    EXPECT_FALSE(asked(CertifiedRole::Worker, 0, start + 1h));
    EXPECT_FALSE(asked(CertifiedRole::Worker, limits::token_uses_max + 1, start + 1h));
    EXPECT_FALSE(asked(CertifiedRole::Worker, 1, start));
    EXPECT_FALSE(asked(CertifiedRole::Worker, 1, start + timing::token_life_max + 1s));
    for (std::size_t i = 0; i < limits::tokens_max; ++i) {
        EXPECT_TRUE(asked(CertifiedRole::Worker, 1, start + 1h));
    }
    EXPECT_FALSE(asked(CertifiedRole::Worker, 1, start + 1h));
    EXPECT_TRUE(book.create({CertifiedRole::Worker, 1, start + 3h}, Sha256{}, start + 2h))
        << "expired ones make room";
}

TEST(TokenBook, TheBookOutlastsTheProcessWithoutItsSecrets) {
    TokenBook book;
    const JoinToken token = create(book, 2, CertifiedRole::Admin);
    EXPECT_TRUE(book.redeem(Joining().proof(token), start));
    const std::string text = book.to_text();
    EXPECT_EQ(text.find(to_hex(token.secret)), std::string::npos);
    auto again = TokenBook::parse(text);
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(again.value().redeem(Joining().proof(token), start).value(), CertifiedRole::Admin);
    EXPECT_FALSE(again.value().redeem(Joining().proof(token), start));
}

TEST(TokenBook, ADamagedTextIsRefused) {
    TokenBook book;
    (void)create(book, 2);
    const std::string good = book.to_text();
    for (const std::string& text :
         {std::string("nonsense\n"),
          good.substr(0, good.size() - 8),
          good + "1 2 3\n",
          good.substr(0, good.size() - 1) + "0000000\n", // An impossible year.
          good.substr(good.find('\n') + 1),
          std::string()}) {
        EXPECT_EQ(TokenBook::parse(text).error().code, ErrorCode::BadInput) << text;
    }
}

TEST(TokenBook, EachFlippedBitIsNoticed) {
    TokenBook book;
    const JoinToken token = create(book, 1);
    EXPECT_TRUE(book.redeem(Joining().proof(token), start));
    std::string text = book.to_text();
    ASSERT_TRUE(TokenBook::parse(text));
    for (char& letter : text) {
        for (int bit = 0; bit < 8; ++bit) {
            letter = static_cast<char>(letter ^ (1 << bit));
            EXPECT_FALSE(TokenBook::parse(text)) << text;
            letter = static_cast<char>(letter ^ (1 << bit));
        }
    }
}

} // namespace
} // namespace cd::tests
