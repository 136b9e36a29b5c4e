// Proves that workers are directed only to peers whose port the master has reached.
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

namespace cd::tests {
namespace {

struct ServerPeers : testing::Test {
    /// Counts directions of the second of two workers to the first, which holds blocks and claims
    /// to serve peers at that port.
    std::uint64_t times_sent_to(std::uint16_t at) {
        Master master;
        submit_to(master, reference().submission());
        const FakeWorker first(master,
                               {.says_what_it_holds = true, .batches_max = 6, .peer_port = at});
        master.run_until([&] { return first.kept != 0; });
        const FakeWorker second(master, {.peer_port = at});
        master.run_until([&] { return second.kept >= 2; });
        return second.sent_to_peers;
    }

    asio::io_context context;
    asio::ip::tcp::acceptor acceptor{context, {asio::ip::address_v4::loopback(), 0}};
    std::uint16_t port = acceptor.local_endpoint().port();
};

TEST_F(ServerPeers, AWorkerThatIsReachedGivesToOthers) {
    EXPECT_GT(times_sent_to(port), 0u);
}

TEST_F(ServerPeers, AWorkerWhosePortIsNotReachedIsNoSource) {
    acceptor.close();
    EXPECT_EQ(times_sent_to(port), 0u);
}

} // namespace
} // namespace cd::tests
