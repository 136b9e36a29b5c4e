// One end of a simulated connection; decides what happens to messages on their way to the peer.
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

/// A message in flight.
struct Letter {
    Message message;
    std::uint64_t number = 0;       ///< Ascending per sender.
    std::size_t bytes = 0;          ///< Bytes the sender counts as queued until arrival.
    std::optional<Trouble> trouble; ///< Fault of this message; counted on arrival.
};

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
    Party other_party = Party::Anyone; // If an earlier message is lost, the first one may be no
                                       // greeting.
    std::string other_host = "";
    std::string this_host = "";
    asio::steady_timer arrived;
    asio::steady_timer drained;
    std::deque<Message> inbox;
    bool is_awaited = false;         ///< A receiver is waiting.
    std::optional<Message> incoming; ///< Message that had reached a receiver when this end closed.
    bool open = true;
    bool is_ended = false; ///< Nothing more arrives; the inbox can still be read.
    std::weak_ptr<LinkEnd> other;
    Time last_arrival{};            ///< Latest arrival of a message sent from here.
    std::uint64_t sent_last = 0;    ///< Number of the last letter sent from here.
    std::uint64_t arrived_last = 0; ///< Greatest number of a letter that arrived here.
    std::size_t queued = 0;
    std::size_t blocks_queued = 0; ///< The part of `queued` that is blocks.
    bool is_broken = false;        ///< A message sent from here vanished; all later ones vanish,
                                   ///< too.
    Traffic traffic;

    [[nodiscard]] Time
    arrival_at(const Host& from, const Host& there, Duration delay, World& world) const;
    void send(const Message& message, bool is_open);
    void deliver(const Letter& letter, Time when);
    void arrive(const Letter& letter, World& world);
    static void count(const Letter& letter, std::uint64_t arrived_last, World& world);
    /// Returns the next message that has arrived, if any.
    [[nodiscard]] std::optional<Message> take();
    void shut(bool tells);
    /// Breaks the connection; both ends notice after some time.
    void cut(Trouble trouble);
    /// Breaks the connection for this end only; the message arrives when this host greets again.
    void cut_late(const Letter& letter);
    void notice_cut(Duration latest, std::optional<Trouble> trouble);
    /// Breaks the connection unnoticed: the sender learns it only from a long silence.
    void break_off(const Host& from, const Host& there, World& world);
    void check_flight(World& world) const;
    void check_queue(World& world) const;
    void wake_up(World& world);
};

} // namespace cd::tests
