// Converts values to and from little-endian bytes, for every format that is hashed, sent or stored.
#pragma once

#include "common/core/result.hpp"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

static_assert(std::endian::native == std::endian::little, "big-endian hosts are not supported");

using Bytes = std::vector<std::byte>;

template <class T>
concept Scalar = std::integral<T> || std::floating_point<T>;

/// Appends values to a buffer of bytes that it owns.
class ByteWriter {
  public:
    template <Scalar T>
    void put(T value) {
        put_array(std::span<const T>(&value, 1));
    }

    template <Scalar T>
    void put_array(std::span<const T> values) {
        const auto bytes = std::as_bytes(values);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    /// Writes the length as u32, then the characters.
    void put_text(std::string_view text) {
        put(static_cast<std::uint32_t>(text.size()));
        put_array(std::span<const char>(text.data(), text.size()));
    }

    /// Reserves memory for this many bytes in all.
    void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] const Bytes& bytes() const { return bytes_; }
    [[nodiscard]] Bytes take() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

/// Reads values from untrusted bytes. After the first incomplete value the reader has failed: it
/// returns zeros and empty arrays, and `complete` is false at the end.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <Scalar T>
    [[nodiscard]] T get() {
        T value{};
        if (claim(sizeof value)) {
            std::memcpy(&value, rest_.data(), sizeof value);
            rest_ = rest_.subspan(sizeof value);
        }
        return value;
    }

    /// Reads `count` values. `count` is untrusted: memory is allocated only for present bytes.
    template <Scalar T>
    [[nodiscard]] std::vector<T> get_array(std::uint64_t count) {
        if (count > rest_.size() / sizeof(T) || failed_) {
            failed_ = true;
            return {};
        }
        std::vector<T> values(count);
        if (count != 0) {
            std::memcpy(values.data(), rest_.data(), count * sizeof(T));
        }
        rest_ = rest_.subspan(count * sizeof(T));
        return values;
    }

    /// Returns a view of the next `count` bytes, without a copy.
    [[nodiscard]] std::span<const std::byte> get_bytes(std::uint64_t count) {
        if (!claim(count)) {
            return {};
        }
        const auto bytes = rest_.first(count);
        rest_ = rest_.subspan(count);
        return bytes;
    }

    [[nodiscard]] std::string get_text() {
        const auto characters = get_array<char>(get<std::uint32_t>());
        return {characters.begin(), characters.end()};
    }

    [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
    [[nodiscard]] bool failed() const { return failed_; }
    /// True if every read succeeded and no bytes are left.
    [[nodiscard]] bool complete() const { return !failed_ && rest_.empty(); }

  private:
    [[nodiscard]] bool claim(std::uint64_t size) {
        failed_ = failed_ || rest_.size() < size;
        return !failed_;
    }

    std::span<const std::byte> rest_;
    bool failed_ = false;
};

} // namespace cd
