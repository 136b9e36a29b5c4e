#include "client/document/motion/motion_sections.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cd {

namespace {

bool is_proven_free(const ScenarioResult& result) {
    return result.kind != ScenarioClass::Undecided && !result.motion->event();
}

std::string length_text(double value, const std::string& unit) {
    return fmt::format("{:.6g} {}", value, unit);
}

/// Names what happens first, as the subject of a sentence.
std::string subject_of(FirstEvent::Kind kind) {
    switch (kind) {
    case FirstEvent::Kind::Near:
        return "The bodies are first near ";
    case FirstEvent::Kind::Contact:
        return "The first contact is ";
    case FirstEvent::Kind::Free:
        return "The bodies are first free ";
    }
    return {};
}

} // namespace

MotionSections::MotionSections(const PreparedJob& job, MotionTimes times)
    : unit_(job.spec.unit),
      until_(job.query.motion ? std::optional(job.query.motion->until) : std::nullopt),
      shows_all_(job.poses->count() <= lines_max),
      times_(std::move(times)) {}

Result<MotionSections>
MotionSections::read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop) {
    MotionSections sections(job, export_context(job).times);
    CD_TRY(records.for_each([&](const RecordView& record) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        return record.result.motion ? sections.add(record.result, job) : Status(Done{});
    }));
    return sections;
}

Status MotionSections::add(const ScenarioResult& result, const PreparedJob& job) {
    ++motions_;
    keep_first(times_.event(result), first_);
    if (result.kind == ScenarioClass::Undecided) {
        ++undecided_;
        if (!open_ || result.distance_bound > open_->bound) {
            open_ = Open{result.index, result.distance_bound};
        }
    }
    if (!shows_all_ && is_proven_free(result)) {
        return Done{};
    }
    ++told_;
    if (lines_.size() == lines_max) {
        return Done{};
    }
    const MotionOutcome& motion = *result.motion;
    lines_.push_back({result.index,
                      {times_.at(result, 0), times_.at(result, 1u << motion.depth)},
                      TimeStrip(motion, is_near_event(result)),
                      text(result),
                      CD_TRY(moved_text(result, job))});
    return Done{};
}

/// Says how far B's origin is from where it began when the bodies are free. Its way is straight, so
/// this is how far it has moved. Empty unless A rests and a way out is known.
Result<std::string> MotionSections::moved_text(const ScenarioResult& result,
                                               const PreparedJob& job) const {
    const auto event = times_.event(result);
    if (!event || event->kind != FirstEvent::Kind::Free) {
        return std::string();
    }
    const auto scenarios = CD_TRY(job.poses->read(result.index, 1));
    const Scenario& scenario = scenarios.front();
    if (!scenario.to || scenario.poses.a != scenario.to->a) {
        return std::string();
    }
    const Vec3 way = scenario.to->b.translation() - scenario.poses.b.translation();
    const auto after = [&](std::uint32_t instant) {
        return way.norm() * std::ldexp(instant, -static_cast<int>(result.motion->depth));
    };
    return fmt::format(
        "{:.6g} to {}", after(result.motion->t0), length_text(after(result.motion->t1), unit_));
}

std::string MotionSections::text(const ScenarioResult& result) const {
    const std::string known = times_.text(result);
    if (result.kind != ScenarioClass::Undecided || std::isinf(result.distance_bound)) {
        return known;
    }
    return known + (known.empty() ? "" : ", ") + "open where at most " +
           length_text(result.distance_bound, unit_) + " apart";
}

std::string MotionSections::verdict(const RunNames& names) const {
    std::string words;
    if (first_) {
        words = subject_of(first_->kind) + time_text(*first_) + ", in " +
                names.name_of(first_->scenario) + ".";
    } else if (until_ == Until::Free) {
        words = "No motion leads from contact to where the bodies are free.";
    }
    const std::string rest = open_text(names);
    return words + (words.empty() || rest.empty() ? "" : " ") + rest;
}

/// Says how near the bodies may come in the parts of the time that are open.
std::string MotionSections::open_text(const RunNames& names) const {
    if (!open_) {
        return {};
    }
    const std::string of = names.name_of(open_->scenario);
    const std::string words =
        counted(undecided_, "motion") + (undecided_ == 1 ? " is" : " are") + " undecided: ";
    return words + (std::isinf(open_->bound)
                        ? "the search of " + of + " ended before its time did."
                        : "in open parts of the time the bodies come within " +
                              length_text(open_->bound, unit_) +
                              " of each other; the largest bound is that of " + of + ".");
}

/// Explains the lines, and says which are shown.
std::string MotionSections::about() const {
    std::string text = "The time of each motion from begin to end. Grey is proven free, violet is "
                       "open. From the first to the last instant of an open part that is known to "
                       "be in contact it is red, or orange where the bodies are only near. White "
                       "was not searched.";
    if (shows_all_) {
        return text;
    }
    text += " Of " + counted(motions_, "motion") + ", " + grouped(motions_ - told_) +
            (until_ == Until::Free ? " are free when they begin" : " are free throughout") +
            " and have no line.";
    return told_ <= lines_.size()
               ? text
               : text + " The first " + grouped(lines_.size()) + " of the others are shown.";
}

Html MotionSections::lines(const RunNames& names) const {
    if (motions_ == 0) {
        return {};
    }
    Html content = paragraph(about());
    if (lines_.empty()) {
        return html_section("Motions", content);
    }
    const bool has_way_out = until_ == Until::Free;
    std::vector<std::string> head{"scenario", "from t", "time line", "to t", "proven"};
    if (has_way_out) {
        head.emplace_back("B moves until free");
    }
    std::vector<std::vector<Html>> rows{html_texts(head)};
    for (const Line& line : lines_) {
        rows.push_back({Html::text(names.name_of(line.scenario)),
                        Html::text(exact_text(line.span[0])),
                        line.strip.svg(),
                        Html::text(exact_text(line.span[1])),
                        Html::text(line.text)});
        if (has_way_out) {
            rows.back().push_back(Html::text(line.moved));
        }
    }
    content += html_table(rows, "motions");
    return html_section("Motions", content);
}

} // namespace cd
