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

/// Keeps at most `limits::peer_channels_kept_max` connections to workers open. Not thread-safe.
class PeerLinks {
  public:
    /// `name` is this worker's name, for the logs of other workers.
    explicit PeerLinks(std::string name,
                       std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>())
        : name_(std::move(name)), tls_(std::move(tls)) {}

    using OnBlock = std::function<void(SubtreeBlock)>;
    /// Fetches blocks from a source. Calls `on_block` once for each received block that was
    /// requested and claims the right hash; the caller has to check the bytes. The outcome Given
    /// means that all blocks came; Unreachable, that no connection or no whole answer came in time.
    [[nodiscard]] asio::awaitable<PeerOutcome>
    fetch(const PeerSource& source, const FetchFromPeers& directions, const OnBlock& on_block);

  private:
    using Address = std::pair<std::string, std::uint16_t>;
    struct Answer {
        PeerOutcome outcome = PeerOutcome::Unreachable;
        std::size_t blocks = 0; ///< Number of blocks received so far.
    };

    [[nodiscard]] asio::awaitable<Answer> ask(std::shared_ptr<Channel> channel,
                                              const PeerSource& source,
                                              const FetchFromPeers& directions,
                                              const OnBlock& on_block);
    /// Takes an idle open connection to the address from `idle_`; null if there is none.
    [[nodiscard]] std::shared_ptr<Channel> take_kept(const Address& address);
    [[nodiscard]] asio::awaitable<std::shared_ptr<Channel>> open(const Address& address);
    void keep(const Address& address, std::shared_ptr<Channel> channel);

    std::string name_;
    std::shared_ptr<const TlsSlot> tls_;
    std::multimap<Address, std::shared_ptr<Channel>> idle_; ///< Connections kept for reuse.
};

} // namespace cd
