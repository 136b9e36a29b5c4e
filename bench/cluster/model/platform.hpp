// The simulated cluster's hosts, network and messages: all uses of SimGrid.
#pragma once

#include "bench/cluster/model/simulation.hpp"

#include <simgrid/s4u.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

/// Operations of a fast core in a second; converts seconds to SimGrid's operations.
inline constexpr double fast_speed = 1e9;

struct WorkerPlace {
    simgrid::s4u::Host* host = nullptr;
    std::uint32_t threads = 1;
};

struct Platform {
    simgrid::s4u::Host* master = nullptr;
    std::vector<WorkerPlace> workers; ///< Fast ones first.
};

/// Builds the platform in SimGrid's engine, which must exist. The master's computer has so many
/// cores.
[[nodiscard]] Platform
build_platform(const ClusterSpec& spec, double slow_ratio, std::uint32_t master_cores);

/// Computes on the actor's host.
inline void spend(double fast_seconds) {
    if (fast_seconds > 0) {
        simgrid::s4u::this_actor::execute(fast_seconds * fast_speed);
    }
}

/// A mailbox whose messages travel while its owner computes.
template <class Message>
class Inbox {
  public:
    explicit Inbox(const std::string& name) : mailbox_(simgrid::s4u::Mailbox::by_name(name)) {}

    /// Call from the owning actor.
    void open() { mailbox_->set_receiver(simgrid::s4u::Actor::self()); }
    void close() { mailbox_->set_receiver(nullptr); }
    /// Sends without waiting.
    void put(Message message, std::uint64_t bytes) {
        auto owned = std::make_unique<Message>(std::move(message));
        mailbox_->put_init(owned.release(), bytes)->detach([](void* lost) {
            delete static_cast<Message*>(lost); // NOLINT: SimGrid's mailboxes hold bare pointers.
        });
    }
    /// Sends and waits for the arrival.
    void put_and_wait(Message message, std::uint64_t bytes) {
        auto owned = std::make_unique<Message>(std::move(message));
        mailbox_->put(owned.release(), bytes);
    }
    [[nodiscard]] bool has_message() const { return mailbox_->ready(); }
    [[nodiscard]] std::unique_ptr<Message> get() { return mailbox_->get_unique<Message>(); }

  private:
    simgrid::s4u::Mailbox* mailbox_;
};

} // namespace cd::bench
