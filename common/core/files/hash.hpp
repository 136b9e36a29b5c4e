// Content hashes (SHA-256) and fast checksums (XXH3). No other code calls OpenSSL's hash functions
// or xxHash.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cd {

/// A SHA-256 value, which identifies a mesh, a block of geometry or a result. A result with a short
/// record has the record's bytes here instead (`digest_of_record`).
struct Sha256 {
    std::array<std::byte, 32> bytes{};

    friend auto operator<=>(const Sha256&, const Sha256&) = default;
};

/// Computes a SHA-256 incrementally.
class Sha256Stream {
  public:
    Sha256Stream();
    Sha256Stream(Sha256Stream&&) noexcept;
    Sha256Stream& operator=(Sha256Stream&&) noexcept;
    ~Sha256Stream();

    void update(std::span<const std::byte> bytes);
    /// Returns the hash of all bytes so far. The stream must not be used afterwards.
    [[nodiscard]] Sha256 finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] Sha256 sha256(std::span<const std::byte> bytes);

/// Returns the HMAC (RFC 2104) with SHA-256: only a holder of the key can make or check the value.
[[nodiscard]] Sha256 hmac_sha256(const Sha256& key, std::span<const std::byte> bytes);
/// Returns 32 cryptographically random bytes.
[[nodiscard]] Sha256 random_secret();
/// Compares in a time that does not depend on the secrets.
[[nodiscard]] bool is_equal_secret(const Sha256& a, const Sha256& b);

/// Returns 64 lower-case hexadecimal digits.
[[nodiscard]] std::string to_hex(const Sha256& hash);
/// Returns the first 16 hexadecimal digits, for display.
[[nodiscard]] std::string to_short_hex(const Sha256& hash);
/// Parses exactly 64 lower-case hexadecimal digits; returns nothing for any other text.
[[nodiscard]] std::optional<Sha256> sha256_from_hex(std::string_view hex);

/// Returns the 64-bit XXH3 of the bytes, which detects accidental damage in transit and on disk,
/// but no manipulation.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

} // namespace cd

template <>
struct std::hash<cd::Sha256> {
    std::size_t operator()(const cd::Sha256& value) const noexcept;
};
