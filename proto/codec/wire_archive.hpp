// The two cereal archives of the wire: flat little-endian bytes, with every size checked before
// use. Only the codec includes this.
#pragma once

#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/ignored_range.hpp"

#include <cereal/cereal.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace cd {

/// Aborts the decoding of a message. Never leaves the codec.
struct WireError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class WireOutput : public cereal::OutputArchive<WireOutput, cereal::AllowEmptyClassElision> {
  public:
    static constexpr bool is_input = false;

    explicit WireOutput(std::size_t bytes_expected = 0) : OutputArchive(this) {
        bytes_.reserve(bytes_expected);
    }

    void write(std::span<const std::byte> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] Bytes take() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

class WireInput : public cereal::InputArchive<WireInput, cereal::AllowEmptyClassElision> {
  public:
    static constexpr bool is_input = true;

    explicit WireInput(std::span<const std::byte> bytes) : InputArchive(this), rest_(bytes) {}

    void read(std::span<std::byte> bytes) {
        if (bytes.size() > rest_.size()) {
            throw WireError("cut short");
        }
        if (!bytes.empty()) {
            std::memcpy(bytes.data(), rest_.data(), bytes.size());
        }
        rest_ = rest_.subspan(bytes.size());
    }

    /// Reads a count of elements and refuses more than the bytes that remain can hold.
    [[nodiscard]] std::size_t read_count(std::size_t element_bytes_min) {
        std::uint64_t count = 0;
        read(std::as_writable_bytes(std::span(&count, 1)));
        if (count > rest_.size() / element_bytes_min) {
            throw WireError("a size beyond the message's end");
        }
        return static_cast<std::size_t>(count);
    }

    [[nodiscard]] std::size_t remaining() const { return rest_.size(); }
    void skip_rest() { rest_ = {}; }

  private:
    std::span<const std::byte> rest_;
};

/// Marks types whose memory layout is their wire form on little-endian hosts, the only supported
/// ones. Such types have no padding, and every byte value is legal; receivers check the meaning.
template <class T>
inline constexpr bool
    is_flat = (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_same_v<T, std::byte>;
template <>
inline constexpr bool is_flat<Sha256> = true;
template <>
inline constexpr bool is_flat<RootPair> = true;
template <>
inline constexpr bool is_flat<IgnoredRange> = true;
template <>
inline constexpr bool is_flat<PartRun> = true;
static_assert(sizeof(Sha256) == 32);
static_assert(sizeof(RootPair) == 2 * 4);
static_assert(sizeof(IgnoredRange) == 6 * 4);
static_assert(sizeof(PartRun) == 2 * 4);

/// The smallest encoded size of a T: a default T has only empty containers.
template <class T>
std::size_t wire_bytes_min() {
    if constexpr (is_flat<T>) {
        return sizeof(T);
    } else {
        static const std::size_t size = [] {
            WireOutput out;
            out(T{});
            return out.size();
        }();
        return size;
    }
}

// ---- Values that are their bytes ------------------------------------------------------------

template <class T>
requires is_flat<T>
void save(WireOutput& out, const T& value) {
    out.write(std::as_bytes(std::span(&value, 1)));
}

template <class T>
requires is_flat<T>
void load(WireInput& in, T& value) {
    in.read(std::as_writable_bytes(std::span(&value, 1)));
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::isfinite(value)) {
            throw WireError("a number that is not finite");
        }
    }
}

inline void save(WireOutput& out, const bool& value) {
    out(static_cast<std::uint8_t>(value));
}

inline void load(WireInput& in, bool& value) {
    std::uint8_t byte = 0;
    in(byte);
    if (byte > 1) {
        throw WireError("a truth value that is neither 0 nor 1");
    }
    value = byte == 1;
}

/// Reads or writes an enumeration as one byte, which must lie within [first, last].
template <class Archive, class E>
void enumeration(Archive& archive, E& value, E first, E last) {
    auto byte = static_cast<std::uint8_t>(value);
    archive(byte);
    const bool is_known =
        byte >= static_cast<std::uint8_t>(first) && byte <= static_cast<std::uint8_t>(last);
    if constexpr (Archive::is_input) {
        if (!is_known) {
            throw WireError("an enumeration's value out of range");
        }
        value = static_cast<E>(byte);
    } else {
        CD_CHECK(is_known);
    }
}

// ---- Containers: a count as u64, then the elements ------------------------------------------

template <class T>
void save(WireOutput& out, const std::vector<T>& values) {
    out(static_cast<std::uint64_t>(values.size()));
    if constexpr (is_flat<T>) {
        out.write(std::as_bytes(std::span(values)));
    } else {
        for (const T& value : values) {
            out(value);
        }
    }
}

template <class T>
void load(WireInput& in, std::vector<T>& values) {
    const std::size_t count = in.read_count(wire_bytes_min<T>());
    values.resize(count);
    if constexpr (is_flat<T>) {
        in.read(std::as_writable_bytes(std::span(values)));
    } else {
        for (T& value : values) {
            in(value);
        }
    }
}

inline void save(WireOutput& out, const std::string& text) {
    out(static_cast<std::uint64_t>(text.size()));
    out.write(std::as_bytes(std::span(text)));
}

inline void load(WireInput& in, std::string& text) {
    text.resize(in.read_count(1));
    in.read(std::as_writable_bytes(std::span(text)));
}

template <class T, std::size_t N>
requires is_flat<T>
void save(WireOutput& out, const std::array<T, N>& values) {
    out.write(std::as_bytes(std::span(values)));
}

template <class T, std::size_t N>
requires is_flat<T>
void load(WireInput& in, std::array<T, N>& values) {
    in.read(std::as_writable_bytes(std::span(values)));
}

template <class T>
void save(WireOutput& out, const std::optional<T>& value) {
    out(value.has_value());
    if (value) {
        out(*value);
    }
}

template <class T>
void load(WireInput& in, std::optional<T>& value) {
    bool is_there = false;
    in(is_there);
    value.reset();
    if (is_there) {
        in(value.emplace());
    }
}

} // namespace cd
