// The byte stream of one TCP connection, plain or in TLS.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/tls.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace cd {

/// The part that a program has in a TLS handshake: client or server.
enum class TlsEnd { Connecting, Accepting };

/// One end of a connection; plain until `secure`. Reads and writes have the same interface in TLS.
/// A stream must outlive its operations. The end of the bytes is not authenticated and means only a
/// lost connection; a message announces a regular end.
class Stream {
  public:
    using Handler = std::function<void(const boost::system::error_code&, std::size_t)>;

    /// The socket must be connected.
    explicit Stream(asio::ip::tcp::socket socket);
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream();

    /// Switches to TLS. Nothing may have been read or written, and an accepting end needs a `tls`
    /// with a credential. Errors: Refused if either end rejects the other with an alert;
    /// Disconnected; Timeout.
    [[nodiscard]] asio::awaitable<Status>
    secure(std::shared_ptr<const Tls> tls, TlsEnd end, std::chrono::steady_clock::duration timeout);

    /// The peer's proven identity. Empty for a plain stream or a peer without a certificate.
    [[nodiscard]] const std::optional<Identity>& peer_identity() const;
    [[nodiscard]] bool is_secured() const;
    /// The channel binding: a value that only the two ends of this connection know (RFC 9266).
    /// Empty for a plain stream.
    [[nodiscard]] std::optional<Sha256> binding() const;

    /// Reads at least one byte. Reports asio::error::eof at the end of the stream.
    void read_some(asio::mutable_buffer buffer, Handler handler);
    /// Writes both buffers completely.
    void write(const std::array<asio::const_buffer, 2>& buffers, Handler handler);
    /// Closes the sending half.
    void end_writing();
    /// Closes the socket and cancels pending operations.
    void close();

    [[nodiscard]] asio::ip::tcp::socket& socket();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Translates an error of a stream to Disconnected, BadFrame or Refused.
[[nodiscard]] Error stream_error(const boost::system::error_code& error);

} // namespace cd
