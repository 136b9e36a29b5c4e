#include "client/document/scene_sections.hpp"

#include "client/scene/coverage_text.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <tuple>

namespace cd {

namespace {

constexpr std::size_t episodes_max = 50; ///< In the table.

} // namespace

SceneSections::SceneSections(const PreparedJob& job)
    : names_(job.names),
      steps_(job.scene->steps),
      has_lines_(job.query.question == Question::Shots) {}

Result<SceneSections>
SceneSections::read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop) {
    SceneSections sections(job);
    EpisodeSum sum(job.scene->steps, job.scene->are_fixed);
    CD_TRY(records.for_each([&](const RecordView& record) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        sections.failed_ += record.result.kind == ScenarioClass::Failed ? 1 : 0;
        sections.add(sum.add(record.result));
        return Done{};
    }));
    sections.add(sum.finish());
    sections.keep_worst();
    return sections;
}

void SceneSections::add(const std::vector<BodyEpisode>& episodes) {
    count_ += episodes.size();
    worst_.insert(worst_.end(), episodes.begin(), episodes.end());
    if (worst_.size() > 100 * episodes_max) {
        keep_worst();
    }
}

void SceneSections::keep_worst() {
    std::ranges::sort(worst_, [](const BodyEpisode& left, const BodyEpisode& right) {
        return std::tie(right.badness, left.worst_scenario) <
               std::tie(left.badness, right.worst_scenario);
    });
    worst_.resize(std::min(worst_.size(), episodes_max));
}

Html SceneSections::section() const {
    StepCoverage sum;
    for (const StepCoverage& step : steps_->coverage()) {
        sum += step;
    }
    Html content = paragraph(counted(steps_->steps(), "step") + ": " + coverage_line(sum) + ", " +
                             grouped(failed_) + " failed.");
    if (!has_lines_) {
        content += table();
    }
    return html_section(has_lines_ ? "Bodies and bundles" : "Episodes", content);
}

Html SceneSections::table() const {
    if (count_ == 0) {
        return paragraph("No two bodies are in contact or near at any step.");
    }
    std::vector<std::vector<Html>> rows{
        html_texts({"bodies", "steps", "from t", "to t", "worst", "in", "pairs"})};
    for (const BodyEpisode& episode : worst_) {
        rows.push_back(html_texts(
            {short_name(names_[episode.bodies.a]) + " x " + short_name(names_[episode.bodies.b]),
             grouped(episode.first_step) + " to " + grouped(episode.last_step),
             exact_text(steps_->time_of(episode.first_step)),
             exact_text(steps_->time_of(episode.last_step)),
             std::string(to_text(episode.worst)),
             "#" + std::to_string(episode.worst_scenario),
             grouped(episode.badness.pairs)}));
    }
    Html content = paragraph(
        "An episode is a run of steps at which two bodies are in contact, or near with a "
        "clearance. " +
        (count_ > worst_.size() ? "These are the worst " + std::to_string(worst_.size()) + " of " +
                                      counted(count_, "episode") + "; episodes.csv has all."
                                : "The worst is first."));
    content += html_table(rows, "groups");
    return content;
}

} // namespace cd
