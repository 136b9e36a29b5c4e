// Proves that a section file is read back as written, and that any other file is rejected: shorter,
// longer or changed anywhere, or of another kind.
#include "common/core/files/section_file.hpp"

#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace cd::tests {
namespace {

constexpr FileKind kind{0x1122334455667788, 3};

class SectionFileTest : public testing::Test {
  protected:
    SectionFileTest() { std::iota(numbers_.begin(), numbers_.end(), 7u); }

    [[nodiscard]] Status write() const {
        const std::array<Section, 4> sections{std::as_bytes(std::span(numbers_)),
                                              Section(),
                                              std::as_bytes(std::span(doubles_)),
                                              Section()};
        return write_section_file(path_, {kind, key_}, sections, Durability::Unsynced);
    }
    [[nodiscard]] auto open() const { return SectionFile::open(path_, {kind, key_}, 4); }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "file";
    Sha256 key_ = sha256({});
    std::vector<std::uint32_t> numbers_ = std::vector<std::uint32_t>(101);
    std::vector<double> doubles_{0.5, -0.0, 1e300};
};

TEST_F(SectionFileTest, ComesBackAsItWas) {
    ASSERT_TRUE(write());
    const auto file = open();
    ASSERT_TRUE(file) << file.error().detail;
    const auto numbers = file.value()->array<std::uint32_t>(0);
    ASSERT_TRUE(numbers);
    EXPECT_TRUE(std::ranges::equal(numbers.value(), numbers_));
    EXPECT_TRUE(file.value()->section(1).empty());
    EXPECT_TRUE(std::ranges::equal(file.value()->array<double>(2).value(), doubles_));
    EXPECT_TRUE(file.value()->section(3).empty());
    // Arrays are aligned for use in place.
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(file.value()->section(2).data()) % 64, 0u);
    using Seven = std::array<std::byte, 7>;
    EXPECT_FALSE(file.value()->array<Seven>(2)) << "24 bytes hold no whole number of them";
}

TEST_F(SectionFileTest, StaysReadableWhenItIsReplacedOrRemoved) {
    ASSERT_TRUE(write());
    const auto file = open();
    ASSERT_TRUE(file);
    numbers_[0] = 99;
    ASSERT_TRUE(write());
    EXPECT_EQ(file.value()->array<std::uint32_t>(0).value()[0], 7u);
    EXPECT_EQ(open().value()->array<std::uint32_t>(0).value()[0], 99u);
    std::filesystem::remove(path_);
    EXPECT_EQ(file.value()->array<std::uint32_t>(0).value()[100], 107u);
}

TEST_F(SectionFileTest, AnyChangedByteIsDamage) {
    ASSERT_TRUE(write());
    const std::string whole = read_text(path_);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string text = whole;
        text[i] ^= 4;
        write_text(path_, text);
        const auto file = open();
        ASSERT_FALSE(file) << "byte " << i;
        EXPECT_EQ(file.error().code, ErrorCode::Io);
        EXPECT_THAT(file.error().detail, testing::HasSubstr(path_.string()));
    }
}

TEST_F(SectionFileTest, AnyOtherLengthIsDamage) {
    ASSERT_TRUE(write());
    const std::string whole = read_text(path_);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_text(path_, whole.substr(0, size));
        ASSERT_FALSE(open()) << size << " bytes";
    }
    write_text(path_, whole + '\0');
    EXPECT_FALSE(open());
}

TEST_F(SectionFileTest, WhatWasMadeForSomethingElseIsNotOpened) {
    EXPECT_EQ(open().error().code, ErrorCode::NotFound);
    ASSERT_TRUE(write());
    const auto error_of = [&](FileKind other, const Sha256& key, std::size_t sections) {
        const auto file = SectionFile::open(path_, {other, key}, sections);
        return file ? "none" : file.error().detail;
    };
    EXPECT_THAT(error_of({kind.magic + 1, 3}, key_, 4), testing::HasSubstr("another kind"));
    EXPECT_THAT(error_of({kind.magic, 4}, key_, 4), testing::HasSubstr("version is 3, expected 4"));
    EXPECT_THAT(error_of(kind, Sha256{}, 4), testing::HasSubstr("something else"));
    EXPECT_THAT(error_of(kind, key_, 3), testing::HasSubstr("cut short or too long"));
    EXPECT_THAT(error_of(kind, key_, 5), testing::HasSubstr("cut short or too long"));
    EXPECT_EQ(SectionFile::open(folder_.path(), {kind, key_}, 4).error().code, ErrorCode::Io);
}

} // namespace
} // namespace cd::tests
