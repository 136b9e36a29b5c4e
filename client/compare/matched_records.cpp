#include "client/compare/matched_records.hpp"

#include "common/core/errors.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t ahead_scenarios = 8192;
/// Size of the records read ahead; further ones are read when they are asked for.
constexpr std::uint64_t ahead_bytes_enough = 64u << 20;

} // namespace

Result<const ScenarioResult*> MatchedRecords::of(std::uint64_t index) {
    const ScenarioResult* const none = nullptr;
    if (index >= ahead_end_) {
        CD_TRY(read_ahead(index));
    }
    const auto earlier = match_.earlier(index);
    if (!earlier) {
        return none;
    }
    if (const auto found = ahead_.find(*earlier); found != ahead_.end()) {
        return &found->second;
    }
    const KeptRecord* const record = CD_TRY(records_.find(*earlier));
    return record == nullptr ? none : &record->result;
}

/// Reads the results of the scenarios from `first` on that do not come in the earlier run's order.
Status MatchedRecords::read_ahead(std::uint64_t first) {
    ahead_.clear();
    ahead_end_ = std::min(first + ahead_scenarios, scenarios_);
    std::vector<std::uint64_t> wanted;
    for (std::uint64_t index = first; index < ahead_end_; ++index) {
        if (const auto earlier = match_.earlier(index)) {
            wanted.push_back(*earlier);
        }
    }
    if (std::ranges::is_sorted(wanted)) {
        return Done{};
    }
    std::ranges::sort(wanted);
    std::uint64_t bytes = 0;
    for (const std::uint64_t earlier : wanted) {
        const KeptRecord* const record = CD_TRY(records_.find(earlier));
        if (record != nullptr) {
            bytes += record->bytes.size();
            ahead_.emplace(earlier, record->result);
        }
        if (bytes >= ahead_bytes_enough) {
            break;
        }
    }
    return Done{};
}

} // namespace cd
