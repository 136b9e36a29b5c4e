#include "common/job/result/part_contacts.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cd {

namespace {

constexpr std::uint32_t no_pair = UINT32_MAX;

/// Adds the contacts of other scenarios.
void merge(PartPairContacts& sum, const PartPairContacts& other) {
    const bool is_first = sum.scenarios == 0;
    sum.scenarios += other.scenarios;
    sum.pairs += other.pairs;
    sum.near += other.near;
    const auto most = std::tie(sum.worst_pairs, sum.worst_near);
    const auto others_most = std::tie(other.worst_pairs, other.worst_near);
    if (others_most > most || (others_most == most && other.worst < sum.worst)) {
        sum.worst = other.worst;
        sum.worst_pairs = other.worst_pairs;
        sum.worst_near = other.worst_near;
    }
    sum.first = is_first ? other.first : std::min(sum.first, other.first);
    sum.last = std::max(sum.last, other.last);
    sum.has_proper = sum.has_proper || other.has_proper;
}

} // namespace

ScenarioClass class_of(const PartPairContacts& pair) {
    return pair.has_proper   ? ScenarioClass::Cross
           : pair.pairs == 0 ? ScenarioClass::Near
                             : ScenarioClass::Contact;
}

void PartContactSum::PairSum::count(PairClass kind) {
    ++(kind == PairClass::Near ? near_here : pairs_here);
    has_proper_here = has_proper_here || kind == PairClass::Proper;
}

std::uint32_t PartContactSum::find(std::uint32_t a, std::uint32_t b) {
    if (are_too_many_) {
        return no_pair;
    }
    const std::uint64_t key = std::uint64_t{a} << 32 | b;
    if (const auto found = numbers_.find(key); found != numbers_.end()) {
        return found->second;
    }
    if (pairs_.size() == limits::groups_max) {
        leave_out();
        return no_pair;
    }
    PairSum pair;
    pair.sum.a = a;
    pair.sum.b = b;
    pairs_.push_back(pair);
    return numbers_.emplace(key, static_cast<std::uint32_t>(pairs_.size() - 1)).first->second;
}

void PartContactSum::leave_out() {
    are_too_many_ = true;
    for (const PairSum& pair : pairs_) {
        left_out_ += pair.sum.pairs + pair.sum.near;
    }
    for (const std::uint32_t number : here_) {
        left_out_ += pairs_[number].pairs_here + pairs_[number].near_here;
    }
    here_.clear();
    pairs_ = {};
    numbers_ = {};
}

void PartContactSum::note_part(std::size_t side, std::uint32_t part) {
    PartSum& sum = of_parts_[side][part];
    if (sum.stamp != stamp_) {
        sum.stamp = stamp_;
        ++sum.scenarios;
    }
}

void PartContactSum::begin_in_scenario(std::uint32_t number) {
    PairSum& pair = pairs_[number];
    pair.stamp = stamp_;
    pair.pairs_here = 0;
    pair.near_here = 0;
    pair.has_proper_here = false;
    here_.push_back(number);
}

void PartContactSum::add(std::uint64_t scenario, std::span<const ContactPair> pairs) {
    if (pairs.empty()) {
        return;
    }
    CD_CHECK(parts_ != nullptr);
    ++stamp_;
    PartCursor of_a((*parts_)[0]);
    PartCursor of_b((*parts_)[1]);
    std::uint64_t last = UINT64_MAX; // The parts of the last pair; no pair of parts has this key.
    std::uint32_t number = no_pair;
    for (const ContactPair& pair : pairs) {
        const std::uint32_t a = of_a.part_of(pair.a);
        const std::uint32_t b = of_b.part_of(pair.b);
        if (const std::uint64_t key = std::uint64_t{a} << 32 | b; key != last) {
            last = key;
            number = find(a, b);
            if (number == no_pair || pairs_[number].stamp != stamp_) {
                note_part(0, a);
                note_part(1, b);
            }
            if (number != no_pair && pairs_[number].stamp != stamp_) {
                begin_in_scenario(number);
            }
        }
        if (number == no_pair) {
            ++left_out_;
            continue;
        }
        pairs_[number].count(pair.kind);
    }
    end_scenario(scenario);
}

void PartContactSum::end_scenario(std::uint64_t scenario) {
    for (const std::uint32_t number : here_) {
        PairSum& pair = pairs_[number];
        merge(pair.sum,
              {pair.sum.a,
               pair.sum.b,
               1,
               pair.pairs_here,
               scenario,
               pair.pairs_here,
               scenario,
               scenario,
               pair.has_proper_here,
               pair.near_here,
               pair.near_here});
    }
    here_.clear();
}

void PartContactSum::add(const PartContacts& contacts) {
    for (std::size_t side = 0; side < of_parts_.size(); ++side) {
        for (const PartScenarios& part : contacts.parts[side]) {
            of_parts_[side][part.part].scenarios += part.scenarios;
        }
    }
    if (contacts.left_out != 0) {
        leave_out();
        left_out_ += contacts.left_out;
    }
    for (const PartPairContacts& pair : contacts.pairs) {
        if (const std::uint32_t number = find(pair.a, pair.b); number != no_pair) {
            merge(pairs_[number].sum, pair);
        } else {
            left_out_ += pair.pairs + pair.near;
        }
    }
}

std::uint64_t PartContactSum::bytes() const {
    constexpr std::uint64_t node_bytes = 32; // About what a hash table takes besides its values.
    return pairs_.size() * (sizeof(PairSum) + node_bytes) +
           (of_parts_[0].size() + of_parts_[1].size()) * (sizeof(PartSum) + node_bytes);
}

PartContacts PartContactSum::sums() const {
    PartContacts contacts;
    for (std::size_t side = 0; side < of_parts_.size(); ++side) {
        for (const auto& [part, sum] : of_parts_[side]) {
            contacts.parts[side].push_back({part, sum.scenarios});
        }
        std::ranges::sort(contacts.parts[side], std::ranges::less(), &PartScenarios::part);
    }
    for (const PairSum& pair : pairs_) {
        contacts.pairs.push_back(pair.sum);
    }
    std::ranges::sort(contacts.pairs, [](const auto& left, const auto& right) {
        return std::tie(left.a, left.b) < std::tie(right.a, right.b);
    });
    contacts.left_out = left_out_;
    return contacts;
}

} // namespace cd
