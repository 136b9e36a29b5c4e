// Owners of OpenSSL's objects. Included by certificate.cpp and tls.cpp alone.
#pragma once

#include "common/core/check.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/result.hpp"
#include "proto/identity/certificate.hpp"

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/x509.h>

#include <memory>
#include <string>

namespace cd::openssl {

template <auto free_function>
struct Free {
    template <class T>
    void operator()(T* object) const {
        free_function(object);
    }
};

template <class T, auto free_function>
using Owner = std::unique_ptr<T, Free<free_function>>;

using Bio = Owner<BIO, BIO_free>;
using Key = Owner<EVP_PKEY, EVP_PKEY_free>;
using Certificate = Owner<X509, X509_free>;
using Request = Owner<X509_REQ, X509_REQ_free>;

/// Null for what is none. At most `limits::certificate_bytes_max` are looked at.
[[nodiscard]] Certificate parse_certificate(const std::string& pem);
[[nodiscard]] Key parse_key(const std::string& pem);

/// Errors: BadInput for a certificate that names no role, name or times as `sign` writes them.
[[nodiscard]] Result<Identity> identity_of(X509* certificate);
[[nodiscard]] Sha256 fingerprint_of(const X509* certificate);

} // namespace cd::openssl
