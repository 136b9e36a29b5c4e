#include "proto/channel/channel.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"

#include <netinet/tcp.h>

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

namespace cd {
namespace {

using boost::system::error_code;
using Clock = std::chrono::steady_clock;

enum class Phase {
    Open,
    Flushing, ///< Sends the queue, then waits until the peer closes; discards input.
    Closed,
};

/// An outgoing message, which stays in its lane until its last frame is written.
struct Outgoing {
    std::uint16_t type = 0;
    Bytes payload;
    std::size_t sent = 0;
};

constexpr std::size_t lane_control = 0;
constexpr std::size_t lane_data = 1;

std::size_t bytes_on_the_wire(std::size_t payload) {
    const std::size_t frames =
        (payload + limits::frame_sent_bytes_max - 1) / limits::frame_sent_bytes_max;
    return payload + std::max<std::size_t>(1, frames) * frame_header_bytes;
}

asio::ip::tcp::endpoint remote_end(const asio::ip::tcp::socket& socket) {
    error_code ignored; // Gives 0.0.0.0:0 for a disconnected socket.
    return socket.remote_endpoint(ignored);
}

std::string own_address(const asio::ip::tcp::socket& socket) {
    error_code ignored;
    return socket.local_endpoint(ignored).address().to_string();
}

/// Enables TCP keepalive: the operating systems probe the connection without the programs.
void keep_alive(asio::ip::tcp::socket& socket) {
    error_code ignored;
    socket.set_option(asio::socket_base::keep_alive(true), ignored);
    for (const auto& [option, value] : {std::pair(TCP_KEEPIDLE, limits::keepalive_idle_seconds),
                                        std::pair(TCP_KEEPINTVL, limits::keepalive_period_seconds),
                                        std::pair(TCP_KEEPCNT, limits::keepalive_probes)}) {
        (void)setsockopt(socket.native_handle(), IPPROTO_TCP, option, &value, sizeof(value));
    }
}

/// Pending operations share the state, so it outlives the channel until they have ended. All
/// handlers run on the socket's executor.
struct ChannelState : std::enable_shared_from_this<ChannelState> {
    ChannelState(std::unique_ptr<Stream> connected, const StallBounds& longest_stalls)
        : stream(std::move(connected)),
          peer_host(remote_end(stream->socket()).address().to_string()),
          peer(peer_host + ":" + std::to_string(remote_end(stream->socket()).port())),
          own_host(own_address(stream->socket())),
          stalls(longest_stalls),
          received(stream->socket().get_executor()),
          read_deadline(stream->socket().get_executor()),
          written(stream->socket().get_executor()),
          write_deadline(stream->socket().get_executor()),
          flush_deadline(stream->socket().get_executor()) {
        assembler.expect(Party::Stranger);
        written.expires_at(Clock::time_point::max());
        error_code ignored;
        stream->socket().set_option(asio::ip::tcp::no_delay(true), ignored);
        keep_alive(stream->socket());
    }

    void read_next();
    void read_part(asio::mutable_buffer rest, void (ChannelState::*next)());
    void read_header();
    void read_payload();
    void header_came();
    void payload_came();
    void watch_read();
    [[nodiscard]] bool may_be_large() const;
    void deliver(const MessageAssembler::Whole& whole_message);
    void read_failed(const error_code& error);
    void drop_incoming();
    void refuse(Error error);

    void send(const Message& message);
    void write_next();
    void frame_written(std::size_t lane, std::size_t payload, const error_code& error);
    void watch_write();

    void flush_and_close();
    void fail(Error error);
    void shut();

    std::unique_ptr<Stream> stream;
    std::string peer_host;
    std::string peer;
    std::string own_host;
    StallBounds stalls;
    Phase phase = Phase::Open;
    Traffic traffic;
    std::optional<Error> failure; ///< Why the channel is no longer open; empty while it is.

    std::array<std::byte, frame_header_bytes> header_bytes{};
    FrameHeader header;
    Bytes frame;          ///< Grows to the largest frame seen.
    std::size_t came = 0; ///< Received bytes of the header or the payload.
    MessageAssembler assembler;
    std::optional<Clock::time_point> rest_due; ///< Deadline of the current frame; empty: none.
    bool watching_read = false;
    std::optional<Message> incoming; ///< Received, but not yet returned by `receive`.
    bool reading = false;
    bool receiving = false;
    asio::steady_timer received; ///< Cancelled when `incoming` or `failure` is set.
    asio::steady_timer read_deadline;

    std::array<std::deque<Outgoing>, 2> lanes;
    std::size_t queued_bytes = 0;
    bool writing = false;
    std::uint64_t frames_begun = 0;
    asio::steady_timer written; ///< Never expires; cancelled when the queue changes.
    asio::steady_timer write_deadline;
    asio::steady_timer flush_deadline;
};

/// A channel over a stream.
class StreamChannel final : public Channel {
  public:
    explicit StreamChannel(std::shared_ptr<ChannelState> state) : state_(std::move(state)) {}
    ~StreamChannel() override {
        if (state_->phase == Phase::Open) {
            state_->shut();
        }
    }

    [[nodiscard]] asio::awaitable<Result<Message>>
    receive(std::chrono::steady_clock::duration timeout) override;
    void expect(Party party) override { state_->assembler.expect(party); }
    void send(const Message& message) override { state_->send(message); }
    [[nodiscard]] std::size_t queued_bytes() const override { return state_->queued_bytes; }
    [[nodiscard]] asio::awaitable<void> wait_until_queued_below(std::size_t bytes) override;
    void close(bool flush) override;
    [[nodiscard]] bool is_open() const override { return state_->phase == Phase::Open; }
    [[nodiscard]] asio::awaitable<void> wait_until_closed() override;
    [[nodiscard]] const Traffic& traffic() const override { return state_->traffic; }
    [[nodiscard]] const std::string& peer() const override { return state_->peer; }
    [[nodiscard]] const std::string& peer_host() const override { return state_->peer_host; }
    [[nodiscard]] const std::string& own_host() const override { return state_->own_host; }
    [[nodiscard]] bool is_secured() const override { return state_->stream->is_secured(); }
    [[nodiscard]] std::optional<Identity> peer_identity() const override {
        return state_->stream->peer_identity();
    }
    [[nodiscard]] std::optional<Sha256> binding() const override {
        return state_->stream->binding();
    }

  private:
    std::shared_ptr<ChannelState> state_; ///< Shared with pending operations.
};

} // namespace

// ---- Reading --------------------------------------------------------------------------------

void ChannelState::read_next() {
    if (reading || phase != Phase::Open) {
        return;
    }
    came = 0;
    if (assembler.has_begun()) {
        watch_read();
    }
    read_header();
}

void ChannelState::read_header() {
    read_part(asio::buffer(header_bytes) + came, &ChannelState::header_came);
}

void ChannelState::read_payload() {
    read_part(asio::buffer(frame.data(), header.payload_bytes) + came, &ChannelState::payload_came);
}

/// Reads some bytes into `rest`, then calls `next`.
void ChannelState::read_part(asio::mutable_buffer rest, void (ChannelState::*next)()) {
    reading = true;
    stream->read_some(
        rest, [self = shared_from_this(), next](const error_code& error, std::size_t bytes) {
            self->reading = false;
            self->traffic.bytes_received += bytes;
            self->came += bytes;
            if (error || self->phase != Phase::Open) {
                return self->read_failed(error);
            }
            (self.get()->*next)();
        });
}

void ChannelState::header_came() {
    if (came < header_bytes.size()) {
        // An answer in another protocol may be shorter than a header.
        if (auto foreign = foreign_answer(std::span(header_bytes).first(came))) {
            return fail(std::move(*foreign));
        }
        watch_read();
        return read_header();
    }
    auto decoded = decode_header(header_bytes);
    if (!decoded) {
        return fail(decoded.error());
    }
    header = decoded.value();
    if (header.has_more && header.payload_bytes < limits::frame_with_more_bytes_min) {
        return fail({ErrorCode::BadFrame, "a message in pieces that are too small"});
    }
    // Checks the header before allocating memory for the payload.
    if (const Status good = assembler.check(header); !good) {
        return refuse(good.error());
    }
    if (!may_be_large() && payload_bytes_max(header.type) > limits::message_control_bytes_max) {
        return fail({ErrorCode::BadFrame,
                     "message '" + std::string(message_name(header.type)) +
                         "' of a peer that has shown no certificate"});
    }
    if (frame.size() < header.payload_bytes) {
        frame.resize(header.payload_bytes); // Bounded by decode_header.
    }
    came = 0;
    if (header.payload_bytes == 0) {
        return payload_came();
    }
    watch_read();
    read_payload();
}

void ChannelState::payload_came() {
    if (came < header.payload_bytes) {
        return read_payload();
    }
    rest_due.reset();
    auto added = assembler.add(header, std::span(frame).first(header.payload_bytes));
    if (!added) {
        return fail(added.error());
    }
    if (!added.value()) {
        return read_next();
    }
    deliver(*added.value());
}

/// With TLS, a peer must show a certificate before its messages may take much memory.
bool ChannelState::may_be_large() const {
    return !stream->is_secured() || stream->peer_identity();
}

/// Starts the deadline of the current frame. One timer serves many frames: when it expires, the
/// frame is usually complete, and the timer waits for the deadline of a later frame.
void ChannelState::watch_read() {
    if (!rest_due) {
        rest_due = Clock::now() + stalls.read;
    }
    if (std::exchange(watching_read, true)) {
        return;
    }
    read_deadline.expires_at(*rest_due);
    read_deadline.async_wait([self = shared_from_this()](const error_code& error) {
        self->watching_read = false;
        if (error || self->phase != Phase::Open || !self->rest_due) {
            return;
        }
        if (*self->rest_due <= Clock::now()) {
            self->fail({ErrorCode::Disconnected, "a message that stands still midway"});
        } else {
            self->watch_read();
        }
    });
}

void ChannelState::deliver(const MessageAssembler::Whole& whole_message) {
    auto decoded = decode_message(whole_message.type, whole_message.payload);
    if (!decoded) {
        return fail(decoded.error());
    }
    if (assembler.sender() == Party::Stranger) {
        assembler.expect(Party::Anyone);
    }
    incoming = std::move(decoded.value());
    received.cancel();
}

/// Ends the connection. A peer that has greeted gets the reason first.
void ChannelState::refuse(Error error) {
    if (assembler.sender() == Party::Stranger) {
        return fail(std::move(error));
    }
    send(Failure{error.code, error.detail});
    failure = std::move(error);
    flush_and_close();
}

void ChannelState::read_failed(const error_code& error) {
    if (phase == Phase::Closed) {
        return;
    }
    if (phase == Phase::Open) {
        return fail(stream_error(error));
    }
    if (!error) {
        return drop_incoming();
    }
    // The peer may have closed only its sending half, and may still read the queued messages.
    if (error != asio::error::eof || lanes[lane_control].size() + lanes[lane_data].size() == 0) {
        shut();
    }
}

// Keeps reading while closing: unread bytes at a close would reset the connection and lose data
// still in transit to the peer.
void ChannelState::drop_incoming() {
    if (reading || phase != Phase::Flushing) {
        return;
    }
    reading = true;
    frame.resize(std::max<std::size_t>(frame.size(), 4096));
    stream->read_some(asio::buffer(frame),
                      [self = shared_from_this()](const error_code& error, std::size_t bytes) {
                          self->reading = false;
                          self->traffic.bytes_received += bytes;
                          self->read_failed(error);
                      });
}

// ---- Writing --------------------------------------------------------------------------------

void ChannelState::send(const Message& message) {
    if (phase != Phase::Open) {
        return;
    }
    Outgoing outgoing{message_type(message), encode_message(message), 0};
    CD_CHECK(outgoing.payload.size() <= payload_bytes_max(outgoing.type));
    queued_bytes += bytes_on_the_wire(outgoing.payload.size());
    lanes[travels_as_data(outgoing.type) ? lane_data : lane_control].push_back(std::move(outgoing));
    write_next();
}

void ChannelState::write_next() {
    if (writing || phase == Phase::Closed) {
        return;
    }
    const std::size_t lane = lanes[lane_control].empty() ? lane_data : lane_control;
    if (lanes[lane].empty()) {
        if (phase == Phase::Flushing) {
            stream->end_writing();
        }
        return;
    }
    const Outgoing& message = lanes[lane].front();
    const auto rest = std::span(message.payload).subspan(message.sent);
    const auto slice = rest.first(std::min(rest.size(), limits::frame_sent_bytes_max));
    FrameHeader out;
    out.type = message.type;
    out.has_more = slice.size() < rest.size();
    out.stream = static_cast<std::uint32_t>(lane);
    out.payload_bytes = static_cast<std::uint32_t>(slice.size());
    out.payload_checksum = checksum(slice);

    writing = true;
    // The handler shares the bytes, which must not move while they are written.
    const auto bytes =
        std::make_shared<const std::array<std::byte, frame_header_bytes>>(encode_header(out));
    const std::array<asio::const_buffer, 2> buffers{asio::buffer(*bytes),
                                                    asio::buffer(slice.data(), slice.size())};
    stream->write(buffers,
                  [self = shared_from_this(), bytes, lane, payload = slice.size()](
                      const error_code& error, std::size_t transferred) {
                      self->traffic.bytes_sent += transferred;
                      self->frame_written(lane, payload, error);
                  });
    watch_write();
}

void ChannelState::frame_written(std::size_t lane, std::size_t payload, const error_code& error) {
    writing = false;
    write_deadline.cancel();
    if (phase == Phase::Closed) {
        lanes = {};
        return;
    }
    if (error) {
        return fail(stream_error(error));
    }
    Outgoing& message = lanes[lane].front();
    message.sent += payload;
    queued_bytes -= payload + frame_header_bytes;
    if (message.sent == message.payload.size()) {
        lanes[lane].pop_front();
    }
    written.cancel();
    write_next();
}

void ChannelState::watch_write() {
    write_deadline.expires_after(stalls.write);
    write_deadline.async_wait(
        [self = shared_from_this(), frame_number = ++frames_begun](const error_code& error) {
            // A timer's handler that is already queued runs even after the cancel.
            if (!error && self->writing && self->frames_begun == frame_number) {
                self->fail({ErrorCode::Disconnected, "the peer does not read"});
            }
        });
}

// ---- Closing --------------------------------------------------------------------------------

void ChannelState::flush_and_close() {
    phase = Phase::Flushing;
    if (!failure) {
        failure = Error{ErrorCode::Disconnected, "closed on this side"};
    }
    received.cancel();
    written.cancel();
    flush_deadline.expires_after(timing::close_flush_max);
    flush_deadline.async_wait([self = shared_from_this()](const error_code& error) {
        if (!error) {
            self->shut();
        }
    });
    drop_incoming();
    write_next();
}

void ChannelState::fail(Error error) {
    if (!failure) {
        failure = std::move(error);
    }
    shut();
}

void ChannelState::shut() {
    if (phase == Phase::Closed) {
        return;
    }
    phase = Phase::Closed;
    if (!failure) {
        failure = Error{ErrorCode::Disconnected, "closed on this side"};
    }
    stream->close();
    if (!writing) {
        lanes = {};
    }
    queued_bytes = 0;
    received.cancel();
    read_deadline.cancel();
    written.cancel();
    write_deadline.cancel();
    flush_deadline.cancel();
}

// ---- The channel ----------------------------------------------------------------------------

std::shared_ptr<Channel> Channel::make(std::unique_ptr<Stream> stream, const StallBounds& stalls) {
    return std::make_shared<StreamChannel>(
        std::make_shared<ChannelState>(std::move(stream), stalls));
}

asio::awaitable<Result<Message>>
StreamChannel::receive(std::chrono::steady_clock::duration timeout) {
    const std::shared_ptr<ChannelState> state = state_;
    CD_CHECK(!state->receiving);
    if (!state->incoming && state->phase == Phase::Open) {
        state->receiving = true;
        state->read_next();
        state->received.expires_after(timeout);
        error_code ignored;
        co_await state->received.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        state->receiving = false;
    }
    if (state->incoming) {
        Result<Message> message(std::move(*state->incoming));
        state->incoming.reset();
        co_return message;
    }
    if (state->failure) {
        co_return *state->failure;
    }
    co_return Error{ErrorCode::Timeout, "no message in time"};
}

asio::awaitable<void> StreamChannel::wait_until_queued_below(std::size_t bytes) {
    const std::shared_ptr<ChannelState> state = state_;
    while (state->phase == Phase::Open && state->queued_bytes >= bytes) {
        error_code ignored;
        co_await state->written.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

asio::awaitable<void> StreamChannel::wait_until_closed() {
    const std::shared_ptr<ChannelState> state = state_;
    while (state->phase != Phase::Closed) {
        error_code ignored;
        co_await state->written.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

void StreamChannel::close(bool flush) {
    if (!flush) {
        state_->shut();
    } else if (state_->phase == Phase::Open) {
        state_->flush_and_close();
    }
}

} // namespace cd
