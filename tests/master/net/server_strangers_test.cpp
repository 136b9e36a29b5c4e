// Proves that peers that connect and stay silent take no connection slots of other addresses, not
// even by announcing a join.
#include "common/core/limits/master.hpp"
#include "master/identity/identity.hpp"
#include "proto/channel/greeting.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/master_stage.hpp"
#include "tests/support/logged.hpp"

#include <gmock/gmock.h>

#include <array>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// One more than a host gets while no other is connected.
constexpr std::size_t too_many = limits::greetings_max / 2 + 1;

asio::ip::tcp::socket connect_from(Master& master, const char* address, std::uint16_t port) {
    asio::ip::tcp::socket socket(master.context, asio::ip::tcp::v4());
    socket.bind({asio::ip::make_address(address), 0});
    socket.connect({asio::ip::address_v4::loopback(), port});
    return socket;
}

/// A conversation up to the answer to its Hello.
struct Greeting {
    std::shared_ptr<Channel> channel;
    std::optional<Result<Welcome>> answer;
};

asio::awaitable<void> greet_from(std::unique_ptr<Stream> stream,
                                 std::shared_ptr<const Tls> tls,
                                 Role role,
                                 Greeting& greeting) {
    if (tls != nullptr) {
        const Status secured = co_await stream->secure(tls, TlsEnd::Connecting, patience);
        if (!secured) {
            greeting.answer = secured.error();
            co_return;
        }
    }
    greeting.channel = Channel::make(std::move(stream));
    Hello hello;
    hello.role = role;
    greeting.answer = co_await greet(greeting.channel, hello, patience);
}

void start_greeting(Master& master,
                    asio::ip::tcp::socket socket,
                    std::shared_ptr<const Tls> tls,
                    Role role,
                    Greeting& greeting) {
    spawn(master.context.get_executor(),
          "greeting",
          greet_from(std::make_unique<Stream>(std::move(socket)), std::move(tls), role, greeting));
}

TEST(Strangers, SilentConnectionsOfOneHostDoNotLockOtherHostsOut) {
    Master master;
    const Logged logged;
    std::vector<asio::ip::tcp::socket> silent;
    for (std::size_t i = 0; i < too_many; ++i) {
        silent.push_back(connect_from(master, "127.0.0.1", master.server->port()));
        master.context.poll();
    }
    // The master closes the last connection at once.
    std::array<char, 1> nothing{};
    bool is_closed = false;
    silent.back().async_read_some(asio::buffer(nothing),
                                  [&](const auto& error, std::size_t) { is_closed = !!error; });
    master.run_until([&] { return is_closed; });
    EXPECT_THAT(logged.text(), HasSubstr("connection refused: peer=127.0.0.1:"));
    Greeting turned_away;
    start_greeting(master,
                   connect_from(master, "127.0.0.1", master.server->port()),
                   nullptr,
                   Role::Client,
                   turned_away);
    master.run_until([&] { return turned_away.answer.has_value(); });
    ASSERT_FALSE(turned_away.answer->has_value());
    EXPECT_THAT(turned_away.answer->error().detail, HasSubstr("slots may be taken"));
    Greeting other;
    start_greeting(master,
                   connect_from(master, "127.0.0.2", master.server->port()),
                   nullptr,
                   Role::Client,
                   other);
    master.run_until([&] { return other.answer.has_value(); });
    EXPECT_TRUE(other.answer->has_value()) << other.answer->error().detail;
    other.channel->close();
}

TEST(Strangers, UnderTlsAClientThatFindsNoPlaceIsToldSo) {
    Master master({}, {}, {.is_secured = true});
    std::vector<asio::ip::tcp::socket> silent;
    for (std::size_t i = 0; i < too_many; ++i) {
        silent.push_back(connect_from(master, "127.0.0.1", master.server->port()));
        master.context.poll();
    }
    Greeting turned_away;
    start_greeting(master,
                   connect_from(master, "127.0.0.1", master.server->port()),
                   master.target(CertifiedRole::Submitter, "ilan").tls,
                   Role::Client,
                   turned_away);
    master.run_until([&] { return turned_away.answer.has_value(); });
    ASSERT_FALSE(turned_away.answer->has_value());
    EXPECT_THAT(turned_away.answer->error().detail, HasSubstr("slots may be taken"));
}

TEST(Strangers, GreetedConnectionsFreeTheirSlot) {
    Master master;
    for (std::size_t i = 0; i < too_many; ++i) {
        Greeting greeting;
        start_greeting(master,
                       connect_from(master, "127.0.0.1", master.server->port()),
                       nullptr,
                       i % 2 == 0 ? Role::Worker : Role::Peer,
                       greeting);
        master.run_until([&] { return greeting.answer.has_value(); });
        // The others are refused, and keep their slots until they leave.
        EXPECT_EQ(greeting.answer->has_value(), i % 2 == 0);
        greeting.channel->close();
    }
}

TEST(Strangers, JoinersKeepTheirSlotUntilAdmitted) {
    Master master;
    const TemporaryFolder folder;
    const MasterIdentity::Options options{std::chrono::hours(1)};
    ASSERT_TRUE(MasterIdentity::init(folder.path(), options));
    const auto identity = std::move(MasterIdentity::open(folder.path(), options).value());
    ClientLimits clients;
    clients.greetings = 16; // Few, so that no joiner runs into the time limit of a greeting.
    const auto server = std::move(Server::listen(master.context.get_executor(),
                                                 {"127.0.0.1", 0},
                                                 master.coordinator,
                                                 identity.get(),
                                                 clients)
                                      .value());
    server->start();
    const auto nobody = Tls::make_joining(identity->fingerprint());
    std::vector<Greeting> joiners(clients.greetings / 2 + 1);
    for (Greeting& joiner : joiners) {
        start_greeting(master,
                       connect_from(master, "127.0.0.1", server->port()),
                       nobody,
                       Role::Joiner,
                       joiner);
        master.run_until([&] { return joiner.answer.has_value(); });
        EXPECT_EQ(joiner.answer->has_value(), &joiner != &joiners.back());
    }
    for (Greeting& joiner : joiners) {
        if (joiner.channel != nullptr) {
            joiner.channel->close();
        }
    }
    server->close();
    master.end(); // Must end before the second server.
}

} // namespace
} // namespace cd::tests
