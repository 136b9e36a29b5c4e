#include "proto/codec/message.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/codec/codec.hpp"
#include "proto/messages/party.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace cd {
namespace {

enum class Lane { Control, Data };

// The senders of a message type, as bits.
constexpr unsigned of_stranger = 1;
constexpr unsigned of_joiner = 2;
constexpr unsigned of_client = 4;
constexpr unsigned of_worker = 8;
constexpr unsigned of_peer = 16;
constexpr unsigned of_giver = 32;
constexpr unsigned of_master = 64;
constexpr unsigned of_all = 127;

/// Properties of a message type on the wire.
struct Kind {
    std::string_view name;
    unsigned senders = 0;
    Lane lane = Lane::Control;
    std::uint64_t bytes_max = limits::message_control_bytes_max;
};

// One row per message type, in the order of `Message`. Messages that must not overtake data, such
// as ends and removals, are data too.
constexpr std::array<Kind, std::variant_size_v<Message>> kinds{{
    {"hello", of_stranger, Lane::Control, limits::greeting_bytes_max},
    {"welcome", of_stranger},
    {"failure", of_all},
    {"heartbeat", of_worker | of_client | of_master},
    {"add tree", of_master, Lane::Data},
    {"remove tree", of_master, Lane::Data},
    {"subtrees", of_master | of_giver, Lane::Data, limits::message_subtrees_bytes_max},
    {"work unit", of_master, Lane::Data, limits::message_data_bytes_max},
    {"drain", of_worker | of_master, Lane::Data},
    {"terminate", of_master},
    {"want subtrees", of_worker, Lane::Control, limits::message_roots_bytes_max},
    {"results", of_worker, Lane::Data, limits::message_results_bytes_max},
    {"end of task", of_worker, Lane::Data},
    {"evicted", of_worker, Lane::Control, limits::message_roots_bytes_max},
    {"meshes query", of_client},
    {"meshes missing", of_master},
    {"mesh part", of_client, Lane::Data, limits::message_part_bytes_max},
    {"mesh stored", of_master},
    {"submit", of_client, Lane::Data, limits::message_part_bytes_max},
    {"poses part", of_client, Lane::Data, limits::message_part_bytes_max},
    {"poses end", of_client, Lane::Data},
    {"accepted", of_master},
    {"watch", of_client},
    {"job status", of_master},
    {"status query", of_client},
    {"cluster status", of_master, Lane::Control, limits::message_data_bytes_max},
    {"results query", of_client},
    {"results part", of_master, Lane::Data, limits::message_results_bytes_max},
    {"cancel", of_client},
    {"fetch from peers", of_master, Lane::Data, limits::message_data_bytes_max},
    {"held", of_worker, Lane::Control, limits::message_roots_bytes_max},
    {"fetch failed", of_worker, Lane::Control, limits::message_roots_bytes_max},
    {"peer fetch", of_peer, Lane::Control, limits::message_roots_bytes_max},
    {"peer fetched", of_giver, Lane::Data, limits::message_roots_bytes_max},
    {"explain", of_client},
    {"explained", of_master, Lane::Control, limits::message_data_bytes_max},
    {"add job", of_master, Lane::Data, limits::message_data_bytes_max},
    {"remove job", of_master, Lane::Data},
    {"results kept", of_master},
    {"holding", of_worker, Lane::Control, limits::message_roots_bytes_max},
    {"join", of_joiner, Lane::Control, limits::join_bytes_max},
    {"renew", of_joiner, Lane::Control, limits::join_bytes_max},
    {"certified", of_master},
    {"token create", of_client},
    {"token created", of_master},
    {"inventory", of_worker, Lane::Data, limits::message_roots_bytes_max},
    {"drop scenario", of_master, Lane::Data},
    {"recall", of_master, Lane::Data, limits::message_roots_bytes_max},
    {"recalled", of_worker, Lane::Data, limits::message_roots_bytes_max},
    {"hint", of_master, Lane::Data, limits::message_roots_bytes_max},
    {"contact map query", of_client},
    {"contact map", of_master, Lane::Data, limits::message_results_bytes_max},
    {"job query", of_client},
    {"job description", of_master, Lane::Data, limits::message_data_bytes_max},
    {"mesh query", of_client},
    {"mesh bytes", of_master, Lane::Data, limits::message_part_bytes_max},
    {"poses query", of_client},
    {"job poses", of_master, Lane::Data, limits::message_part_bytes_max},
    {"remove", of_client},
    {"remove mesh", of_client},
    {"removed", of_master},
    {"drain workers", of_client},
    {"draining", of_master},
    {"set priority", of_client},
}};
static_assert(!kinds.back().name.empty(), "a message without a row");

const Kind* kind_of(std::uint16_t type) {
    return type >= 1 && type <= kinds.size() ? &kinds[type - 1u] : nullptr;
}

unsigned sender_bit(Party party) {
    switch (party) {
    case Party::Stranger:
        return of_stranger;
    case Party::Anyone:
        return of_all;
    case Party::Joiner:
        return of_joiner;
    case Party::Observer: // The master refuses what an observer may not ask, and says why.
    case Party::Client:
        return of_client;
    case Party::Worker:
        return of_worker;
    case Party::Peer:
        return of_peer;
    case Party::Giver:
        return of_giver;
    case Party::Master:
        return of_master;
    }
    return 0;
}

constexpr std::array<std::string_view, 9> party_names{"a stranger",
                                                      "a peer",
                                                      "a joiner",
                                                      "an observer",
                                                      "a client",
                                                      "a worker",
                                                      "a fetching worker",
                                                      "a giving worker",
                                                      "a master"};
constexpr std::array<std::string_view, 3> names_of_modes{"auto", "always", "never"};
constexpr std::array<std::string_view, 4> state_names{"running", "done", "cancelled", "failed"};
constexpr std::array<std::string_view, 3> worker_state_names{"alive", "silent", "lost"};
constexpr std::array<std::string_view, 6> outcome_names{
    "given", "busy", "missing", "unreachable", "damaged", "refused"};

template <class Enum>
std::optional<Enum> from_text(std::string_view text, std::span<const std::string_view> names) {
    const auto found = std::find(names.begin(), names.end(), text);
    return found == names.end() ? std::nullopt
                                : std::optional(static_cast<Enum>(found - names.begin()));
}

} // namespace

BlockTraffic& BlockTraffic::operator+=(const BlockTraffic& other) {
    hits += other.hits;
    misses += other.misses;
    hinted += other.hinted;
    evictions += other.evictions;
    master_bytes += other.master_bytes;
    peer_bytes += other.peer_bytes;
    return *this;
}

std::uint16_t message_type(const Message& message) {
    return static_cast<std::uint16_t>(message.index() + 1);
}

std::string_view message_name(std::uint16_t type) {
    const Kind* kind = kind_of(type);
    return kind == nullptr ? "unknown" : kind->name;
}

std::uint64_t payload_bytes_max(std::uint16_t type) {
    const Kind* kind = kind_of(type);
    return kind == nullptr ? 0 : kind->bytes_max;
}

Party party_of(Role role) {
    switch (role) {
    case Role::Worker:
        return Party::Worker;
    case Role::Client:
        return Party::Client;
    case Role::Peer:
        return Party::Peer;
    case Role::Joiner:
        break;
    }
    return Party::Joiner;
}

std::string_view to_text(Party party) {
    return party_names[static_cast<std::size_t>(party)];
}

std::uint64_t payload_bytes_max_from(Party party, std::uint16_t type) {
    const Kind* kind = kind_of(type);
    if (kind == nullptr || (kind->senders & sender_bit(party)) == 0) {
        return 0;
    }
    if (party == Party::Stranger) {
        return std::min(kind->bytes_max, limits::greeting_bytes_max);
    }
    if (party == Party::Observer) {
        return std::min(kind->bytes_max, limits::observer_bytes_max);
    }
    return party == Party::Joiner ? std::min(kind->bytes_max, limits::join_bytes_max)
                                  : kind->bytes_max;
}

std::size_t streams_max_of(Party party) {
    const bool is_small =
        party == Party::Stranger || party == Party::Joiner || party == Party::Observer;
    const bool is_known = party != Party::Anyone;
    return is_small   ? limits::streams_small_max
           : is_known ? limits::streams_of_lanes_max
                      : limits::streams_max;
}

bool travels_as_data(std::uint16_t type) {
    const Kind* kind = kind_of(type);
    return kind != nullptr && kind->lane == Lane::Data;
}

const Strategy* find_strategy(std::string_view name) {
    const auto found = std::ranges::find(strategies, name, &Strategy::name);
    return found == strategies.end() ? nullptr : &*found;
}

std::vector<std::string_view> strategy_names() {
    std::vector<std::string_view> names;
    std::ranges::transform(strategies, std::back_inserter(names), &Strategy::name);
    return names;
}

bool is_strategy_name(std::string_view text) {
    return !text.empty() && text.size() <= limits::strategy_name_bytes_max &&
           text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == text.npos;
}

std::string_view to_text(AnalysisMode mode) {
    return names_of_modes[static_cast<std::size_t>(mode)];
}

std::optional<AnalysisMode> analysis_mode_from_text(std::string_view text) {
    return from_text<AnalysisMode>(text, names_of_modes);
}

std::span<const std::string_view> analysis_mode_names() {
    return names_of_modes;
}

std::string_view to_text(JobState state) {
    return state_names[static_cast<std::size_t>(state)];
}

std::string_view to_text(WorkerState state) {
    return worker_state_names[static_cast<std::size_t>(state)];
}

std::string_view to_text(PeerOutcome outcome) {
    return outcome_names[static_cast<std::size_t>(outcome)];
}

} // namespace cd
