// OpenSSL 3 deprecates SHA256_Init and its kind in favour of EVP, which takes nearly twice as
// long for the hash of a short record.
#define OPENSSL_SUPPRESS_DEPRECATED

#include "common/core/files/hash.hpp"

#include "common/core/check.hpp"

#include <openssl/core_names.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/params.h>
#include <openssl/rand.h>
#include <openssl/sha.h>
#include <xxhash.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>

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

struct FreeMac {
    void operator()(EVP_MAC_CTX* context) const { EVP_MAC_CTX_free(context); }
};

std::unique_ptr<EVP_MAC_CTX, FreeMac> hmac_sha256_context() {
    EVP_MAC* const hmac = EVP_MAC_fetch(nullptr, OSSL_MAC_NAME_HMAC, nullptr);
    CD_CHECK(hmac != nullptr);
    std::unique_ptr<EVP_MAC_CTX, FreeMac> context(EVP_MAC_CTX_new(hmac));
    EVP_MAC_free(hmac); // The context has its own reference.
    std::string digest = "SHA256";
    const std::array<OSSL_PARAM, 2> params{
        OSSL_PARAM_construct_utf8_string(OSSL_MAC_PARAM_DIGEST, digest.data(), 0),
        OSSL_PARAM_construct_end()};
    CD_CHECK(context != nullptr && EVP_MAC_CTX_set_params(context.get(), params.data()) == 1);
    return context;
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
    // `HMAC` looks its algorithms up at each call, which takes several times as long as the rest.
    thread_local const std::unique_ptr<EVP_MAC_CTX, FreeMac> context = hmac_sha256_context();
    Sha256 mac;
    std::size_t size = 0;
    const bool is_made = EVP_MAC_init(context.get(),
                                      reinterpret_cast<const unsigned char*>(key.bytes.data()),
                                      key.bytes.size(),
                                      nullptr) == 1 &&
                         EVP_MAC_update(context.get(),
                                        reinterpret_cast<const unsigned char*>(bytes.data()),
                                        bytes.size()) == 1 &&
                         EVP_MAC_final(context.get(),
                                       reinterpret_cast<unsigned char*>(mac.bytes.data()),
                                       &size,
                                       mac.bytes.size()) == 1;
    CD_CHECK(is_made && size == mac.bytes.size());
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
