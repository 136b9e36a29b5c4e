#include "common/job/shots/equal_depths.hpp"

#include <algorithm>

namespace cd {

namespace {

/// A list that a search follows for this many hits is moved to the hash table.
constexpr int listed_most = 32;

} // namespace

void EqualDepths::restart(std::span<const std::uint32_t> lines,
                          std::span<const double> depths,
                          std::size_t line_count) {
    lines_ = lines;
    depths_ = depths;
    of_lines_.assign(line_count, {});
    before_.resize(std::max(before_.size(), lines.size()));
    table_.clear();
}

/// Returns a stored hit of the line that has the new hit's depth; else `none`. If the list is long,
/// moves it to the table together with the new hit.
std::uint32_t EqualDepths::find(Line& line, std::uint32_t hit) {
    if (line.last == in_table) {
        return add_to_table(hit);
    }
    const double depth = depths_[hit];
    int count = 0;
    for (std::uint32_t other = line.last; other != none; other = before_[other]) {
        if (depths_[other] == depth) {
            return other;
        }
        if (++count == listed_most) {
            move_to_table(line);
            return add_to_table(hit);
        }
    }
    return none;
}

void EqualDepths::move_to_table(Line& line) {
    if (table_.empty()) {
        // At most half of the table is in use.
        table_bits_ = static_cast<unsigned>(std::bit_width(2 * lines_.size()));
        table_.assign(std::size_t{1} << table_bits_, none);
    }
    for (std::uint32_t hit = line.last; hit != none; hit = before_[hit]) {
        static_cast<void>(add_to_table(hit));
    }
    line = {~std::uint64_t{0}, in_table};
}

std::uint32_t EqualDepths::add_to_table(std::uint32_t hit) {
    const std::uint32_t line = lines_[hit];
    const double depth = depths_[hit];
    const std::uint64_t of_line = line * std::rotl(std::uint64_t{0x9e3779b97f4a7c15}, 32);
    std::size_t place = hash_of(depth, table_bits_, of_line);
    while (table_[place] != none) {
        const std::uint32_t other = table_[place];
        if (lines_[other] == line && depths_[other] == depth) {
            return other;
        }
        place = (place + 1) & (table_.size() - 1);
    }
    table_[place] = hit;
    return none;
}

} // namespace cd
