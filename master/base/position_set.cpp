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
    for (std::size_t i = 0; i < positions.size();) {
        const std::uint64_t first = positions[i];
        std::uint64_t count = 0;
        for (; i < positions.size() && positions[i] == first + count; ++i) {
            ++count;
        }
        set.add({first, count});
    }
    return set;
}

PositionSet::Runs::const_iterator PositionSet::run_after(std::uint64_t position) const {
    return std::ranges::upper_bound(runs_, position, {}, &PositionRange::end);
}

bool PositionSet::contains(std::uint64_t position) const {
    const auto run = run_after(position);
    return run != runs_.end() && run->first <= position;
}

std::vector<std::uint64_t> PositionSet::list() const {
    std::vector<std::uint64_t> positions;
    positions.reserve(count_);
    for (const PositionRange& run : runs_) {
        for (std::uint64_t position = run.first; position < run.end(); ++position) {
            positions.push_back(position);
        }
    }
    return positions;
}

PositionSet PositionSet::last(std::uint64_t most) const {
    PositionSet rest = *this;
    while (rest.count_ > most) {
        const PositionRange& first = rest.runs_.front();
        rest.remove({first.first, std::min(first.count, rest.count_ - most)});
    }
    return rest;
}

PositionSet PositionSet::common_with(const PositionSet& other) const {
    PositionSet common;
    for (const PositionRange& wanted : other.runs_) {
        for (auto run = run_after(wanted.first); run != runs_.end() && run->first < wanted.end();
             ++run) {
            const std::uint64_t first = std::max(run->first, wanted.first);
            common.add({first, std::min(run->end(), wanted.end()) - first});
        }
    }
    return common;
}

void PositionSet::add(const PositionRange& range) {
    if (range.count == 0) {
        return;
    }
    // Replaces all runs that overlap or touch the range by one.
    auto begin = runs_.end();
    if (!runs_.empty() && runs_.back().end() >= range.first) {
        begin = std::ranges::lower_bound(runs_, range.first, {}, &PositionRange::end);
    }
    auto end = begin;
    std::uint64_t first = range.first;
    std::uint64_t last = range.end();
    for (; end != runs_.end() && end->first <= range.end(); ++end) {
        first = std::min(first, end->first);
        last = std::max(last, end->end());
        count_ -= end->count;
    }
    const PositionRange joined{first, last - first};
    count_ += joined.count;
    if (begin == end) {
        runs_.insert(begin, joined);
        return;
    }
    *begin = joined;
    runs_.erase(begin + 1, end);
}

void PositionSet::add(const PositionSet& other) {
    for (const PositionRange& run : other.runs_) {
        add(run);
    }
}

void PositionSet::remove(const PositionRange& hole) {
    auto run = runs_.begin() + (run_after(hole.first) - runs_.cbegin());
    while (hole.count != 0 && run != runs_.end() && run->first < hole.end()) {
        const std::uint64_t first = std::max(run->first, hole.first);
        const std::uint64_t end = std::min(run->end(), hole.end());
        const PositionRange after{end, run->end() - end};
        count_ -= mutated(Mutation::SplitRunLosesEnd) ? run->end() - first : end - first;
        run->count = first - run->first;
        run = run->count == 0 ? runs_.erase(run) : run + 1;
        if (after.count != 0 && !mutated(Mutation::SplitRunLosesEnd)) {
            runs_.insert(run, after);
            return;
        }
    }
}

void PositionSet::remove(const PositionSet& other) {
    for (const PositionRange& run : other.runs_) {
        remove(run);
    }
}

} // namespace cd
