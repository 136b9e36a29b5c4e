// Content names (SHA-256) and quick checksums (XXH3). The only user of OpenSSL's hashes and xxHash.
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

/// A SHA-256 value: the name of a mesh, a block of geometry, or a result.
struct Sha256 {
    std::array<std::byte, 32> bytes{};

    friend auto operator<=>(const Sha256&, const Sha256&) = default;
};

/// Computes a SHA-256 over bytes that come in pieces.
class Sha256Stream {
  public:
    Sha256Stream();
    Sha256Stream(Sha256Stream&&) noexcept;
    Sha256Stream& operator=(Sha256Stream&&) noexcept;
    ~Sha256Stream();

    void update(std::span<const std::byte> bytes);
    /// The hash of all bytes so far. The stream may not be used afterwards.
    [[nodiscard]] Sha256 finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

[[nodiscard]] Sha256 sha256(std::span<const std::byte> bytes);

/// HMAC (RFC 2104) with SHA-256: made and checked only by who knows the key.
[[nodiscard]] Sha256 hmac_sha256(const Sha256& key, std::span<const std::byte> bytes);
/// 32 bytes that nobody can guess.
[[nodiscard]] Sha256 random_secret();
/// The same, in a time that does not tell where they differ.
[[nodiscard]] bool is_equal_secret(const Sha256& a, const Sha256& b);

/// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string to_hex(const Sha256& hash);
/// The first 16 digits of it, as shown to people.
[[nodiscard]] std::string to_short_hex(const Sha256& hash);
/// Nothing unless the text is exactly 64 hexadecimal digits.
[[nodiscard]] std::optional<Sha256> sha256_from_hex(std::string_view hex);

/// Detects damage in transit and on disk; no defence against intent.
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

} // namespace cd

template <>
struct std::hash<cd::Sha256> {
    std::size_t operator()(const cd::Sha256& value) const noexcept;
};
