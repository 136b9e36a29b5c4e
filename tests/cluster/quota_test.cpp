// Proves that a real master limits one client to its share of connections and drops peers that
// connect and then stay silent, while it serves others.
#include "common/core/limits/master.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/endpoint.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <array>

namespace cd::tests {
namespace {

using testing::HasSubstr;

TEST_F(Cluster, OneClientHasItsShareOfConnections) {
    std::vector<std::unique_ptr<Connection>> connections; // In addition to the fixture's own.
    while (connections.size() + 1 < limits::client_connections_max) {
        connections.push_back(connect());
    }
    const auto open = [&] {
        return Connection::open(master_->address(), false, [] { return false; });
    };
    const auto one_more = open();
    ASSERT_FALSE(one_more);
    EXPECT_EQ(one_more.error().code, ErrorCode::Refused);
    EXPECT_THAT(one_more.error().detail, HasSubstr("quota"));
    EXPECT_THAT(read_text(folder_ / "master.log"), HasSubstr("greeting refused"));
    EXPECT_TRUE(connection_->status());
    const Ran ran =
        tests::run({program("cdctl").string(), "status", "--master", master_->address()});
    EXPECT_EQ(ran.exit_code, 5);
    connections.clear();
    // The master may not yet have noticed that they are gone.
    EXPECT_TRUE(comes_true([&] { return bool(open()); }));
}

TEST_F(Cluster, PeersThatStaySilentAreDropped) {
    const Endpoint master = parse_endpoint(master_->address()).value();
    asio::io_context context(1);
    const asio::ip::tcp::endpoint there(asio::ip::make_address(master.host), master.port);
    asio::ip::tcp::socket silent(context);
    asio::ip::tcp::socket half(context);
    silent.connect(there);
    half.connect(there);
    asio::write(half, asio::buffer(std::string("CDF1")));
    EXPECT_TRUE(connection_->status()) << "others are served";
    for (asio::ip::tcp::socket* socket : {&silent, &half}) {
        std::array<char, 100> bytes{};
        boost::system::error_code error;
        while (!error) {
            (void)socket->read_some(asio::buffer(bytes), error);
        }
    }
    EXPECT_TRUE(connection_->status());
    EXPECT_THAT(read_text(folder_ / "master.log"), HasSubstr("in time"));
}

} // namespace
} // namespace cd::tests
