#include "proto/channel/stream.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/wire.hpp"
#include "proto/channel/deadline.hpp"
#include "proto/channel/tls_state.hpp"
#include "proto/identity/openssl.hpp"

#include <openssl/err.h>
#include <openssl/ssl.h>

#include <limits>
#include <string_view>
#include <utility>

namespace cd {

namespace {

using boost::system::error_code;

/// OpenSSL's reason for a peer's alert is this offset plus the alert's number.
constexpr int alert_reason = SSL_AD_REASON_OFFSET;
/// Label of the channel binding (RFC 9266, section 4.2).
constexpr std::string_view binding_label = "EXPORTER-Channel-Binding";

/// Completion condition: transfers the whole buffer in as few system calls as possible.
std::size_t whole(const error_code& error, std::size_t /*transferred*/) {
    return error ? 0 : std::numeric_limits<std::size_t>::max();
}

bool is_of_tls(const error_code& error) {
    return error.category() == asio::error::get_ssl_category();
}

int reason_of(const error_code& error) {
    return ERR_GET_REASON(static_cast<unsigned long>(error.value()));
}

/// Whether an OpenSSL reason says that the peer speaks another protocol.
bool is_other_protocol(int reason) {
    return reason == SSL_R_WRONG_VERSION_NUMBER || reason == SSL_R_UNSUPPORTED_PROTOCOL;
}

/// Whether an alert is about damaged bytes, not about the peer's identity (RFC 8446, section 6.2).
bool tells_of_damage(int alert) {
    switch (alert) {
    case SSL_AD_UNEXPECTED_MESSAGE:
    case SSL_AD_BAD_RECORD_MAC:
    case SSL_AD_RECORD_OVERFLOW:
    case SSL_AD_ILLEGAL_PARAMETER:
    case SSL_AD_DECODE_ERROR:
    case SSL_AD_MISSING_EXTENSION:
    case SSL_AD_UNSUPPORTED_EXTENSION:
        return true;
    default:
        return false;
    }
}

std::string reason_text(const error_code& error) {
    const char* const text = ERR_reason_error_string(static_cast<unsigned long>(error.value()));
    return text == nullptr ? error.message() : text;
}

bool is_end(const error_code& error) {
    return error == asio::error::eof || error == asio::ssl::error::stream_truncated;
}

Status take_identity(SSL* ssl, std::optional<Identity>& identity) {
    const openssl::Certificate certificate(SSL_get1_peer_certificate(ssl));
    if (certificate == nullptr) {
        return Done{};
    }
    Result<Identity> read = openssl::identity_of(certificate.get());
    if (!read) {
        return Error{ErrorCode::Refused, "the other end shows " + read.error().detail};
    }
    identity = std::move(read.value());
    return Done{};
}

Error handshake_error(const error_code& error, SSL* ssl) {
    const long verdict = SSL_get_verify_result(ssl);
    if (is_of_tls(error) && verdict != X509_V_OK) {
        return {ErrorCode::Refused,
                "the other end's certificate is not good: " +
                    std::string(X509_verify_cert_error_string(verdict))};
    }
    if (is_of_tls(error) && is_other_protocol(reason_of(error))) {
        return {ErrorCode::Refused,
                "no TLS 1.3 with the other end: " + reason_text(error) +
                    (SSL_is_server(ssl) == 1 ? "" : "; is that the master's --http port?")};
    }
    Error other = stream_error(error);
    if (reason_of(error) == alert_reason + SSL_AD_PROTOCOL_VERSION) {
        other.detail += "; it speaks no TLS, or an older version";
    }
    other.detail += ", during the TLS handshake";
    if (other.code == ErrorCode::Disconnected) {
        other.detail += "; all connection slots of the other end may be taken";
    }
    return other;
}

} // namespace

struct Stream::State {
    explicit State(asio::ip::tcp::socket connected) : socket(std::move(connected)) {}

    asio::ip::tcp::socket socket;
    std::shared_ptr<const Tls> tls; ///< Owns the context that `session` uses.
    std::unique_ptr<asio::ssl::stream<asio::ip::tcp::socket&>> session; ///< Null: plain.
    std::optional<Identity> peer;
    std::uint64_t key_bytes = 0; ///< Bytes written with the current TLS key.
};

Stream::Stream(asio::ip::tcp::socket socket) : state_(std::make_unique<State>(std::move(socket))) {}
Stream::~Stream() = default;

asio::awaitable<Status> Stream::secure(std::shared_ptr<const Tls> tls,
                                       TlsEnd end,
                                       std::chrono::steady_clock::duration timeout) {
    const bool connecting = end == TlsEnd::Connecting;
    CD_CHECK(connecting || tls->identity());
    state_->tls = std::move(tls);
    Tls::State& contexts = state_->tls->state();
    state_->session = std::make_unique<asio::ssl::stream<asio::ip::tcp::socket&>>(
        state_->socket, connecting ? contexts.connecting : contexts.accepting);
    const Deadline deadline(state_->socket, timeout);
    error_code error;
    co_await state_->session->async_handshake(connecting ? asio::ssl::stream_base::client
                                                         : asio::ssl::stream_base::server,
                                              asio::redirect_error(asio::use_awaitable, error));
    if (deadline.expired()) {
        co_return Error{ErrorCode::Timeout, "no TLS handshake in time"};
    }
    if (error) {
        co_return handshake_error(error, state_->session->native_handle());
    }
    co_return take_identity(state_->session->native_handle(), state_->peer);
}

const std::optional<Identity>& Stream::peer_identity() const {
    return state_->peer;
}

bool Stream::is_secured() const {
    return state_->session != nullptr;
}

std::optional<Sha256> Stream::binding() const {
    if (state_->session == nullptr) {
        return std::nullopt;
    }
    Sha256 binding;
    CD_CHECK(SSL_export_keying_material(state_->session->native_handle(),
                                        reinterpret_cast<unsigned char*>(binding.bytes.data()),
                                        binding.bytes.size(),
                                        binding_label.data(),
                                        binding_label.size(),
                                        nullptr,
                                        0,
                                        0) == 1);
    return binding;
}

void Stream::read_some(asio::mutable_buffer buffer, Handler handler) {
    if (state_->session == nullptr) {
        state_->socket.async_read_some(buffer, std::move(handler));
        return;
    }
    state_->session->async_read_some(
        buffer, [handler = std::move(handler)](const error_code& error, std::size_t bytes) {
            handler(is_end(error) ? error_code(asio::error::eof) : error, bytes);
        });
}

void Stream::write(const std::array<asio::const_buffer, 2>& buffers, Handler handler) {
    if (state_->session == nullptr) {
        asio::async_write(state_->socket, buffers, whole, std::move(handler));
        return;
    }
    // A key may encrypt about 2^24 records of AES-GCM (RFC 8446, section 5.5).
    state_->key_bytes += buffers[0].size() + buffers[1].size();
    if (state_->key_bytes > limits::tls_key_bytes_max) {
        state_->key_bytes = 0;
        SSL* const ssl = state_->session->native_handle();
        CD_CHECK(SSL_key_update(ssl, SSL_KEY_UPDATE_NOT_REQUESTED) == 1);
    }
    asio::async_write(*state_->session, buffers, whole, std::move(handler));
}

void Stream::end_writing() {
    error_code ignored;
    state_->socket.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

void Stream::close() {
    error_code ignored;
    state_->socket.shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
    state_->socket.close(ignored);
}

asio::ip::tcp::socket& Stream::socket() {
    return state_->socket;
}

Error stream_error(const error_code& error) {
    if (is_end(error)) {
        return {ErrorCode::Disconnected, "the peer closed the connection"};
    }
    if (!is_of_tls(error)) {
        return {ErrorCode::Disconnected, error.message()};
    }
    const int reason = reason_of(error);
    if (reason >= alert_reason && tells_of_damage(reason - alert_reason)) {
        return {ErrorCode::BadFrame,
                "bytes arrived damaged at the other end: " +
                    std::string(SSL_alert_desc_string_long(reason - alert_reason))};
    }
    if (reason >= alert_reason) {
        return {ErrorCode::Refused,
                "the other end does not take this one: " +
                    std::string(SSL_alert_desc_string_long(reason - alert_reason))};
    }
    return {ErrorCode::BadFrame, "bytes that are not of this TLS session: " + reason_text(error)};
}

} // namespace cd
