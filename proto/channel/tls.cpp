#include "proto/channel/tls.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/channel/tls_state.hpp"
#include "proto/identity/openssl.hpp"

#include <openssl/ssl.h>

#include <utility>

namespace cd {

namespace {

/// A chain has one certificate and the authority that signed it.
constexpr int chain_depth = 1;
/// AES-128 is preferred: it is the fastest with AES instructions, and strong enough for years.
constexpr const char* cipher_suites =
    "TLS_AES_128_GCM_SHA256:TLS_AES_256_GCM_SHA384:TLS_CHACHA20_POLY1305_SHA256";

void prepare(asio::ssl::context& context) {
    SSL_CTX* const raw = context.native_handle();
    CD_CHECK(SSL_CTX_set_min_proto_version(raw, TLS1_3_VERSION) == 1);
    CD_CHECK(SSL_CTX_set_max_proto_version(raw, TLS1_3_VERSION) == 1);
    CD_CHECK(SSL_CTX_set_ciphersuites(raw, cipher_suites) == 1);
    // No resumption: each connection checks the certificate, so that its expiry takes effect.
    CD_CHECK(SSL_CTX_set_num_tickets(raw, 0) == 1);
    SSL_CTX_set_session_cache_mode(raw, SSL_SESS_CACHE_OFF);
    SSL_CTX_set_max_cert_list(raw, 2 * limits::certificate_bytes_max);
    SSL_CTX_set_verify_depth(raw, chain_depth);
    // Does not require a certificate, so that the program can name what is missing.
    SSL_CTX_set_verify(raw, SSL_VERIFY_PEER, nullptr);
}

void show(asio::ssl::context& context, X509* certificate, EVP_PKEY* key, X509* authority) {
    SSL_CTX* const raw = context.native_handle();
    CD_CHECK(SSL_CTX_use_certificate(raw, certificate) == 1);
    CD_CHECK(SSL_CTX_use_PrivateKey(raw, key) == 1);
    // Sends the authority too, for joiners that know only its fingerprint.
    CD_CHECK(SSL_CTX_add1_chain_cert(raw, authority) == 1);
}

void trust(asio::ssl::context& context, X509* authority) {
    X509_STORE* const store = SSL_CTX_get_cert_store(context.native_handle());
    CD_CHECK(X509_STORE_add_cert(store, authority) == 1);
    X509_STORE_set_flags(store, X509_V_FLAG_X509_STRICT);
}

struct FreeStack {
    void operator()(STACK_OF(X509) * stack) const { sk_X509_free(stack); }
};

/// Replaces OpenSSL's verification: trusts the pinned authority if the peer sent it, then verifies
/// as usual.
int verify_pinned(X509_STORE_CTX* verification, void* pinned) {
    const STACK_OF(X509)* const sent = X509_STORE_CTX_get0_untrusted(verification);
    const std::unique_ptr<STACK_OF(X509), FreeStack> trusted(sk_X509_new_null());
    CD_CHECK(trusted != nullptr);
    for (int i = 0; i < sk_X509_num(sent); ++i) {
        X509* const certificate = sk_X509_value(sent, i);
        if (openssl::fingerprint_of(certificate) == *static_cast<const Sha256*>(pinned)) {
            CD_CHECK(sk_X509_push(trusted.get(), certificate) > 0);
        }
    }
    X509_STORE_CTX_set0_trusted_stack(verification, trusted.get());
    return X509_verify_cert(verification);
}

} // namespace

Tls::Tls(std::unique_ptr<State> state) : state_(std::move(state)) {}
Tls::~Tls() = default;

Result<std::shared_ptr<const Tls>> Tls::make(const Credential& credential) {
    const openssl::Certificate certificate = openssl::parse_certificate(credential.certificate);
    const openssl::Certificate authority = openssl::parse_certificate(credential.authority);
    const openssl::Key key = openssl::parse_key(credential.key);
    if (certificate == nullptr || authority == nullptr || key == nullptr ||
        X509_check_private_key(certificate.get(), key.get()) != 1) {
        return Error{ErrorCode::BadInput,
                     "no private key with a certificate for it and that of its authority"};
    }
    const Result<Identity> identity = openssl::identity_of(certificate.get());
    if (!identity) {
        return identity.error();
    }
    auto state = std::make_unique<State>();
    state->identity = identity.value();
    for (asio::ssl::context* context : {&state->accepting, &state->connecting}) {
        prepare(*context);
        show(*context, certificate.get(), key.get(), authority.get());
        trust(*context, authority.get());
    }
    return std::shared_ptr<const Tls>(new Tls(std::move(state)));
}

std::shared_ptr<const Tls> Tls::make_joining(const Sha256& authority) {
    auto state = std::make_unique<State>();
    state->pinned = authority;
    prepare(state->connecting);
    SSL_CTX_set_cert_verify_callback(
        state->connecting.native_handle(), verify_pinned, &state->pinned);
    return std::shared_ptr<const Tls>(new Tls(std::move(state)));
}

const std::optional<Identity>& Tls::identity() const {
    return state_->identity;
}

} // namespace cd
