#include "worker/peers/peer_links.hpp"

#include "common/core/limits/wire.hpp"
#include "common/core/limits/worker.hpp"
#include "common/core/timing/wire.hpp"
#include "common/core/timing/worker.hpp"
#include "common/core/version.hpp"

#include <algorithm>
#include <set>

namespace cd {

asio::awaitable<PeerOutcome> PeerLinks::fetch(const PeerSource& source,
                                              const FetchFromPeers& directions,
                                              const OnBlock& on_block) {
    const Address address{source.host, source.port};
    const std::shared_ptr<Channel> kept = take_kept(address);
    if (kept != nullptr) {
        const Answer answer = co_await ask(kept, source, directions, on_block);
        // The peer may have closed the idle connection, so the fetch retries on a new connection.
        if (answer.outcome != PeerOutcome::Unreachable || answer.blocks != 0) {
            co_return answer.outcome;
        }
    }
    const std::shared_ptr<Channel> channel = co_await open(address);
    if (channel == nullptr) {
        co_return PeerOutcome::Unreachable;
    }
    const Answer answer = co_await ask(channel, source, directions, on_block);
    // A ticket is valid once. The peer refuses the second request if the idle connection broke only
    // after the first had arrived; then the connection failed, not the ticket.
    const bool was_asked_before = kept != nullptr && answer.outcome == PeerOutcome::Refused;
    co_return was_asked_before ? PeerOutcome::Unreachable : answer.outcome;
}

asio::awaitable<PeerLinks::Answer> PeerLinks::ask(std::shared_ptr<Channel> channel,
                                                  const PeerSource& source,
                                                  const FetchFromPeers& directions,
                                                  const OnBlock& on_block) {
    channel->send(PeerFetch{directions.tree, directions.roots, source.ticket, source.proof});
    std::set<RootIndex> left(directions.roots.begin(), directions.roots.end());
    Answer answer;
    for (;;) {
        Result<Message> message = co_await channel->receive(timing::peer_stall_max);
        if (!message) {
            channel->close();
            co_return answer;
        }
        if (const auto* end = std::get_if<PeerFetched>(&message.value())) {
            const bool is_lie = end->outcome == PeerOutcome::Given && !left.empty();
            answer.outcome = is_lie ? PeerOutcome::Damaged : end->outcome;
            keep({source.host, source.port}, std::move(channel));
            co_return answer;
        }
        auto* const some = std::get_if<Subtrees>(&message.value());
        bool is_good = some != nullptr && some->tree == directions.tree;
        for (std::size_t i = 0; is_good && i < some->blocks.size(); ++i) {
            SubtreeBlock& block = some->blocks[i];
            const auto place = std::ranges::lower_bound(directions.roots, block.root);
            const auto which = static_cast<std::size_t>(place - directions.roots.begin());
            is_good = left.erase(block.root) != 0 && directions.hashes[which] == block.hash;
            if (is_good) {
                ++answer.blocks;
                on_block(std::move(block));
            }
        }
        if (!is_good) {
            channel->close();
            answer.outcome = PeerOutcome::Damaged;
            co_return answer;
        }
    }
}

std::shared_ptr<Channel> PeerLinks::take_kept(const Address& address) {
    while (const auto kept = idle_.extract(address)) {
        if (kept.mapped()->is_open()) {
            return kept.mapped();
        }
    }
    return nullptr;
}

asio::awaitable<std::shared_ptr<Channel>> PeerLinks::open(const Address& address) {
    Target target{{address.first, address.second}, tls_->now, CertifiedRole::Worker};
    const Result<std::shared_ptr<Channel>> made =
        co_await network_.connect(std::move(target), timing::peer_connect_timeout);
    if (!made) {
        co_return nullptr;
    }
    Hello hello;
    hello.role = Role::Peer;
    hello.name = name_;
    hello.build = version;
    const Result<Welcome> welcome = co_await greet(made.value(), hello, timing::peer_stall_max);
    co_return welcome ? made.value() : nullptr;
}

void PeerLinks::keep(const Address& address, std::shared_ptr<Channel> channel) {
    if (idle_.size() >= limits::peer_channels_kept_max) {
        idle_.erase(idle_.begin());
    }
    idle_.emplace(address, std::move(channel));
}

} // namespace cd
