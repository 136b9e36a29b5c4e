// Shared by the targets. A broken promise ends the program, and the fuzzer keeps the input.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>

namespace cd::fuzz {

inline void require(bool holds, const char* promise) {
    if (!holds) {
        std::fprintf(stderr, "broken: %s\n", promise);
        std::abort();
    }
}

template <class Accepted>
void require_canonical(const Accepted& written, Input input) {
    require(std::ranges::equal(written, input), "what is accepted is what the encoder writes");
}

/// A refusal says why, after the path of the file if it is of one.
inline void require_reason(const Error& error, const std::filesystem::path& file = {}) {
    require(!error.detail.empty(), "whoever is refused is told why");
    require(error.detail.starts_with(file.string()), "an error names the file");
}

/// True if the first byte selects the target's other mode.
inline bool is_odd(Input input) {
    return !input.empty() && (std::to_integer<unsigned>(input.front()) & 1u) != 0;
}

/// The input without its first byte.
inline Input rest_of(Input input) {
    return input.subspan(input.empty() ? 0 : 1);
}

constexpr std::size_t word = sizeof(std::uint64_t);

inline std::uint64_t word_at(const Bytes& file, std::size_t offset) {
    return ByteReader(Input(file).subspan(offset)).get<std::uint64_t>();
}

/// Writes the checksum of [begin, end) at `to`.
inline void sum_up(Bytes& file, std::size_t begin, std::size_t end, std::size_t to) {
    const std::uint64_t sum = checksum(Input(file).subspan(begin, end - begin));
    std::memcpy(file.data() + to, &sum, word);
}

inline std::string text_of(std::span<const std::byte> bytes) {
    std::string text(bytes.size(), '\0');
    if (!bytes.empty()) {
        std::memcpy(text.data(), bytes.data(), bytes.size());
    }
    return text;
}

} // namespace cd::fuzz
