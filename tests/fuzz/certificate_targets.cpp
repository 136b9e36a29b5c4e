#include "common/core/printable.hpp"
#include "proto/identity/certificate.hpp"
#include "proto/identity/openssl.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"

#include <openssl/pem.h>

#include <chrono>

namespace cd::fuzz {

namespace {

/// In DER every byte has a meaning; in PEM most changes only make invalid letters.
std::string pem_of(Input input, const char* label) {
    const Input rest = rest_of(input);
    if (!is_odd(input)) {
        return text_of(rest);
    }
    const openssl::Bio bio(BIO_new(BIO_s_mem()));
    require(bio != nullptr, "memory for a text");
    const auto* const bytes = reinterpret_cast<const unsigned char*>(rest.data());
    PEM_write_bio(bio.get(), label, "", bytes, static_cast<long>(rest.size()));
    char* data = nullptr;
    const long size = BIO_get_mem_data(bio.get(), &data);
    return {data, static_cast<std::size_t>(size)};
}

} // namespace

void certificate(Input input) {
    const std::string text = pem_of(input, PEM_STRING_X509);
    const auto identity = read_identity(text);
    if (identity) {
        require(is_good_name(identity.value().name), "a name is good");
        require(certified_role_from_text(to_text(identity.value().role)).has_value(),
                "a role is one");
        require(certificate_fingerprint(text).has_value(), "what is read has a fingerprint");
    }
}

void certificate_request(Input input) {
    static const WallTime now{std::chrono::hours(24 * 365 * 50)};
    static const CertificateAuthority authority = CertificateAuthority::make(now);
    const Identity asked{CertifiedRole::Worker, "peer", now, now + std::chrono::hours(1)};
    const auto signed_one = authority.sign(pem_of(input, PEM_STRING_X509_REQ), asked);
    if (signed_one) {
        const auto identity = read_identity(signed_one.value());
        require(identity.has_value(), "what is signed can be read");
        require(identity.value().role == asked.role && identity.value().name == asked.name &&
                    identity.value().from == asked.from && identity.value().until == asked.until,
                "nothing of a request is signed but its key");
    }
}

} // namespace cd::fuzz
