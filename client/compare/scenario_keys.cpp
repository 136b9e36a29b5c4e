#include "client/compare/scenario_keys.hpp"

#include "common/core/files/bytes.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/poses/poses_hash.hpp"

#include <algorithm>
#include <cstring>
#include <span>

namespace cd {

namespace {

ScenarioKey first_bytes_of(const Sha256& hash) {
    ScenarioKey key;
    std::memcpy(&key.high, hash.bytes.data(), sizeof key.high);
    std::memcpy(&key.low, hash.bytes.data() + sizeof key.high, sizeof key.low);
    return key;
}

} // namespace

ScenarioKey key_of(const Scenario& scenario) {
    PosesHash hash;
    hash.add({&scenario, 1});
    return first_bytes_of(hash.finish());
}

ScenarioKey key_of_step(const Scenario& scenario) {
    constexpr std::uint32_t bits_of_body = 14;
    static_assert(limits::bodies_max == 1u << bits_of_body);
    return {scenario.step.value_or(0), scenario.body_a << bits_of_body | scenario.body_b};
}

ScenarioKey key_of(std::string_view id) {
    return first_bytes_of(sha256(std::as_bytes(std::span(id))));
}

Result<ScenarioKeys> ScenarioKeys::for_run(std::uint64_t scenarios) {
    if (scenarios > UINT32_MAX) {
        return Error{ErrorCode::TooLarge,
                     "scenarios of a run with more than 4 294 967 295 are matched only by their "
                     "index, which takes equal poses"};
    }
    ScenarioKeys table;
    table.entries_.reserve(scenarios);
    return table;
}

void ScenarioKeys::add(const ScenarioKey& key) {
    entries_.push_back({key.high, key.low, static_cast<std::uint32_t>(entries_.size())});
}

void ScenarioKeys::sort() {
    std::ranges::sort(entries_);
    taken_.assign(entries_.size(), false);
}

std::size_t ScenarioKeys::place_of(const ScenarioKey& key) const {
    const auto found = std::ranges::lower_bound(entries_, key, {}, &Entry::key);
    return static_cast<std::size_t>(found - entries_.begin());
}

bool ScenarioKeys::has_at(std::size_t place, const ScenarioKey& key) const {
    return place < entries_.size() && entries_[place].key() == key;
}

std::optional<std::uint64_t> ScenarioKeys::find(const ScenarioKey& key) const {
    const std::size_t place = place_of(key);
    return has_at(place, key) ? std::optional<std::uint64_t>(entries_[place].index) : std::nullopt;
}

std::optional<std::uint64_t> ScenarioKeys::take(const ScenarioKey& key) {
    const std::size_t first = place_of(key);
    std::size_t place = first;
    if (has_at(first + 1, key)) {
        place += repeats_taken_[first]++;
    }
    if (!has_at(place, key) || taken_[place]) {
        return std::nullopt;
    }
    taken_[place] = true;
    return entries_[place].index;
}

} // namespace cd
