#include "proto/identity/certificate.hpp"

#include "common/core/limits/wire.hpp"
#include "common/core/printable.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/identity/openssl.hpp"

#include <openssl/ec.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

using openssl::Bio;
using openssl::Certificate;
using openssl::Key;
using openssl::Owner;
using openssl::Request;

constexpr std::array<std::string_view, 5> role_names{
    "master", "worker", "submitter", "admin", "metrics"};
/// Prefix of the role in the subject alternative name (RFC 5280, section 4.2.1.6).
constexpr std::string_view role_uri = "urn:cdcluster:role:";
constexpr std::size_t serial_bytes = 16;
constexpr long version_3 = 2;

// ---- Texts ----------------------------------------------------------------------------------

Bio reader_of(const std::string& text) {
    Bio bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
    CD_CHECK(bio != nullptr);
    return bio;
}

Bio make_writer() {
    Bio bio(BIO_new(BIO_s_mem()));
    CD_CHECK(bio != nullptr);
    return bio;
}

std::string text_in(const Bio& bio) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(bio.get(), &data);
    return {data, static_cast<std::size_t>(size)};
}

/// Makes OpenSSL fail on an encrypted key instead of prompting for a passphrase.
int no_passphrase(char* /*buffer*/, int /*size*/, int /*writes*/, void* /*data*/) {
    return -1;
}

std::string to_pem(X509* certificate) {
    const Bio bio = make_writer();
    CD_CHECK(PEM_write_bio_X509(bio.get(), certificate) == 1);
    return text_in(bio);
}

std::string to_pem(EVP_PKEY* key) {
    const Bio bio = make_writer();
    CD_CHECK(PEM_write_bio_PrivateKey(bio.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1);
    return text_in(bio);
}

bool is_too_long(const std::string& pem) {
    return pem.size() > limits::certificate_bytes_max;
}

Key make_key() {
    Key key(EVP_EC_gen("P-256"));
    CD_CHECK(key != nullptr);
    return key;
}

// ---- Building a certificate -----------------------------------------------------------------

void set_serial(X509* certificate) {
    std::array<unsigned char, serial_bytes> bytes{};
    CD_CHECK(RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) == 1);
    bytes[0] = static_cast<unsigned char>((bytes[0] & 0x7fU) | 0x40U); // Positive, full length.
    const Owner<BIGNUM, BN_free> number(
        BN_bin2bn(bytes.data(), static_cast<int>(bytes.size()), nullptr));
    CD_CHECK(number != nullptr);
    CD_CHECK(BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr);
}

void set_time(ASN1_TIME* field, WallTime time) {
    CD_CHECK(ASN1_TIME_set(field, std::chrono::system_clock::to_time_t(time)) != nullptr);
}

void add_name(X509_NAME* name, const char* field, std::string_view text) {
    const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
    const int size = static_cast<int>(text.size());
    CD_CHECK(X509_NAME_add_entry_by_txt(name, field, MBSTRING_UTF8, bytes, size, -1, 0) == 1);
}

void add_extension(X509* certificate, X509* issuer, int kind, const std::string& value) {
    X509V3_CTX context;
    X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
    const Owner<X509_EXTENSION, X509_EXTENSION_free> extension(
        X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str()));
    CD_CHECK(extension != nullptr);
    CD_CHECK(X509_add_ext(certificate, extension.get(), -1) == 1);
}

/// Makes an unsigned certificate; the caller adds the issuer.
Certificate make_certificate(EVP_PKEY* key, const Identity& identity, std::string_view unit) {
    Certificate certificate(X509_new());
    CD_CHECK(certificate != nullptr);
    CD_CHECK(X509_set_version(certificate.get(), version_3) == 1);
    set_serial(certificate.get());
    set_time(X509_getm_notBefore(certificate.get()), identity.from);
    set_time(X509_getm_notAfter(certificate.get()), identity.until);
    X509_NAME* const name = X509_get_subject_name(certificate.get());
    add_name(name, "O", "cdcluster");
    add_name(name, "OU", unit);
    add_name(name, "CN", identity.name);
    CD_CHECK(X509_set_pubkey(certificate.get(), key) == 1);
    return certificate;
}

void sign_with(X509* certificate, X509* issuer, EVP_PKEY* issuer_key) {
    CD_CHECK(X509_set_issuer_name(certificate, X509_get_subject_name(issuer)) == 1);
    add_extension(certificate, issuer, NID_subject_key_identifier, "hash");
    add_extension(certificate, issuer, NID_authority_key_identifier, "keyid:always");
    CD_CHECK(X509_sign(certificate, issuer_key, EVP_sha256()) > 0);
}

/// Returns serverAuth if a role accepts TLS connections, clientAuth if it makes them, or both.
std::string key_usage_of(CertifiedRole role) {
    switch (role) {
    case CertifiedRole::Master:
        return "serverAuth";
    case CertifiedRole::Worker: // Accepts connections of other workers.
        return "serverAuth,clientAuth";
    default:
        return "clientAuth";
    }
}

std::string certify(X509* authority, EVP_PKEY* authority_key, EVP_PKEY* key, const Identity& who) {
    const std::string role(to_text(who.role));
    const Certificate certificate = make_certificate(key, who, role);
    add_extension(certificate.get(), authority, NID_basic_constraints, "critical,CA:FALSE");
    add_extension(certificate.get(), authority, NID_key_usage, "critical,digitalSignature");
    add_extension(certificate.get(), authority, NID_ext_key_usage, key_usage_of(who.role));
    // Programs that are not ours, such as Prometheus, compare a host's name with a DNS name only.
    const std::string host = who.role == CertifiedRole::Master ? ",DNS:" + role : "";
    add_extension(certificate.get(),
                  authority,
                  NID_subject_alt_name,
                  "URI:" + std::string(role_uri) + role + host);
    sign_with(certificate.get(), authority, authority_key);
    return to_pem(certificate.get());
}

bool is_p256(const EVP_PKEY* key) {
    std::array<char, 32> group{};
    std::size_t size = 0;
    return EVP_PKEY_get_group_name(key, group.data(), group.size(), &size) == 1 &&
           std::string_view(group.data(), size) == SN_X9_62_prime256v1;
}

// ---- Reading a certificate ------------------------------------------------------------------

/// Returns nothing for an invalid time: OpenSSL accepts certificates with any text as a time.
std::optional<WallTime> to_wall_time(const ASN1_TIME* time) {
    std::tm fields{};
    return ASN1_TIME_to_tm(time, &fields) == 1 ? wall_time(timegm(&fields)) : std::nullopt;
}

std::string common_name(X509* certificate) {
    std::array<char, limits::certified_name_bytes_max + 2> text{};
    const int size = X509_NAME_get_text_by_NID(X509_get_subject_name(certificate),
                                               NID_commonName,
                                               text.data(),
                                               static_cast<int>(text.size()));
    return size < 0 ? std::string() : std::string(text.data(), static_cast<std::size_t>(size));
}

std::optional<CertifiedRole> role_of(const X509* certificate) {
    const Owner<GENERAL_NAMES, GENERAL_NAMES_free> names(static_cast<GENERAL_NAMES*>(
        X509_get_ext_d2i(certificate, NID_subject_alt_name, nullptr, nullptr)));
    const int count = names == nullptr ? 0 : sk_GENERAL_NAME_num(names.get());
    const GENERAL_NAME* name = nullptr; // The only URI; a DNS name may stand beside it.
    for (int i = 0; i < count; ++i) {
        const GENERAL_NAME* const each = sk_GENERAL_NAME_value(names.get(), i);
        if (each->type == GEN_DNS) {
            continue;
        }
        if (each->type != GEN_URI || name != nullptr) {
            return std::nullopt;
        }
        name = each;
    }
    if (name == nullptr) {
        return std::nullopt;
    }
    const ASN1_IA5STRING* const uri = name->d.uniformResourceIdentifier;
    const std::string_view text(reinterpret_cast<const char*>(ASN1_STRING_get0_data(uri)),
                                static_cast<std::size_t>(ASN1_STRING_length(uri)));
    if (!text.starts_with(role_uri)) {
        return std::nullopt;
    }
    return certified_role_from_text(text.substr(role_uri.size()));
}

Error no_certificate() {
    return {ErrorCode::BadInput, "no certificate of a cdcluster"};
}

} // namespace

namespace openssl {

Certificate parse_certificate(const std::string& pem) {
    if (is_too_long(pem)) {
        return nullptr;
    }
    const Bio bio = reader_of(pem);
    return Certificate(PEM_read_bio_X509(bio.get(), nullptr, no_passphrase, nullptr));
}

Key parse_key(const std::string& pem) {
    if (is_too_long(pem)) {
        return nullptr;
    }
    const Bio bio = reader_of(pem);
    return Key(PEM_read_bio_PrivateKey(bio.get(), nullptr, no_passphrase, nullptr));
}

Result<Identity> identity_of(X509* certificate) {
    Identity identity;
    identity.name = common_name(certificate);
    const std::optional<CertifiedRole> role = role_of(certificate);
    const auto from = to_wall_time(X509_get0_notBefore(certificate));
    const auto until = to_wall_time(X509_get0_notAfter(certificate));
    if (!role || !is_good_name(identity.name) || !from || !until) {
        return no_certificate();
    }
    identity.role = *role;
    identity.from = *from;
    identity.until = *until;
    return identity;
}

Sha256 fingerprint_of(const X509* certificate) {
    Sha256 hash;
    unsigned size = 0;
    auto* const bytes = reinterpret_cast<unsigned char*>(hash.bytes.data());
    CD_CHECK(X509_digest(certificate, EVP_sha256(), bytes, &size) == 1);
    CD_CHECK(size == hash.bytes.size());
    return hash;
}

} // namespace openssl

std::optional<WallTime> wall_time(std::int64_t seconds_since_1970) {
    using std::chrono::duration_cast;
    const std::chrono::seconds time(seconds_since_1970);
    const bool fits = time >= duration_cast<std::chrono::seconds>(WallTime::duration::min()) &&
                      time <= duration_cast<std::chrono::seconds>(WallTime::duration::max());
    return fits ? std::optional(WallTime(time)) : std::nullopt;
}

std::string_view to_text(CertifiedRole role) {
    return role_names[static_cast<std::size_t>(role)];
}

std::optional<CertifiedRole> certified_role_from_text(std::string_view text) {
    const auto found = std::find(role_names.begin(), role_names.end(), text);
    if (found == role_names.end()) {
        return std::nullopt;
    }
    return static_cast<CertifiedRole>(found - role_names.begin());
}

CertificateRequest make_certificate_request() {
    const Key key = make_key();
    const Request request(X509_REQ_new());
    CD_CHECK(request != nullptr);
    CD_CHECK(X509_REQ_set_pubkey(request.get(), key.get()) == 1);
    CD_CHECK(X509_REQ_sign(request.get(), key.get(), EVP_sha256()) > 0);
    const Bio bio = make_writer();
    CD_CHECK(PEM_write_bio_X509_REQ(bio.get(), request.get()) == 1);
    return {to_pem(key.get()), text_in(bio)};
}

Result<Identity> read_identity(const std::string& certificate) {
    const Certificate parsed = openssl::parse_certificate(certificate);
    return parsed == nullptr ? no_certificate() : openssl::identity_of(parsed.get());
}

Result<Sha256> certificate_fingerprint(const std::string& certificate) {
    const Certificate parsed = openssl::parse_certificate(certificate);
    if (parsed == nullptr) {
        return no_certificate();
    }
    return openssl::fingerprint_of(parsed.get());
}

// ---- The authority --------------------------------------------------------------------------

struct CertificateAuthority::State {
    Certificate certificate;
    Key key;
    std::string text;
};

CertificateAuthority::CertificateAuthority(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
CertificateAuthority::CertificateAuthority(CertificateAuthority&&) noexcept = default;
CertificateAuthority& CertificateAuthority::operator=(CertificateAuthority&&) noexcept = default;
CertificateAuthority::~CertificateAuthority() = default;

CertificateAuthority CertificateAuthority::make(WallTime now) {
    auto state = std::make_unique<State>();
    state->key = make_key();
    Identity identity;
    identity.name = "cdcluster authority";
    identity.from = now - timing::clock_difference_max;
    identity.until = now + timing::authority_life;
    state->certificate = make_certificate(state->key.get(), identity, "authority");
    X509* const certificate = state->certificate.get();
    add_extension(certificate, certificate, NID_basic_constraints, "critical,CA:TRUE,pathlen:0");
    add_extension(certificate, certificate, NID_key_usage, "critical,keyCertSign");
    CD_CHECK(X509_set_issuer_name(certificate, X509_get_subject_name(certificate)) == 1);
    add_extension(certificate, certificate, NID_subject_key_identifier, "hash");
    CD_CHECK(X509_sign(certificate, state->key.get(), EVP_sha256()) > 0);
    state->text = to_pem(certificate);
    return CertificateAuthority(std::move(state));
}

Result<CertificateAuthority> CertificateAuthority::parse(const std::string& certificate,
                                                         const std::string& key) {
    auto state = std::make_unique<State>();
    state->certificate = openssl::parse_certificate(certificate);
    state->key = openssl::parse_key(key);
    if (state->certificate == nullptr || state->key == nullptr ||
        X509_check_private_key(state->certificate.get(), state->key.get()) != 1 ||
        X509_check_ca(state->certificate.get()) != 1) {
        return Error{ErrorCode::BadInput, "no certificate of an authority and its key"};
    }
    state->text = to_pem(state->certificate.get());
    return CertificateAuthority(std::move(state));
}

const std::string& CertificateAuthority::certificate() const {
    return state_->text;
}

std::string CertificateAuthority::key() const {
    return to_pem(state_->key.get());
}

Sha256 CertificateAuthority::fingerprint() const {
    return openssl::fingerprint_of(state_->certificate.get());
}

Result<std::string> CertificateAuthority::sign(const std::string& request,
                                               const Identity& identity) const {
    if (!is_good_name(identity.name)) {
        return Error{
            ErrorCode::BadInput,
            "a name that is empty, too long or not printable, or begins or ends with a blank"};
    }
    if (is_too_long(request)) {
        return Error{ErrorCode::BadInput, "a request for a certificate that is too long"};
    }
    const Bio bio = reader_of(request);
    const Request parsed(PEM_read_bio_X509_REQ(bio.get(), nullptr, no_passphrase, nullptr));
    EVP_PKEY* const key = parsed == nullptr ? nullptr : X509_REQ_get0_pubkey(parsed.get());
    if (key == nullptr || !is_p256(key) || X509_REQ_verify(parsed.get(), key) != 1) {
        return Error{ErrorCode::BadInput,
                     "no request for a certificate that is signed by its own P-256 key"};
    }
    return certify(state_->certificate.get(), state_->key.get(), key, identity);
}

Credential CertificateAuthority::issue(const Identity& identity) const {
    CD_CHECK(is_good_name(identity.name));
    const Key key = make_key();
    return {to_pem(key.get()),
            certify(state_->certificate.get(), state_->key.get(), key.get(), identity),
            state_->text};
}

} // namespace cd
