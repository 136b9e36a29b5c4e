// One end of a simulated connection, and what happens to messages on their way to the other.
#pragma once

#include "proto/channel/channel.hpp"
#include "tests/faults/world.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace cd::tests {

inline constexpr Duration latency_min = std::chrono::microseconds(50);
inline constexpr Duration latency_max = std::chrono::milliseconds(3);

/// A message on its way.
struct Letter {
    Message message;
    std::uint64_t number = 0;       ///< Of its sender, ascending.
    std::size_t bytes = 0;          ///< That its sender counts as queued until it comes.
    std::optional<Trouble> trouble; ///< What happens to it, which counts when it comes.
};

/// One end of a connection.
struct LinkEnd : std::enable_shared_from_this<LinkEnd> {
    LinkEnd(const asio::any_io_executor& executor, const Host& on)
        : host(on.id),
          is_silent(on.is_silent),
          arrived(executor, asio::steady_timer::time_point::max()),
          drained(executor, asio::steady_timer::time_point::max()) {}

    std::uint64_t host;
    std::uint64_t other_id = 0;
    std::uint64_t connection = 0;
    std::shared_ptr<const bool> is_silent;
    Party other_party = Party::Anyone; // Of what is lost the rest may come, and be no greeting.
    std::string other_host = "";
    std::string this_host = "";
    asio::steady_timer arrived;
    asio::steady_timer drained;
    std::deque<Message> inbox;
    bool is_awaited = false;         ///< Somebody receives.
    std::optional<Message> incoming; ///< Had come to whoever did when this end was closed.
    bool open = true;
    bool is_ended = false; ///< Nothing comes any more; what came can be read.
    std::weak_ptr<LinkEnd> other;
    Time last_arrival{};            ///< Of what was sent from here.
    std::uint64_t sent_last = 0;    ///< Numbers of letters: of those that were sent from here,
    std::uint64_t arrived_last = 0; ///< and the greatest of those that came here.
    std::size_t queued = 0;
    std::size_t blocks_queued = 0; ///< Of these bytes.
    bool is_broken = false;        ///< What was sent from here vanished, and so does all after it.
    Traffic traffic;

    [[nodiscard]] Time
    arrival_at(const Host& from, const Host& there, Duration delay, World& world) const;
    void send(const Message& message, bool is_open);
    void deliver(const Letter& letter, Time when);
    void arrive(const Letter& letter, World& world);
    static void count(const Letter& letter, std::uint64_t arrived_last, World& world);
    /// What has come and can be taken.
    [[nodiscard]] std::optional<Message> take();
    void shut(bool tells);
    /// Both ends notice it some time.
    void cut(Trouble trouble);
    /// Only this end notices it; the message is on its way until this host greets again.
    void cut_late(const Letter& letter);
    void notice_cut(Duration latest, std::optional<Trouble> trouble);
    /// It is not known here, until the sender has waited in vain for long enough.
    void break_off(const Host& from, const Host& there, World& world);
    void check_flight(World& world) const;
    void check_queue(World& world) const;
    void wake_up(World& world);
};

} // namespace cd::tests
