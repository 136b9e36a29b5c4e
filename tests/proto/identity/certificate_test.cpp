// Proves that certificates contain what was signed, that a request is trusted only with a proof of
// its key, and that invalid texts are refused.
#include "proto/identity/certificate.hpp"

#include "common/core/limits/wire.hpp"

#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <string>
#include <vector>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

/// Certificates have a resolution of a second.
WallTime this_second() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

Identity identity_of(CertifiedRole role) {
    return {role, "blade-3", this_second(), this_second() + 1h};
}

TEST(Certificate, SaysWhatItWasSignedToSay) {
    const auto authority = CertificateAuthority::make(this_second());
    for (const CertifiedRole role : {CertifiedRole::Master,
                                     CertifiedRole::Worker,
                                     CertifiedRole::Submitter,
                                     CertifiedRole::Admin,
                                     CertifiedRole::Metrics}) {
        const Identity asked = identity_of(role);
        const CertificateRequest request = make_certificate_request();
        const auto certificate = authority.sign(request.request, asked);
        ASSERT_TRUE(certificate) << certificate.error().detail;
        const auto said = read_identity(certificate.value());
        ASSERT_TRUE(said) << said.error().detail;
        EXPECT_EQ(said.value().role, role);
        EXPECT_EQ(said.value().name, asked.name);
        EXPECT_EQ(said.value().from, asked.from);
        EXPECT_EQ(said.value().until, asked.until);
        EXPECT_EQ(certified_role_from_text(to_text(role)), role);
    }
}

/// Whether programs that are not ours take the certificate for that of this host: these compare
/// only DNS names, not the holder's name.
bool is_of_host(const std::string& certificate, const char* host) {
    BIO* const bio = BIO_new_mem_buf(certificate.data(), static_cast<int>(certificate.size()));
    X509* const read = PEM_read_bio_X509(bio, nullptr, nullptr, nullptr);
    const int found = X509_check_host(read, host, 0, X509_CHECK_FLAG_NEVER_CHECK_SUBJECT, nullptr);
    X509_free(read);
    BIO_free(bio);
    return found == 1;
}

TEST(Certificate, OnlyAMastersIsThatOfTheHostMaster) {
    const auto authority = CertificateAuthority::make(this_second());
    const auto issued = [&](CertifiedRole role) {
        return authority.issue({role, "master", this_second(), this_second() + 1h}).certificate;
    };
    EXPECT_TRUE(is_of_host(issued(CertifiedRole::Master), "master"));
    EXPECT_FALSE(is_of_host(issued(CertifiedRole::Master), "blade-3"));
    EXPECT_FALSE(is_of_host(issued(CertifiedRole::Worker), "master"));
    EXPECT_FALSE(is_of_host(issued(CertifiedRole::Admin), "master"));
}

TEST(Certificate, AnAuthorityIsReadBackWithItsKeyAlone) {
    const auto authority = CertificateAuthority::make(this_second());
    const auto again = CertificateAuthority::parse(authority.certificate(), authority.key());
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(again.value().fingerprint(), authority.fingerprint());
    EXPECT_EQ(certificate_fingerprint(authority.certificate()).value(), authority.fingerprint());
    const auto other = CertificateAuthority::make(this_second());
    EXPECT_NE(other.fingerprint(), authority.fingerprint());
    EXPECT_FALSE(CertificateAuthority::parse(authority.certificate(), other.key()));
    const Credential worker = authority.issue(identity_of(CertifiedRole::Worker));
    EXPECT_FALSE(CertificateAuthority::parse(worker.certificate, worker.key)) << "not an authority";
}

TEST(Certificate, TheAuthoritysOwnNamesNoRole) {
    const auto authority = CertificateAuthority::make(this_second());
    EXPECT_EQ(read_identity(authority.certificate()).error().code, ErrorCode::BadInput);
}

TEST(Certificate, ARequestThatIsDamagedAnywhereIsNotSigned) {
    const auto authority = CertificateAuthority::make(this_second());
    const std::string good = make_certificate_request().request;
    const Identity identity = identity_of(CertifiedRole::Worker);
    ASSERT_TRUE(authority.sign(good, identity));
    const std::size_t begin = good.find('\n') + 1;
    const std::size_t end = good.find("=\n-----END") == std::string::npos ? good.find("\n-----END")
                                                                          : good.find('=', begin);
    std::size_t refused = 0;
    for (std::size_t i = begin; i < end; ++i) {
        std::string damaged = good;
        damaged[i] = damaged[i] == 'A' ? 'B' : 'A';
        refused += authority.sign(damaged, identity) ? 0u : 1u;
    }
    // The last character may carry unused bits.
    EXPECT_GE(refused + 1, end - begin);
    for (const std::string& text : {std::string(),
                                    std::string("hello"),
                                    good.substr(0, good.size() / 2),
                                    std::string(limits::certificate_bytes_max + 1, 'A'),
                                    authority.certificate()}) {
        EXPECT_EQ(authority.sign(text, identity).error().code, ErrorCode::BadInput);
    }
}

TEST(Certificate, ANameThatIsNoneIsNotSigned) {
    const auto authority = CertificateAuthority::make(this_second());
    const std::string request = make_certificate_request().request;
    for (const std::string& name : {std::string(),
                                    std::string("a\nb"),
                                    std::string("\xff"),
                                    std::string("\xed\xa0\x80"),
                                    std::string(" a"),
                                    std::string("a "),
                                    std::string(limits::certified_name_bytes_max + 1, 'x')}) {
        Identity identity = identity_of(CertifiedRole::Worker);
        identity.name = name;
        EXPECT_FALSE(authority.sign(request, identity));
    }
}

TEST(Certificate, WhatIsNoneIsNotRead) {
    for (const char* text :
         {"", "-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n"}) {
        EXPECT_FALSE(read_identity(text));
        EXPECT_FALSE(certificate_fingerprint(text));
    }
}

} // namespace
} // namespace cd::tests
