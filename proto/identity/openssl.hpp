// RAII handles of OpenSSL objects, for the files of proto that call OpenSSL and for fuzz targets.
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

/// Returns null if the text is no certificate, or longer than `limits::certificate_bytes_max`.
[[nodiscard]] Certificate parse_certificate(const std::string& pem);
/// Returns null if the text is no unencrypted key, or longer than `limits::certificate_bytes_max`.
[[nodiscard]] Key parse_key(const std::string& pem);

/// Reads the holder and validity. Errors: BadInput unless role, name and times are in the form that
/// `CertificateAuthority::sign` writes.
[[nodiscard]] Result<Identity> identity_of(X509* certificate);
/// Returns SHA-256 of the certificate's DER form.
[[nodiscard]] Sha256 fingerprint_of(const X509* certificate);

} // namespace cd::openssl
