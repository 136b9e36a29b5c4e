// OpenSSL 3 deprecates SHA256_Init and its kind in favour of EVP, which takes nearly twice as
// long for the hash of a short record.
#define OPENSSL_SUPPRESS_DEPRECATED

#include "common/core/files/hash.hpp"

#include "common/core/check.hpp"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rand.h>
#include <openssl/sha.h>
#include <xxhash.h>

#include <cstring>

namespace cd {

namespace {

void hash_more(SHA256_CTX& context, std::span<const std::byte> bytes) {
    CD_CHECK(SHA256_Update(&context, bytes.data(), bytes.size()) == 1);
}

Sha256 hash_end(SHA256_CTX& context) {
    Sha256 hash;
    CD_CHECK(SHA256_Final(reinterpret_cast<unsigned char*>(hash.bytes.data()), &context) == 1);
    return hash;
}

} // namespace

struct Sha256Stream::State {
    SHA256_CTX context{};
};

Sha256Stream::Sha256Stream() : state_(std::make_unique<State>()) {
    CD_CHECK(SHA256_Init(&state_->context) == 1);
}
Sha256Stream::Sha256Stream(Sha256Stream&&) noexcept = default;
Sha256Stream& Sha256Stream::operator=(Sha256Stream&&) noexcept = default;
Sha256Stream::~Sha256Stream() = default;

void Sha256Stream::update(std::span<const std::byte> bytes) {
    hash_more(state_->context, bytes);
}

Sha256 Sha256Stream::finish() {
    return hash_end(state_->context);
}

Sha256 sha256(std::span<const std::byte> bytes) {
    SHA256_CTX context;
    CD_CHECK(SHA256_Init(&context) == 1);
    hash_more(context, bytes);
    return hash_end(context);
}

Sha256 hmac_sha256(const Sha256& key, std::span<const std::byte> bytes) {
    Sha256 mac;
    unsigned size = 0;
    const auto* const made = HMAC(EVP_sha256(),
                                  key.bytes.data(),
                                  static_cast<int>(key.bytes.size()),
                                  reinterpret_cast<const unsigned char*>(bytes.data()),
                                  bytes.size(),
                                  reinterpret_cast<unsigned char*>(mac.bytes.data()),
                                  &size);
    CD_CHECK(made != nullptr && size == mac.bytes.size());
    return mac;
}

Sha256 random_secret() {
    Sha256 secret;
    auto* const out = reinterpret_cast<unsigned char*>(secret.bytes.data());
    CD_CHECK(RAND_bytes(out, static_cast<int>(secret.bytes.size())) == 1);
    return secret;
}

bool is_equal_secret(const Sha256& a, const Sha256& b) {
    return CRYPTO_memcmp(a.bytes.data(), b.bytes.data(), a.bytes.size()) == 0;
}

std::string to_hex(const Sha256& hash) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex;
    hex.reserve(2 * hash.bytes.size());
    for (const std::byte byte : hash.bytes) {
        hex += digits[std::to_integer<unsigned>(byte >> 4)];
        hex += digits[std::to_integer<unsigned>(byte & std::byte{15})];
    }
    return hex;
}

std::string to_short_hex(const Sha256& hash) {
    return to_hex(hash).substr(0, 16);
}

std::optional<Sha256> sha256_from_hex(std::string_view hex) {
    Sha256 hash;
    if (hex.size() != 2 * hash.bytes.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < hex.size(); ++i) {
        const char digit = hex[i];
        unsigned value = 0;
        if (digit >= '0' && digit <= '9') {
            value = static_cast<unsigned>(digit - '0');
        } else if (digit >= 'a' && digit <= 'f') {
            value = static_cast<unsigned>(digit - 'a') + 10;
        } else {
            return std::nullopt;
        }
        std::byte& byte = hash.bytes[i / 2];
        byte = (byte << 4) | static_cast<std::byte>(value);
    }
    return hash;
}

std::uint64_t checksum(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

} // namespace cd

std::size_t std::hash<cd::Sha256>::operator()(const cd::Sha256& value) const noexcept {
    std::size_t first = 0;
    std::memcpy(&first, value.bytes.data(), sizeof first);
    return first;
}
