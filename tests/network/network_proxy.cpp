// A long and unreliable network for the connections that leave a network namespace. See
// bad_network.
//
//   network_proxy --port 7000 --delay-ms 10 --break-percent 1 [--seed 1]
//
// iptables redirects connections to the proxy's port (rule REDIRECT); the proxy connects to their
// original destination. It sets SO_MARK 1 on its own connections, so that the rule can exclude
// them. The proxy delays all bytes, in both directions. Each second, each connection breaks with
// the given probability. At SIGTERM the proxy ends, and prints the numbers of connections and of
// breaks.
#include "proto/channel/signals.hpp"
#include "tests/cluster/faulty_proxy.hpp"

#include <CLI/CLI.hpp>
#include <linux/netfilter_ipv4.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdio>
#include <exception>
#include <random>

namespace cd::tests {

namespace {

using asio::ip::tcp;

/// Returns the original destination of a redirected connection, and marks the onward socket.
FaultyProxy::Endpoint original_target(tcp::socket& accepted, tcp::socket& onward) {
    sockaddr_in target{};
    socklen_t size = sizeof(target);
    const int mark = 1;
    if (getsockopt(accepted.native_handle(), SOL_IP, SO_ORIGINAL_DST, &target, &size) != 0 ||
        setsockopt(onward.native_handle(), SOL_SOCKET, SO_MARK, &mark, sizeof(mark)) != 0) {
        std::perror("a connection cannot be forwarded");
        std::_Exit(2);
    }
    return {asio::ip::address_v4(ntohl(target.sin_addr.s_addr)), ntohs(target.sin_port)};
}

/// Breaks connections until a signal ends the program.
void break_connections(FaultyProxy& proxy, double chance, std::uint64_t seed) {
    asio::io_context context{1};
    asio::steady_timer second(context);
    std::mt19937_64 random(seed);
    std::bernoulli_distribution breaks(chance);
    std::function<void()> again = [&] {
        second.expires_after(std::chrono::seconds(1));
        second.async_wait([&](const boost::system::error_code& error) {
            if (!error) {
                // The proxy's thread alone draws.
                proxy.cut_if([&] { return breaks(random); });
                again();
            }
        });
    };
    again();
    StopSignals signals(context.get_executor(), [&](unsigned) { context.stop(); });
    context.run();
}

} // namespace

} // namespace cd::tests

int main(int argc, char** argv) {
    using namespace cd::tests;
    std::uint16_t port = 0;
    int delay_ms = 0;
    double break_percent = 0;
    std::uint64_t seed = 1;
    CLI::App app("A long and unreliable network");
    app.add_option("--port", port, "To listen on")->required();
    app.add_option("--delay-ms", delay_ms, "Of all bytes, each way")->check(CLI::NonNegativeNumber);
    app.add_option("--break-percent", break_percent, "A connection's chance to break, each second")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option("--seed", seed, "Of the breaks");
    CLI11_PARSE(app, argc, argv);
    try {
        FaultyProxy proxy({cd::asio::ip::address_v4::any(), port}, original_target);
        proxy.set_delay(std::chrono::milliseconds(delay_ms));
        proxy.set(delay_ms > 0 ? Weather::Delayed : Weather::Fair);
        break_connections(proxy, break_percent / 100, seed);
        std::printf("%llu %llu\n",
                    static_cast<unsigned long long>(proxy.connections()),
                    static_cast<unsigned long long>(proxy.cuts()));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
