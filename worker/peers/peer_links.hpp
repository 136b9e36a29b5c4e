// Fetches blocks from other workers.
#pragma once

#include "common/core/limits/worker.hpp"
#include "proto/channel/channel.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// Keeps connections for the next fetch, at most `limits::peer_channels_kept_max`. One thread.
class PeerLinks {
  public:
    /// `name` is this worker's name, for the logs of other workers.
    explicit PeerLinks(std::string name,
                       std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>())
        : name_(std::move(name)), tls_(std::move(tls)) {}

    /// Calls `on_block` once for each block of the answer, as they come. Roots and hashes are those
    /// that were asked for; the bytes are not checked against the hashes. Given means that all
    /// came.
    using OnBlock = std::function<void(SubtreeBlock)>;
    [[nodiscard]] asio::awaitable<PeerOutcome>
    fetch(const PeerSource& source, const FetchFromPeers& directions, const OnBlock& on_block);

  private:
    using Address = std::pair<std::string, std::uint16_t>;
    struct Answer {
        PeerOutcome outcome = PeerOutcome::Unreachable;
        std::size_t blocks = 0; ///< Received so far.
    };

    [[nodiscard]] asio::awaitable<Answer> ask(std::shared_ptr<Channel> channel,
                                              const PeerSource& source,
                                              const FetchFromPeers& directions,
                                              const OnBlock& on_block);
    /// Null when there is none.
    [[nodiscard]] std::shared_ptr<Channel> take_kept(const Address& address);
    [[nodiscard]] asio::awaitable<std::shared_ptr<Channel>> open(const Address& address);
    void keep(const Address& address, std::shared_ptr<Channel> channel);

    std::string name_;
    std::shared_ptr<const TlsSlot> tls_;
    std::multimap<Address, std::shared_ptr<Channel>> idle_;
};

} // namespace cd
