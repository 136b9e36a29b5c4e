#include "proto/message.hpp"

#include "common/core/limits.hpp"
#include "proto/codec.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace cd {
namespace {

enum class Lane { Control, Data };

/// What the wire knows of a type beside its members.
struct Kind {
    std::string_view name;
    Lane lane = Lane::Control;
    std::uint64_t bytes_max = limits::message_control_bytes_max;
};

// In the order of `Message`. What must not overtake data (the end of something, a removal) travels
// in the lane of data itself.
constexpr std::array<Kind, std::variant_size_v<Message>> kinds{{
    {"hello"},
    {"welcome"},
    {"failure"},
    {"heartbeat"},
    {"add tree", Lane::Data},
    {"remove tree", Lane::Data},
    {"subtrees", Lane::Data, limits::message_subtrees_bytes_max},
    {"batch", Lane::Data, limits::message_data_bytes_max},
    {"drain", Lane::Data},
    {"terminate"},
    {"want subtrees", Lane::Control, limits::message_roots_bytes_max},
    {"results", Lane::Data, limits::message_results_bytes_max},
    {"end of task", Lane::Data},
    {"evicted", Lane::Control, limits::message_roots_bytes_max},
    {"meshes query"},
    {"meshes missing"},
    {"mesh part", Lane::Data, limits::message_data_bytes_max},
    {"mesh stored"},
    {"submit", Lane::Data, limits::message_data_bytes_max},
    {"poses part", Lane::Data, limits::message_data_bytes_max},
    {"poses end", Lane::Data},
    {"accepted"},
    {"watch"},
    {"job status"},
    {"status query"},
    {"cluster status", Lane::Control, limits::message_data_bytes_max},
    {"results query"},
    {"results part", Lane::Data, limits::message_results_bytes_max},
    {"cancel"},
    {"fetch from peers", Lane::Data, limits::message_data_bytes_max},
    {"held", Lane::Control, limits::message_roots_bytes_max},
    {"fetch failed", Lane::Control, limits::message_roots_bytes_max},
    {"peer fetch", Lane::Control, limits::message_roots_bytes_max},
    {"peer fetched", Lane::Data, limits::message_roots_bytes_max},
    {"explain"},
    {"explained", Lane::Control, limits::message_data_bytes_max},
    {"add job", Lane::Data, limits::message_data_bytes_max},
    {"remove job", Lane::Data},
    {"scenario range", Lane::Data, limits::message_data_bytes_max},
    {"results kept"},
    {"holding", Lane::Control, limits::message_roots_bytes_max},
    {"join"},
    {"renew"},
    {"certified"},
    {"token create"},
    {"token created"},
    {"standing", Lane::Data, limits::message_roots_bytes_max},
    {"drop scenario", Lane::Data},
    {"recall", Lane::Data, limits::message_roots_bytes_max},
    {"recalled", Lane::Data, limits::message_roots_bytes_max},
    {"hint", Lane::Data, limits::message_roots_bytes_max},
    {"contact map query"},
    {"contact map", Lane::Data, limits::message_results_bytes_max},
}};
static_assert(!kinds.back().name.empty(), "a message without a row");

const Kind* kind_of(std::uint16_t type) {
    return type >= 1 && type <= kinds.size() ? &kinds[type - 1u] : nullptr;
}

constexpr std::array<std::string_view, 6> names_of_strategies{
    "best-match", "best-match-load", "random", "lowest", "best-match-pull", "earliest-finish"};
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

bool travels_as_data(std::uint16_t type) {
    const Kind* kind = kind_of(type);
    return kind != nullptr && kind->lane == Lane::Data;
}

std::string_view to_text(Strategy strategy) {
    return names_of_strategies[static_cast<std::size_t>(strategy)];
}

std::optional<Strategy> strategy_from_text(std::string_view text) {
    return from_text<Strategy>(text, names_of_strategies);
}

std::span<const std::string_view> strategy_names() {
    return names_of_strategies;
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
