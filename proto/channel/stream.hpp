// The bytes of one TCP connection, plain or inside TLS.
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

/// Which end of a connection this one is.
enum class TlsEnd { Connecting, Accepting };

/// One end. Plain until it is secured; what reads and writes it sees no difference. It must outlive
/// its operations. Its end is not authenticated, and means no more than a lost connection: what
/// ends well says so by a message.
class Stream {
  public:
    using Handler = std::function<void(const boost::system::error_code&, std::size_t)>;

    /// The socket is connected.
    explicit Stream(asio::ip::tcp::socket socket);
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream();

    /// From now on everything goes through TLS. Nothing has been read or written, and `tls` shows a
    /// credential where this end accepts. Errors: Refused, where one end does not take the other
    /// and says so; Disconnected; Timeout.
    [[nodiscard]] asio::awaitable<Status>
    secure(std::shared_ptr<const Tls> tls, TlsEnd end, std::chrono::steady_clock::duration timeout);

    /// What the other end has proven to be. Nothing of a plain stream, or of who showed nothing.
    [[nodiscard]] const std::optional<Identity>& peer_identity() const;
    [[nodiscard]] bool is_secured() const;
    /// Bytes that both ends of this connection know and nobody else (RFC 9266). Nothing of a plain
    /// stream.
    [[nodiscard]] std::optional<Sha256> binding() const;

    /// At least one byte, as far as they have come. At the stream's end: asio::error::eof.
    void read_some(asio::mutable_buffer buffer, Handler handler);
    /// All of both.
    void write(const std::array<asio::const_buffer, 2>& buffers, Handler handler);
    /// Nothing more comes from this end.
    void end_writing();
    /// Ends what is under way.
    void close();

    [[nodiscard]] asio::ip::tcp::socket& socket();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What an error of a stream means.
[[nodiscard]] Error stream_error(const boost::system::error_code& error);

} // namespace cd
