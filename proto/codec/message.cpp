#include "proto/codec/message.hpp"

#include "common/core/limits/wire.hpp"

#include <algorithm>
#include <array>

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

} // namespace

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

bool travels_as_data(std::uint16_t type) {
    const Kind* kind = kind_of(type);
    return kind != nullptr && kind->lane == Lane::Data;
}

} // namespace cd
