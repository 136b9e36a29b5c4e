// Measures the cost of TLS for blocks of geometry, the bulk of all traffic: over loopback, each end
// on its own thread, plain and secured rounds in alternation. Prints MB/s and the processor time of
// both ends, a line per round.
//
//   proto_tls_bench [MEGABYTES] [ROUNDS]
#include "proto/channel/channel.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/greeting.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <future>
#include <string>
#include <thread>

namespace cd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t block_bytes = 1u << 20;
constexpr std::chrono::seconds patience{600};

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Subtrees some_block() {
    Subtrees message;
    SubtreeBlock block;
    block.compressed.resize(block_bytes);
    for (std::size_t i = 0; i < block_bytes; ++i) {
        block.compressed[i] = static_cast<std::byte>(i * 2654435761u >> 13); // Varies the bytes.
    }
    message.blocks.push_back(std::move(block));
    return message;
}

asio::awaitable<void> give(std::shared_ptr<Channel> channel, std::size_t blocks) {
    Welcome welcome;
    channel->send(welcome);
    const Subtrees block = some_block();
    for (std::size_t i = 0; i < blocks; ++i) {
        channel->send(block);
        co_await channel->wait_until_queued_below(4 * block_bytes);
    }
    channel->close(true);
}

asio::awaitable<void>
serve(asio::ip::tcp::acceptor& acceptor, std::shared_ptr<const Tls> tls, std::size_t blocks) {
    asio::ip::tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
    const auto channel = co_await accept_channel(std::move(socket), std::move(tls));
    Result<Message> hello = co_await channel.value()->receive(patience);
    co_await give(channel.value(), hello ? blocks : 0);
}

asio::awaitable<void> take(Target target, std::size_t& blocks) {
    const auto channel = co_await connect(std::move(target));
    Hello hello;
    const Result<Welcome> welcome = co_await greet(channel.value(), hello);
    for (bool open = welcome.has_value(); open;) {
        const Result<Message> message = co_await channel.value()->receive(patience);
        open = message.has_value();
        blocks += open ? 1u : 0u;
    }
}

struct Times {
    double seconds = 0;
    double processor = 0;
};

Times transfer(const std::shared_ptr<const Tls>& tls, std::size_t blocks) {
    asio::io_context giving(1);
    const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
    asio::ip::tcp::acceptor acceptor(giving, any_port);
    Target target({"127.0.0.1", acceptor.local_endpoint().port()}, tls, CertifiedRole::Worker);
    const double processor = processor_seconds();
    const auto start = Clock::now();
    spawn(giving.get_executor(), "give", serve(acceptor, tls, blocks));
    std::thread giver([&] { giving.run(); });
    asio::io_context taking(1);
    std::size_t taken = 0;
    spawn(taking.get_executor(), "take", take(std::move(target), taken));
    taking.run();
    giver.join();
    if (taken != blocks) {
        std::fprintf(stderr, "%zu of %zu blocks came\n", taken, blocks);
        std::exit(1);
    }
    return {std::chrono::duration<double>(Clock::now() - start).count(),
            processor_seconds() - processor};
}

int run(std::size_t megabytes, int rounds) {
    const WallTime now = std::chrono::system_clock::now();
    const auto authority = CertificateAuthority::make(now);
    const auto tls =
        Tls::make(authority.issue({CertifiedRole::Worker, "bench", now, now + patience}));
    std::printf("        plain MB/s  s CPU/GB    TLS MB/s  s CPU/GB    TLS / plain\n");
    for (int round = 0; round < rounds; ++round) {
        const Times plain = transfer(nullptr, megabytes);
        const Times secured = transfer(tls.value(), megabytes);
        const double mb = static_cast<double>(megabytes * block_bytes) * 1e-6;
        std::printf("%18.0f %9.2f %11.0f %9.2f %14.2f\n",
                    mb / plain.seconds,
                    plain.processor / mb * 1e3,
                    mb / secured.seconds,
                    secured.processor / mb * 1e3,
                    plain.seconds / secured.seconds);
    }
    return 0;
}

} // namespace
} // namespace cd

int main(int count, char** arguments) {
    const std::size_t megabytes = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 2000;
    const int rounds = count > 2 ? std::atoi(arguments[2]) : 5;
    return cd::run(megabytes, rounds);
}
