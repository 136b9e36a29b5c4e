#include "tests/faults/link_end.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"
#include "master/base/mutation.hpp"
#include "proto/codec/codec.hpp"

#include <algorithm>
#include <utility>

namespace cd::tests {

using namespace std::chrono_literals;

namespace {

/// A block counts as this many bytes beyond its own, so that queues fill up.
constexpr std::size_t block_bytes = 6u << 20;

std::size_t bytes_of(const Message& message) {
    std::size_t bytes = 100;
    if (const auto* subtrees = std::get_if<Subtrees>(&message)) {
        bytes += subtrees->blocks.size() * block_bytes;
    } else if (const auto* unit = std::get_if<WorkUnit>(&message)) {
        bytes += unit->scenarios.size() + unit->pairs.size() * sizeof(unit->pairs.front());
    } else if (const auto* results = std::get_if<Results>(&message)) {
        bytes += results->records.size();
    }
    return bytes;
}

std::string name_of(const Message& message) {
    return std::string(message_name(message_type(message)));
}

/// True for messages whose repetition or reordering does the master's jobs no harm. (Messages about
/// blocks must keep their order, as a connection does.)
bool may_be_odd(const Message& message) {
    return std::holds_alternative<Results>(message) || std::holds_alternative<EndOfTask>(message) ||
           std::holds_alternative<Heartbeat>(message);
}

} // namespace

Time LinkEnd::arrival_at(const Host& from, const Host& there, Duration delay, World& world) const {
    Time when = world.now() + world.between(latency_min, latency_max) + delay;
    for (const Host* end : {&from, &there}) {
        if (end->cut_off_until > when) {
            when = end->cut_off_until;
            world.felt(end->id == tests::master_host ? Trouble::MasterCutOff
                                                     : Trouble::WorkerCutOff,
                       *end,
                       when);
        }
    }
    return std::max(when, last_arrival);
}

void LinkEnd::wake_up(World& world) {
    arrived.cancel();
    drained.cancel();
    if (Host* here = world.find_host(host)) {
        world.wake(*here);
    }
}

void LinkEnd::count(const Letter& letter, std::uint64_t arrived_last, World& world) {
    const bool is_first = letter.number > arrived_last;
    if (letter.trouble && (letter.trouble != Trouble::Overtaken || !is_first)) {
        world.troubles.add(*letter.trouble);
    }
}

void LinkEnd::arrive(const Letter& letter, World& world) {
    const Message& message = letter.message;
    if (!open || is_ended) {
        return;
    }
    count(letter, arrived_last, world);
    arrived_last = std::max(arrived_last, letter.number);
    inbox.push_back(message);
    arrived.cancel();
    if (Host* here = world.find_host(host)) {
        world.felt_stop(*here);
        world.wake(*here);
    }
    if (host != tests::master_host || !std::holds_alternative<Hello>(message)) {
        return;
    }
    if (Host* from = world.find_host(other_id)) {
        for (const auto& comes : std::exchange(from->at_greeting, {})) {
            comes();
        }
    }
}

std::optional<Message> LinkEnd::take() {
    std::optional<Message> message = std::exchange(incoming, std::nullopt);
    if (!message && open && !inbox.empty()) {
        message = std::move(inbox.front());
        inbox.pop_front();
    }
    if (!message) {
        return message;
    }
    is_awaited = false;
    CD_CHECK(payload_bytes_max_from(other_party, message_type(*message)) != 0);
    if (host == tests::master_host) {
        World::current()->log("heard: " + name_of(*message) + ", of " + other_host);
        World::current()->on_heard({other_id, host, connection}, *message);
    }
    return message;
}

void LinkEnd::deliver(const Letter& letter, Time when) {
    World& world = *World::current();
    world.at(when, [&world, self = weak_from_this(), to = other, letter] {
        const std::size_t bytes = letter.bytes;
        if (const auto sender = self.lock(); sender != nullptr && bytes != 0) {
            sender->queued -= bytes;
            sender->blocks_queued -= std::holds_alternative<Subtrees>(letter.message) ? bytes : 0;
            sender->drained.cancel();
            if (Host* here = world.find_host(sender->host)) {
                world.wake(*here);
            }
        }
        if (const auto there = to.lock()) {
            there->arrive(letter, world);
        }
    });
}

void LinkEnd::send(const Message& message, bool is_open) {
    World& world = *World::current();
    const bool is_sent = world.on_message({host, other_id, connection}, message);
    const auto to = other.lock();
    if (!is_open || !is_sent) {
        return;
    }
    Host* from = world.find_host(host);
    Host* there = to == nullptr ? nullptr : world.find_host(to->host);
    if (from == nullptr || there == nullptr) {
        return;
    }
    const std::string way = name_of(message) + ", " + from->name + " to " + there->name;
    const bool is_odd_host = from->is_odd && there->id == tests::master_host;
    const bool is_odd = is_odd_host && may_be_odd(message);
    const bool is_unwelcome = there->is_odd && std::holds_alternative<Welcome>(message) &&
                              world.happens(world.network.unwelcome);
    const std::size_t bytes = bytes_of(message);
    const std::size_t bytes_of_blocks = std::holds_alternative<Subtrees>(message) ? bytes : 0;
    if (bytes_of_blocks != 0) {
        check_flight(world);
    }
    queued += bytes;
    blocks_queued += bytes_of_blocks;
    check_queue(world);
    break_off(*from, *there, world);
    if (is_broken) {
        return world.log("vanished: " + way);
    }
    const Duration delay =
        world.happens(world.network.delayed) ? world.between(0s, 2s) : Duration{};
    const Time when = arrival_at(*from, *there, delay, world);
    Letter letter{message, ++sent_last, bytes, std::nullopt};
    if (is_odd && world.happens(world.network.overtaken)) {
        world.log("overtaken: " + way);
        letter.trouble = Trouble::Overtaken;
        return deliver(letter, when + world.between(0s, 200ms));
    }
    last_arrival = when;
    if (world.happens(world.network.lost) || is_unwelcome) {
        world.log("lost: " + way);
        queued -= bytes;
        blocks_queued -= bytes_of_blocks;
        return is_odd_host && world.happens(world.network.late)
                   ? cut_late(letter)
                   : cut(is_unwelcome ? Trouble::Unwelcomed : Trouble::Lost);
    }
    if (delay > latency_max) {
        letter.trouble = Trouble::Delayed;
    }
    deliver(letter, when);
    if (is_odd && world.happens(world.network.doubled)) {
        world.log("doubled: " + way);
        letter.bytes = 0;
        letter.trouble = Trouble::Doubled;
        deliver(letter, when);
    }
}

void LinkEnd::shut(bool tells) {
    World* world = World::current();
    if (!open || world == nullptr) {
        return;
    }
    // A message that has already reached a waiting receiver is still delivered.
    if (is_awaited && !inbox.empty()) {
        incoming = std::move(inbox.front());
    }
    open = false;
    wake_up(*world);
    const Host* from = world->find_host(host);
    const Host* into = world->find_host(other_id);
    if (from != nullptr && into != nullptr) {
        break_off(*from, *into, *world);
    }
    if (!tells || is_broken) {
        return;
    }
    const Time when = std::max(last_arrival, world->now() + latency_max);
    world->at(when, [world, to = other] {
        if (const auto there = to.lock()) {
            there->is_ended = true;
            there->wake_up(*world);
        }
    });
}

void LinkEnd::notice_cut(Duration latest, std::optional<Trouble> trouble) {
    World& world = *World::current();
    world.in(world.between(0s, latest), [&world, end = weak_from_this(), trouble] {
        if (const auto state = end.lock(); state != nullptr && state->open) {
            if (trouble && !state->is_ended) {
                world.troubles.add(*trouble);
            }
            state->inbox.clear();
            state->is_ended = true;
            state->wake_up(world);
        }
    });
}

void LinkEnd::break_off(const Host& from, const Host& there, World& world) {
    if (is_broken || !world.is_severed(from, there)) {
        return;
    }
    is_broken = true;
    world.in(timing::write_stall_max, [end = weak_from_this()] {
        if (const auto state = end.lock()) {
            state->notice_cut(1s, std::nullopt);
        }
    });
}

void LinkEnd::cut(Trouble trouble) {
    notice_cut(4s, trouble);
    if (const auto there = other.lock()) {
        there->notice_cut(4s, trouble);
    }
}

void LinkEnd::cut_late(const Letter& letter) {
    World& world = *World::current();
    world.log("late: " + name_of(letter.message) + ", of " + this_host);
    Letter late = letter;
    late.trouble = Trouble::Late;
    world.find_host(host)->at_greeting.push_back([&world, end = other, late] {
        if (const auto old = end.lock()) {
            old->arrive(late, world);
        }
    });
    notice_cut(1s, std::nullopt);
}

/// A sender of blocks must wait until the blocks before are on their way.
void LinkEnd::check_flight(World& world) const {
    const std::size_t most =
        host == tests::master_host ? limits::subtrees_queue_bytes_max : limits::subtrees_bytes_min;
    if (blocks_queued >= most) {
        world.problem("blocks go to " + other_host + ", and " + std::to_string(blocks_queued) +
                      " bytes of them are under way");
    }
}

/// Little besides blocks queues up, because jobs and results are small here.
void LinkEnd::check_queue(World& world) const {
    constexpr std::size_t most = 256u << 10;
    if (queued - blocks_queued > most) {
        world.problem(std::to_string(queued - blocks_queued) + " bytes queue up towards " +
                      other_host);
    }
}

} // namespace cd::tests
