#include "master/base/position_set.hpp"

#include "master/base/mutation.hpp"

#include <algorithm>
#include <utility>

namespace cd {

PositionSet PositionSet::of(std::vector<std::uint64_t> positions) {
    if (!std::ranges::is_sorted(positions)) {
        std::ranges::sort(positions);
    }
    PositionSet set;
    for (const std::uint64_t position : positions) {
        set.add({position, 1});
    }
    return set;
}

PositionSet::Runs::const_iterator PositionSet::run_after(std::uint64_t position) const {
    return std::ranges::upper_bound(runs_, position, {}, &PlaceRange::end);
}

bool PositionSet::contains(std::uint64_t position) const {
    const auto run = run_after(position);
    return run != runs_.end() && run->first <= position;
}

std::vector<std::uint64_t> PositionSet::list() const {
    std::vector<std::uint64_t> positions;
    positions.reserve(count_);
    for (const PlaceRange& run : runs_) {
        for (std::uint64_t position = run.first; position < run.end(); ++position) {
            positions.push_back(position);
        }
    }
    return positions;
}

PositionSet PositionSet::last(std::uint64_t most) const {
    PositionSet rest = *this;
    while (rest.count_ > most) {
        const PlaceRange& first = rest.runs_.front();
        rest.remove({first.first, std::min(first.count, rest.count_ - most)});
    }
    return rest;
}

PositionSet PositionSet::common_with(const PositionSet& other) const {
    PositionSet common;
    for (const PlaceRange& wanted : other.runs_) {
        for (auto run = run_after(wanted.first); run != runs_.end() && run->first < wanted.end();
             ++run) {
            const std::uint64_t first = std::max(run->first, wanted.first);
            common.add({first, std::min(run->end(), wanted.end()) - first});
        }
    }
    return common;
}

void PositionSet::add(const PlaceRange& range) {
    if (range.count == 0) {
        return;
    }
    // Replaces all runs that overlap or touch the range by one.
    auto begin = runs_.end();
    if (!runs_.empty() && runs_.back().end() >= range.first) {
        begin = std::ranges::lower_bound(runs_, range.first, {}, &PlaceRange::end);
    }
    auto end = begin;
    std::uint64_t first = range.first;
    std::uint64_t last = range.end();
    for (; end != runs_.end() && end->first <= range.end(); ++end) {
        first = std::min(first, end->first);
        last = std::max(last, end->end());
        count_ -= end->count;
    }
    const PlaceRange joined{first, last - first};
    count_ += joined.count;
    if (begin == end) {
        runs_.insert(begin, joined);
        return;
    }
    *begin = joined;
    runs_.erase(begin + 1, end);
}

void PositionSet::add(const PositionSet& other) {
    for (const PlaceRange& run : other.runs_) {
        add(run);
    }
}

void PositionSet::remove(const PlaceRange& range) {
    if (range.count == 0) {
        return; // An empty hole must not split a run.
    }
    auto run = runs_.begin() + (run_after(range.first) - runs_.cbegin());
    while (run != runs_.end() && run->first < range.end()) {
        const PlaceRange before{run->first, std::max(range.first, run->first) - run->first};
        const std::uint64_t end = std::max(range.end(), before.end());
        const PlaceRange after{end, run->end() - std::min(end, run->end())};
        count_ -= run->count - before.count - after.count;
        if (before.count != 0 && after.count != 0) {
            *run = before;
            if (mutated(Mutation::SplitRunLosesEnd)) {
                count_ -= after.count;
                return;
            }
            runs_.insert(run + 1, after);
            return;
        }
        if (before.count == 0 && after.count == 0) {
            run = runs_.erase(run);
        } else {
            *run++ = before.count != 0 ? before : after;
        }
    }
}

void PositionSet::remove(const PositionSet& other) {
    for (const PlaceRange& run : other.runs_) {
        remove(run);
    }
}

} // namespace cd
