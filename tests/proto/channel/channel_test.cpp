// Proves the channel's promises over a real connection: whole messages in order, control before
// data, bounded memory for a slow reader, an error for every misbehaviour of a peer, and a close
// that sends everything queued.
#include "proto/channel/channel.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"
#include "tests/proto/loopback.hpp"
#include "tests/proto/sample_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

Results results_of(std::uint64_t task, std::size_t bytes) {
    Results results;
    results.task = TaskId{task};
    results.count = 1;
    results.records.assign(bytes, std::byte{7});
    return results;
}

CD_CONVERSATION(Channel, EveryMessageArrivesInTheOrderOfItsLane) {
    const Ends ends = co_await connect_greeted_ends();
    std::vector<Message> sent;
    for (const bool data : {false, true}) {
        for (const Message& message : sample_messages()) {
            if (travels_as_data(message_type(message)) == data) {
                sent.push_back(message);
            }
        }
    }
    for (const Message& message : sent) {
        ends.left->send(message);
    }
    for (const Message& message : sent) {
        const Result<Message> came = co_await ends.right->receive(patience);
        EXPECT_TRUE(came);
        EXPECT_EQ(encode_message(came.value()), encode_message(message));
    }
    EXPECT_EQ(ends.left->queued_bytes(), 0u);
    EXPECT_EQ(ends.left->traffic().bytes_sent, ends.right->traffic().bytes_received);
    ends.left->close();
}

CD_CONVERSATION(Channel, AHeartbeatOvertakesALargeMessage) {
    const Ends ends = co_await connect_greeted_ends();
    ends.left->send(results_of(1, 48u << 20));
    ends.left->send(results_of(2, 10));
    ends.left->send(Heartbeat{});
    const Result<Message> first = co_await ends.right->receive(patience);
    EXPECT_TRUE(std::holds_alternative<Heartbeat>(first.value()));
    const Result<Message> second = co_await ends.right->receive(patience);
    EXPECT_EQ(std::get<Results>(second.value()).records.size(), 48u << 20);
    const Result<Message> third = co_await ends.right->receive(patience);
    EXPECT_EQ(std::get<Results>(third.value()).task, TaskId{2});
    ends.left->close();
}

CD_CONVERSATION(Channel, AReaderThatDoesNotReadStopsTheSender) {
    const Ends ends = co_await connect_greeted_ends();
    for (std::uint64_t i = 0; i < 48; ++i) {
        ends.left->send(results_of(i, 1u << 20));
    }
    // Let time pass; the two sockets buffer far less than what is queued.
    const Result<Message> nothing = co_await ends.left->receive(100ms);
    EXPECT_EQ(nothing.error().code, ErrorCode::Timeout);
    EXPECT_GT(ends.left->queued_bytes(), 16u << 20);
    for (std::uint64_t i = 0; i < 48; ++i) {
        const Result<Message> came = co_await ends.right->receive(patience);
        EXPECT_EQ(std::get<Results>(came.value()).task, TaskId{i});
    }
    co_await ends.left->wait_until_queued_below(1);
    EXPECT_EQ(ends.left->queued_bytes(), 0u);
    ends.left->close();
}

CD_CONVERSATION(Channel, WaitingForTheQueueEndsWhenTheChannelCloses) {
    const Ends ends = co_await connect_greeted_ends();
    ends.left->send(results_of(1, 64u << 20));
    const auto executor = co_await asio::this_coro::executor;
    asio::post(executor, [left = ends.left] { left->close(); });
    co_await ends.left->wait_until_queued_below(1);
    EXPECT_FALSE(ends.left->is_open());
    ends.left->send(Heartbeat{});
    EXPECT_EQ(ends.left->queued_bytes(), 0u);
}

CD_CONVERSATION(Channel, ATimeoutLosesNothing) {
    const Ends ends = co_await connect_greeted_ends();
    const Result<Message> nothing = co_await ends.right->receive(1ms);
    EXPECT_EQ(nothing.error().code, ErrorCode::Timeout);
    EXPECT_TRUE(ends.right->is_open());
    ends.left->send(Heartbeat{5, 6, 7, {}});
    const Result<Message> came = co_await ends.right->receive(patience);
    EXPECT_EQ(std::get<Heartbeat>(came.value()).waiting, 7u);
    ends.left->close();
}

CD_CONVERSATION(Channel, CloseWakesWhoReceives) {
    const Ends ends = co_await connect_greeted_ends();
    const auto executor = co_await asio::this_coro::executor;
    asio::post(executor, [left = ends.left] { left->close(); });
    const Result<Message> nothing = co_await ends.left->receive(patience);
    EXPECT_EQ(nothing.error().code, ErrorCode::Disconnected);
    const Result<Message> peer = co_await ends.right->receive(patience);
    EXPECT_EQ(peer.error().code, ErrorCode::Disconnected);
    EXPECT_FALSE(ends.right->is_open());
}

CD_CONVERSATION(Channel, ACloseWithFlushDeliversAllEvenWhileThePeerSends) {
    Ends ends = co_await connect_greeted_ends();
    ends.right->send(results_of(9, 8u << 20));
    for (std::uint64_t i = 0; i < 20; ++i) {
        ends.left->send(results_of(i, 1u << 20));
    }
    ends.left->close(true);
    ends.left.reset();
    for (std::uint64_t i = 0; i < 20; ++i) {
        const Result<Message> came = co_await ends.right->receive(patience);
        EXPECT_TRUE(came);
        EXPECT_EQ(std::get<Results>(came.value()).task, TaskId{i});
        ends.right->send(Heartbeat{});
    }
    const Result<Message> end = co_await ends.right->receive(patience);
    EXPECT_EQ(end.error().code, ErrorCode::Disconnected);
}

CD_CONVERSATION(Channel, DroppingItClosesTheConnection) {
    Ends ends = co_await connect_greeted_ends();
    const Result<Message> nothing = co_await ends.left->receive(1ms);
    EXPECT_FALSE(nothing);
    ends.left.reset();
    const Result<Message> end = co_await ends.right->receive(patience);
    EXPECT_EQ(end.error().code, ErrorCode::Disconnected);
}

/// Sends the bytes and closes; returns the other channel's error.
asio::awaitable<ErrorCode> verdict_on(Bytes bytes) {
    SocketEnds ends = co_await connect_sockets();
    asio::ip::tcp::socket& raw = ends.left;
    const auto channel = Channel::make(std::make_unique<Stream>(std::move(ends.right)));
    co_await asio::async_write(raw, asio::buffer(bytes), asio::use_awaitable);
    raw.close();
    const Result<Message> message = co_await channel->receive(patience);
    EXPECT_FALSE(message);
    EXPECT_FALSE(channel->is_open());
    const Result<Message> again = co_await channel->receive(patience);
    EXPECT_EQ(again.error().code, message.error().code);
    co_return message.error().code;
}

Bytes frame_of(const Message& message) {
    const Bytes payload = encode_message(message);
    FrameHeader header;
    header.type = message_type(message);
    header.payload_bytes = static_cast<std::uint32_t>(payload.size());
    header.payload_checksum = checksum(payload);
    const auto head = encode_header(header);
    Bytes bytes(head.begin(), head.end());
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
}

CD_CONVERSATION(Channel, BytesThatAreNoMessageEndTheConnection) {
    Bytes zeros(200);
    EXPECT_EQ(co_await verdict_on(zeros), ErrorCode::BadFrame);
    Bytes damaged = frame_of(Hello{});
    damaged.back() ^= std::byte{1};
    EXPECT_EQ(co_await verdict_on(damaged), ErrorCode::BadFrame);
    Bytes ungreeted = frame_of(Heartbeat{});
    EXPECT_EQ(co_await verdict_on(ungreeted), ErrorCode::BadFrame);
}

CD_CONVERSATION(Channel, APeerThatClosesMidFrameIsDisconnected) {
    const Bytes frame = frame_of(Hello{});
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, frame.size() - 1}) {
        Bytes piece(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_EQ(co_await verdict_on(piece), ErrorCode::Disconnected);
    }
}

CD_CONVERSATION(Channel, WhatThePeerMayNotSendIsRefusedBeforeItHasCome) {
    SocketEnds ends = co_await connect_sockets();
    asio::ip::tcp::socket& raw = ends.left;
    asio::ip::tcp::socket& socket = ends.right;
    const auto channel = Channel::make(std::make_unique<Stream>(std::move(socket)));
    const Bytes hello = frame_of(Hello{});
    co_await asio::async_write(raw, asio::buffer(hello), asio::use_awaitable);
    const Result<Hello> greeted = co_await accept_hello(channel);
    EXPECT_TRUE(greeted);
    // The first header of the largest message, and not one byte more.
    FrameHeader header;
    header.type = message_type(Subtrees{});
    header.has_more = true;
    header.payload_bytes = limits::frame_payload_bytes_max;
    const auto head = encode_header(header);
    co_await asio::async_write(raw, asio::buffer(head), asio::use_awaitable);
    const Result<Message> refused = co_await channel->receive(patience);
    EXPECT_EQ(refused.error().code, ErrorCode::BadFrame);
    EXPECT_THAT(refused.error().detail, HasSubstr("does not send 'subtrees'"));
    EXPECT_FALSE(channel->is_open());
    // The channel sends the reason, and the connection ends after the peer had time to read it.
    const Bytes told = frame_of(Failure{refused.error().code, refused.error().detail});
    Bytes came(told.size());
    co_await asio::async_read(raw, asio::buffer(came), asio::use_awaitable);
    EXPECT_EQ(came, told);
    raw.close();
    co_await channel->wait_until_closed();
}

/// Connects, sends only these bytes, and waits until the other end gives up.
asio::awaitable<Error> verdict_on_standstill_after(Bytes bytes, bool is_greeted = false) {
    SocketEnds ends = co_await connect_sockets();
    const auto channel =
        Channel::make(std::make_unique<Stream>(std::move(ends.right)), {.read = 20ms});
    asio::ip::tcp::socket& slow = ends.left;
    co_await asio::async_write(slow, asio::buffer(bytes), asio::use_awaitable);
    Result<Message> message = co_await channel->receive(patience);
    if (is_greeted) {
        EXPECT_TRUE(message);
        message = co_await channel->receive(patience);
    }
    EXPECT_FALSE(channel->is_open());
    co_return message.error();
}

CD_CONVERSATION(Channel, AMessageThatStandsStillMidwayEndsTheConnection) {
    const Bytes hello = frame_of(Hello{});
    for (const std::size_t size :
         {std::size_t{1}, frame_header_bytes - 1, frame_header_bytes, hello.size() - 1}) {
        Bytes piece(hello.begin(), hello.begin() + static_cast<std::ptrdiff_t>(size));
        const Error verdict = co_await verdict_on_standstill_after(std::move(piece));
        EXPECT_EQ(verdict.code, ErrorCode::Disconnected);
        EXPECT_THAT(verdict.detail, HasSubstr("midway"));
    }
}

CD_CONVERSATION(Channel, AFrameThatPromisesMoreIsHeldToIt) {
    FrameHeader header;
    header.type = message_type(Results{});
    header.has_more = true;
    header.payload_bytes = limits::frame_with_more_bytes_min;
    const Bytes payload(header.payload_bytes);
    header.payload_checksum = checksum(payload);
    const auto head = encode_header(header);
    Bytes begun = frame_of(Hello{});
    begun.insert(begun.end(), head.begin(), head.end());
    begun.insert(begun.end(), payload.begin(), payload.end());
    const Error verdict = co_await verdict_on_standstill_after(std::move(begun), true);
    EXPECT_EQ(verdict.code, ErrorCode::Disconnected);
    EXPECT_THAT(verdict.detail, HasSubstr("midway"));
}

CD_CONVERSATION(Channel, AMessageInSmallPiecesIsNotTaken) {
    FrameHeader header;
    header.type = message_type(Results{});
    header.has_more = true;
    header.payload_bytes = limits::frame_with_more_bytes_min - 1;
    const auto head = encode_header(header);
    Bytes begun = frame_of(Hello{});
    begun.insert(begun.end(), head.begin(), head.end());
    const Error verdict = co_await verdict_on_standstill_after(std::move(begun), true);
    EXPECT_EQ(verdict.code, ErrorCode::BadFrame);
    EXPECT_THAT(verdict.detail, HasSubstr("too small"));
}

CD_CONVERSATION(Channel, SlowLinksGetLargeMessagesInSmallFrames) {
    SocketEnds ends = co_await connect_sockets();
    const std::shared_ptr<Channel> channel =
        Channel::make(std::make_unique<Stream>(std::move(ends.left)));
    Failure failure;
    failure.detail = std::string(900'000, 'x');
    const Bytes whole = encode_message(failure);
    channel->send(failure);
    const std::size_t queued = channel->queued_bytes();
    Bytes payload;
    std::size_t frames = 0;
    for (bool has_more = true; has_more; ++frames) {
        std::array<std::byte, frame_header_bytes> head{};
        co_await asio::async_read(ends.right, asio::buffer(head), asio::use_awaitable);
        const FrameHeader header = decode_header(head).value();
        has_more = header.has_more;
        EXPECT_LE(header.payload_bytes, limits::frame_with_more_bytes_min);
        Bytes piece(header.payload_bytes);
        co_await asio::async_read(ends.right, asio::buffer(piece), asio::use_awaitable);
        payload.insert(payload.end(), piece.begin(), piece.end());
    }
    EXPECT_EQ(frames, 4u);
    EXPECT_EQ(payload, whole);
    EXPECT_EQ(queued, whole.size() + frames * frame_header_bytes);
    channel->close();
}

CD_CONVERSATION(Channel, BetweenMessagesOneMayBeSilent) {
    SocketEnds ends = co_await connect_sockets();
    asio::ip::tcp::socket& quiet = ends.left;
    asio::ip::tcp::socket& socket = ends.right;
    const std::shared_ptr<Channel> channel =
        Channel::make(std::make_unique<Stream>(std::move(socket)), {.read = 500ms});
    const Bytes hello = frame_of(Hello{});
    for (int i = 0; i < 2; ++i) {
        co_await asio::async_write(quiet, asio::buffer(hello), asio::use_awaitable);
        const Result<Message> message = co_await channel->receive(patience);
        EXPECT_TRUE(message);
        const Result<Message> nothing = co_await channel->receive(600ms);
        EXPECT_EQ(nothing.error().code, ErrorCode::Timeout);
        EXPECT_TRUE(channel->is_open());
    }
    channel->close();
}

int option_of(int socket, int level, int option) {
    int value = 0;
    socklen_t size = sizeof(value);
    EXPECT_EQ(getsockopt(socket, level, option, &value, &size), 0);
    return value;
}

CD_CONVERSATION(Channel, AHostThatIsGoneIsNoticedInASilence) {
    SocketEnds ends = co_await connect_sockets();
    const int socket = ends.left.native_handle();
    const auto channel = Channel::make(std::make_unique<Stream>(std::move(ends.left)));
    EXPECT_EQ(option_of(socket, SOL_SOCKET, SO_KEEPALIVE), 1);
    EXPECT_EQ(option_of(socket, IPPROTO_TCP, TCP_KEEPIDLE), limits::keepalive_idle_seconds);
    EXPECT_EQ(option_of(socket, IPPROTO_TCP, TCP_KEEPINTVL), limits::keepalive_period_seconds);
    EXPECT_EQ(option_of(socket, IPPROTO_TCP, TCP_KEEPCNT), limits::keepalive_probes);
}

CD_CONVERSATION(Greeting, AHelloOfTheSameVersionIsTaken) {
    const Ends ends = co_await connect_ends();
    Hello hello;
    hello.name = "node";
    hello.role = Role::Worker;
    ends.left->send(hello);
    const Result<Hello> accepted = co_await accept_hello(ends.right);
    EXPECT_EQ(accepted.value().name, "node");
    EXPECT_EQ(accepted.value().version, protocol_version);
    ends.left->close();
}

asio::awaitable<void> welcome_with(std::shared_ptr<Channel> channel, Welcome welcome) {
    const Result<Hello> accepted = co_await accept_hello(channel);
    EXPECT_TRUE(accepted);
    channel->send(welcome);
    const Result<Message> end = co_await channel->receive(patience);
    EXPECT_FALSE(end);
}

CD_CONVERSATION(Greeting, GreetReturnsTheWelcome) {
    Ends ends = co_await connect_ends();
    const auto executor = co_await asio::this_coro::executor;
    Welcome answer;
    answer.id = 42;
    spawn(executor, "answer", welcome_with(std::move(ends.right), answer));
    Hello hello;
    const Result<Welcome> welcome = co_await greet(ends.left, hello);
    EXPECT_EQ(welcome.value().id, 42u);
    ends.left->close();
}

CD_CONVERSATION(Greeting, BothEndsKnowWhetherTheyRunOnOneHost) {
    const auto executor = co_await asio::this_coro::executor;
    EXPECT_NE(boot_id(), 0u);
    for (const std::uint64_t id_of_peer : {boot_id(), boot_id() + 1, std::uint64_t{0}}) {
        const bool is_within_host = id_of_peer == boot_id();
        Ends ends = co_await connect_ends();
        const std::shared_ptr<Channel> right = ends.right;
        Welcome answer;
        answer.boot_id = id_of_peer;
        spawn(executor, "answer", welcome_with(right, answer));
        Hello hello;
        hello.boot_id = id_of_peer;
        EXPECT_FALSE(ends.left->is_within_host()) << "before the greeting";
        EXPECT_TRUE(co_await greet(ends.left, hello));
        EXPECT_EQ(ends.left->is_within_host(), is_within_host);
        EXPECT_EQ(right->is_within_host(), is_within_host);
        ends.left->close();
    }
}

asio::awaitable<void> refuse(std::shared_ptr<Channel> channel) {
    const Result<Hello> refused = co_await accept_hello(channel);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_FALSE(channel->is_open());
}

CD_CONVERSATION(Greeting, AnotherVersionIsRefusedAndBothSidesSayWhatToUpgrade) {
    const auto executor = co_await asio::this_coro::executor;
    const std::string ours = std::to_string(protocol_version);
    for (const bool is_newer : {true, false}) {
        Ends ends = co_await connect_ends();
        spawn(executor, "refuse", refuse(std::move(ends.right)));
        Hello hello;
        hello.role = Role::Worker;
        hello.name = "w-7";
        hello.version = static_cast<std::uint16_t>(protocol_version + (is_newer ? 1 : -1));
        const Result<Welcome> welcome = co_await greet(ends.left, hello);
        EXPECT_EQ(welcome.error().code, ErrorCode::Refused);
        EXPECT_EQ(welcome.error().detail,
                  "worker w-7 speaks version " + std::to_string(hello.version) +
                      " of the protocol, this master version " + ours + ": upgrade " +
                      (is_newer ? "this master" : "worker w-7"));
    }
}

CD_CONVERSATION(Greeting, AWelcomeOfAnotherVersionIsNone) {
    Welcome wrong;
    wrong.version = protocol_version + 1;
    const auto executor = co_await asio::this_coro::executor;
    Ends ends = co_await connect_ends();
    spawn(executor, "welcome", welcome_with(std::move(ends.right), wrong));
    const Hello hello;
    const Result<Welcome> answer = co_await greet(ends.left, hello);
    EXPECT_EQ(answer.error().code, ErrorCode::BadFrame);
    EXPECT_FALSE(ends.left->is_open());
}

CD_CONVERSATION(Connect, AClosedPortIsAnErrorThatNamesIt) {
    const auto executor = co_await asio::this_coro::executor;
    asio::ip::tcp::acceptor acceptor = listen_anywhere(executor);
    const Endpoint endpoint{"127.0.0.1", acceptor.local_endpoint().port()};
    acceptor.close();
    const Result<std::shared_ptr<Channel>> channel = co_await connect(endpoint);
    EXPECT_EQ(channel.error().code, ErrorCode::Disconnected);
    EXPECT_THAT(channel.error().detail, HasSubstr(std::to_string(endpoint.port)));
}

CD_CONVERSATION(Connect, ReachSaysWhetherSomebodyListens) {
    const auto executor = co_await asio::this_coro::executor;
    asio::ip::tcp::acceptor acceptor = listen_anywhere(executor);
    const Endpoint endpoint{"127.0.0.1", acceptor.local_endpoint().port()};
    const Status open = co_await reach(endpoint, patience);
    EXPECT_TRUE(open);
    acceptor.close();
    const Status closed = co_await reach(endpoint, patience);
    EXPECT_FALSE(closed);
    if (!closed) {
        EXPECT_EQ(closed.error().code, ErrorCode::Disconnected);
        EXPECT_THAT(closed.error().detail, HasSubstr(std::to_string(endpoint.port)));
    }
}

} // namespace
} // namespace cd::tests
