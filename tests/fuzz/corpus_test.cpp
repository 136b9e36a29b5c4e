// Proves that every corpus input, and thousands of small changes of each, ends in an error or in
// what encoders write. Inputs that once broke something stay in the corpus.
#include "tests/fuzz/targets.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace cd::fuzz {
namespace {

using Bytes = std::vector<std::byte>;

constexpr int changes_of_each = 3000;

std::vector<Bytes> inputs_of(const Target& target) {
    std::vector<Bytes> inputs;
    const auto folder =
        std::filesystem::path(CD_SOURCE_DIR) / "tests/fuzz/corpus" / std::string(target.name);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto bytes = std::as_bytes(std::span(text));
        inputs.emplace_back(bytes.begin(), bytes.end());
    }
    return inputs;
}

/// Changes, removes or doubles a few bytes.
Bytes changed(Bytes bytes, std::mt19937_64& random) {
    for (std::uint64_t times = 1 + random() % 4; times > 0 && !bytes.empty(); --times) {
        const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
        switch (random() % 4) {
        case 0:
            *at = static_cast<std::byte>(random());
            break;
        case 1:
            *at ^= std::byte{1} << random() % 8;
            break;
        case 2:
            bytes.erase(at);
            break;
        default:
            bytes.insert(at, *at);
            break;
        }
    }
    return bytes;
}

class FuzzCorpus : public testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, EndsInAnErrorOrInWhatTheEncoderWrites) {
    const std::vector<Bytes> inputs = inputs_of(GetParam());
    ASSERT_FALSE(inputs.empty());
    std::mt19937_64 random(1); // NOLINT: the same each time.
    GetParam().run({});
    for (const Bytes& input : inputs) {
        GetParam().run(input);
        for (int i = 0; i < changes_of_each; ++i) {
            GetParam().run(changed(input, random));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Targets,
                         FuzzCorpus,
                         testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& target) { return std::string(target.param.name); });

} // namespace
} // namespace cd::fuzz
