#include "client/compare/matched_records.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cd {

Result<const ScenarioResult*> MatchedRecords::of(std::uint64_t index) {
    const ScenarioResult* const none = nullptr;
    if (index >= window_end_) {
        CD_TRY(begin_window(index));
    }
    const auto earlier = match_.earlier(index);
    if (!earlier) {
        return none;
    }
    if (ahead_.empty()) {
        const KeptRecord* const record = CD_TRY(records_.find(*earlier));
        return record == nullptr ? none : &record->result;
    }
    const Bytes& record = ahead_[index - window_begin_];
    if (record.empty()) {
        return none;
    }
    found_ = CD_TRY(decode_result(record));
    return &found_;
}

/// Begins a window at a scenario. Reads its records ahead unless they come in the file's order.
Status MatchedRecords::begin_window(std::uint64_t first) {
    ahead_.clear();
    window_begin_ = first;
    window_end_ =
        std::min(first + limits::compared_window_scenarios_max, std::max(scenarios_, first + 1));
    std::vector<std::array<std::uint64_t, 2>> wanted; // The earlier index, and that in the window.
    for (std::uint64_t index = first; index < window_end_; ++index) {
        if (const auto earlier = match_.earlier(index)) {
            wanted.push_back({*earlier, index - first});
        }
    }
    return std::ranges::is_sorted(wanted) ? Status(Done{}) : read_ahead(std::move(wanted));
}

/// Reads the wanted records in the file's order. Halves the window while they have too many bytes.
Status MatchedRecords::read_ahead(std::vector<std::array<std::uint64_t, 2>> wanted) {
    std::ranges::sort(wanted);
    ahead_.resize(window_end_ - window_begin_);
    std::uint64_t bytes = 0;
    for (const auto& [earlier, place] : wanted) {
        if (place >= ahead_.size()) {
            continue;
        }
        const KeptRecord* const record = CD_TRY(records_.find(earlier));
        if (record != nullptr) {
            ahead_[place] = record->bytes;
            bytes += record->bytes.size();
        }
        while (bytes > ahead_bytes_max_ && ahead_.size() > 1) {
            bytes -= halve_window();
        }
    }
    return Done{};
}

/// Returns the size of the records that are dropped.
std::uint64_t MatchedRecords::halve_window() {
    const std::size_t size = ahead_.size() / 2;
    std::uint64_t bytes = 0;
    for (std::size_t place = size; place < ahead_.size(); ++place) {
        bytes += ahead_[place].size();
    }
    ahead_.resize(size);
    window_end_ = window_begin_ + size;
    return bytes;
}

} // namespace cd
