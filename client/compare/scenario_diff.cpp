#include "client/compare/scenario_diff.hpp"

#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <vector>

namespace cd {

namespace {

constexpr std::size_t no_result = outcome_kinds - 1;

std::size_t outcome_of(const ScenarioResult* result) {
    return result == nullptr ? no_result : static_cast<std::size_t>(result->kind);
}

/// True if a class is one that level any reports as contact.
bool is_surface_contact(ScenarioClass kind) {
    return kind == ScenarioClass::Touch || kind == ScenarioClass::Cross ||
           kind == ScenarioClass::Contact;
}

bool is_of_level_any(const ScenarioResult& was, const ScenarioResult& is) {
    return was.level == Level::Any || is.level == Level::Any;
}

/// Returns a result's class as the other run could tell it: only with a clearance, near is told
/// from separate.
ScenarioClass class_told(const ScenarioResult& result, const ScenarioResult& other) {
    return result.kind == ScenarioClass::Near && !other.has_clearance ? ScenarioClass::Separate
                                                                      : result.kind;
}

bool has_same_class(const ScenarioResult& was, const ScenarioResult& is) {
    return class_told(was, is) == class_told(is, was) ||
           (is_of_level_any(was, is) && is_surface_contact(was.kind) &&
            is_surface_contact(is.kind));
}

void add_count(TextBuffer& row,
               const ScenarioResult* result,
               std::uint64_t ScenarioResult::*count) {
    if (result != nullptr && result->level != Level::Any) {
        row.add(result->*count);
    }
}

/// Adds the distance of a result; nothing without one.
void add_distance(TextBuffer& row, const ScenarioResult* result) {
    if (result != nullptr && result->nearest) {
        row.add(result->nearest->distance);
    }
}

/// Returns the bits of the distance; nothing without one.
std::optional<std::uint64_t> distance_bits(const ScenarioResult& result) {
    return result.nearest ? std::optional(std::bit_cast<std::uint64_t>(result.nearest->distance))
                          : std::nullopt;
}

bool answer_for_distance(const ScenarioResult& was, const ScenarioResult& is) {
    return was.question == Question::Distance && is.question == Question::Distance;
}

bool is_free_throughout(const MotionOutcome& motion) {
    return !motion.event() && motion.end == MotionEnd::Free;
}

/// True if both motions ended alike, at the same times between their poses. The bracket of a way
/// out is not compared with that of a contact.
bool has_same_bracket(const ScenarioResult& was, const ScenarioResult& is) {
    if (!was.motion || !is.motion ||
        (was.motion->until == Until::Free) != (is.motion->until == Until::Free) ||
        (is_free_throughout(*was.motion) && is_free_throughout(*is.motion))) {
        return true;
    }
    const auto time = [](const MotionOutcome& motion, std::uint32_t instant) {
        return std::ldexp(instant, -static_cast<int>(motion.depth));
    };
    return was.motion->end == is.motion->end &&
           time(*was.motion, was.motion->t0) == time(*is.motion, is.motion->t0) &&
           time(*was.motion, was.motion->t1) == time(*is.motion, is.motion->t1);
}

bool answer_for_shots(const ScenarioResult& was, const ScenarioResult& is) {
    return was.question == Question::Shots && is.question == Question::Shots;
}

/// Returns line, depth and flags of each hit, sorted, so that triangles may have other numbers.
std::vector<std::tuple<std::uint32_t, double, std::uint8_t>> hits_of(const ScenarioResult& result) {
    std::vector<std::tuple<std::uint32_t, double, std::uint8_t>> hits;
    for (std::size_t i = 0; i < result.hits.size(); ++i) {
        hits.emplace_back(result.pairs[i].b, result.hits[i].depth, result.hits[i].flags);
    }
    std::ranges::sort(hits);
    return hits;
}

/// True if the same lines are hit in the same depths, as far as both results list them all.
bool has_same_hits(const ScenarioResult& was, const ScenarioResult& is) {
    const bool are_whole =
        was.level == Level::Pairs && is.level == Level::Pairs && !was.is_cut() && !is.is_cut();
    return !are_whole || hits_of(was) == hits_of(is);
}

} // namespace

std::string_view outcome_name(std::size_t outcome) {
    return outcome == no_result ? "none" : to_text(static_cast<ScenarioClass>(outcome));
}

ScenarioDiff::ScenarioDiff(std::optional<OutputFile> csv, ScenarioDiffOptions options)
    : csv_(std::move(csv)), options_(std::move(options)) {
    for (std::string& body : options_.bodies) {
        body = csv_field(body);
    }
}

/// Returns what differs between the results of a scenario in both runs; empty if nothing does.
std::string_view ScenarioDiff::change_of(const PairedResult& pair) const {
    if (pair.was == nullptr || pair.is == nullptr) {
        return pair.was == pair.is ? "" : "class";
    }
    const ScenarioResult& was = *pair.was;
    const ScenarioResult& is = *pair.is;
    if (!has_same_class(was, is)) {
        return "class";
    }
    if (!is_of_level_any(was, is) && was.pair_count != is.pair_count) {
        return "count";
    }
    if (answer_for_distance(was, is) && distance_bits(was) != distance_bits(is)) {
        return "distance";
    }
    if (!has_same_bracket(was, is)) {
        return "bracket";
    }
    if (was.has_clearance != is.has_clearance) {
        return "";
    }
    if (!is_of_level_any(was, is) && was.near_count != is.near_count) {
        return "near";
    }
    if (answer_for_shots(was, is) && !has_same_hits(was, is)) {
        return "hits";
    }
    return options_.compares_pairs && was.level == is.level && was.pairs != is.pairs ? "pairs" : "";
}

Status ScenarioDiff::add(const PairedResult& pair) {
    if (!pair.is_in_both()) {
        ++(pair.earlier ? counts_.only_earlier : counts_.only_later);
        return Done{};
    }
    ++counts_.in_both;
    counts_.apart += pair.earlier && pair.later ? 0 : 1;
    counts_.comparable += pair.is_comparable() ? 1 : 0;
    ++counts_.outcomes[outcome_of(pair.was)][outcome_of(pair.is)];
    const std::string_view change = change_of(pair);
    if (change.empty()) {
        return Done{};
    }
    ++counts_.changed;
    return csv_ ? write(pair, change) : Status(Done{});
}

Status ScenarioDiff::write(const PairedResult& pair, std::string_view change) {
    const ScenarioResult& some = pair.is != nullptr ? *pair.is : *pair.was;
    TextBuffer row;
    row.add(header_once());
    if (pair.later) {
        row.add(*pair.later);
    }
    row.add(",");
    if (pair.earlier) {
        row.add(*pair.earlier);
    }
    row.add(",",
            std::string_view(options_.bodies[some.body_a]),
            ",",
            std::string_view(options_.bodies[some.body_b]),
            ",",
            outcome_name(outcome_of(pair.was)),
            ",",
            outcome_name(outcome_of(pair.is)),
            ",");
    add_count(row, pair.was, &ScenarioResult::pair_count);
    row.add(",");
    add_count(row, pair.is, &ScenarioResult::pair_count);
    if (options_.has_near) {
        row.add(",");
        add_count(row, pair.was, &ScenarioResult::near_count);
        row.add(",");
        add_count(row, pair.is, &ScenarioResult::near_count);
    }
    if (options_.has_distance) {
        row.add(",");
        add_distance(row, pair.was);
        row.add(",");
        add_distance(row, pair.is);
    }
    row.add(",", change, "\n");
    return csv_->write(row.text());
}

/// Returns the header of the file before its first row, and nothing later.
std::string ScenarioDiff::header_once() {
    if (std::exchange(has_header_, true)) {
        return {};
    }
    return std::string("scenario,scenario_old,body_a,body_b,class_old,class,count_old,count,") +
           (options_.has_near ? "near_old,near," : "") +
           (options_.has_distance ? "distance_old,distance," : "") + "change\n";
}

Status ScenarioDiff::finish() {
    if (!csv_) {
        return Done{};
    }
    CD_TRY(csv_->write(header_once()));
    return csv_->commit();
}

} // namespace cd
