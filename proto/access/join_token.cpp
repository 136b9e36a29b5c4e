#include "proto/access/join_token.hpp"

#include "common/core/files/bytes.hpp"

#include <array>
#include <charconv>
#include <optional>
#include <span>

namespace cd {

namespace {

constexpr std::string_view prefix = "cdt1.";
constexpr std::size_t id_digits = 16;
constexpr std::size_t hash_digits = 64;
constexpr std::size_t text_size = prefix.size() + id_digits + 1 + hash_digits + 1 + hash_digits;

Sha256 signature(const Sha256& stored, const Sha256& binding, std::string_view request) {
    Bytes bytes(binding.bytes.begin(), binding.bytes.end());
    const auto text = std::as_bytes(std::span(request));
    bytes.insert(bytes.end(), text.begin(), text.end());
    return hmac_sha256(stored, bytes);
}

Sha256 operator^(const Sha256& a, const Sha256& b) {
    Sha256 result;
    for (std::size_t i = 0; i < result.bytes.size(); ++i) {
        result.bytes[i] = a.bytes[i] ^ b.bytes[i];
    }
    return result;
}

std::string id_text(std::uint64_t id) {
    std::array<char, id_digits> digits{};
    for (std::size_t i = 0; i < id_digits; ++i) {
        digits[id_digits - 1 - i] = "0123456789abcdef"[(id >> (4 * i)) & 15U];
    }
    return {digits.data(), digits.size()};
}

std::optional<std::uint64_t> id_from_text(std::string_view text) {
    std::uint64_t id = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, id, 16);
    if (error != std::errc() || rest != end) {
        return std::nullopt;
    }
    return id;
}

} // namespace

std::string to_text(const JoinToken& token) {
    return std::string(prefix) + id_text(token.id) + "." + to_hex(token.secret) + "." +
           to_hex(token.authority);
}

Result<JoinToken> parse_join_token(std::string_view text) {
    const Error error{ErrorCode::BadInput,
                      "no token: expected the text that `cdctl token create` printed"};
    if (text.size() != text_size || !text.starts_with(prefix)) {
        return error;
    }
    const std::string_view rest = text.substr(prefix.size());
    const auto id = id_from_text(rest.substr(0, id_digits));
    const auto secret = sha256_from_hex(rest.substr(id_digits + 1, hash_digits));
    const auto authority = sha256_from_hex(rest.substr(id_digits + 1 + hash_digits + 1));
    const bool has_points = rest[id_digits] == '.' && rest[id_digits + 1 + hash_digits] == '.';
    if (!has_points || !id || !secret || !authority) {
        return error;
    }
    return JoinToken{*id, *secret, *authority};
}

Sha256 stored_secret(const JoinToken& token) {
    return sha256(token.secret.bytes);
}

Sha256 join_proof(const JoinToken& token, const Sha256& binding, std::string_view request) {
    return token.secret ^ signature(stored_secret(token), binding, request);
}

bool is_join_proof(const Sha256& proof,
                   const Sha256& stored,
                   const Sha256& binding,
                   std::string_view request) {
    const Sha256 secret = proof ^ signature(stored, binding, request);
    return is_equal_secret(sha256(secret.bytes), stored);
}

} // namespace cd
