#include "client/export/scene_log.hpp"

#include "client/scene/coverage_text.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <string_view>
#include <utility>

namespace cd {

namespace {

std::vector<bool> fixed_bodies_of(const ExportContext& context) {
    std::vector<bool> fixed;
    for (const ExportBody& body : context.bodies) {
        fixed.push_back(body.is_fixed);
    }
    return fixed;
}

} // namespace

SceneLog::SceneLog(const ExportContext& context)
    : steps_(context.steps), sum_(context.steps, fixed_bodies_of(context)) {
    for (const ExportBody& body : context.bodies) {
        names_.push_back(body.name);
    }
}

Result<SceneLog> SceneLog::open(const ExportContext& context,
                                const std::optional<std::filesystem::path>& dir,
                                std::optional<std::uint64_t> learn) {
    CD_CHECK(context.steps != nullptr);
    SceneLog log(context);
    if (learn) {
        log.learned_.emplace(context.steps, *learn, log.names_);
    }
    if (dir) {
        auto episodes = CD_TRY(RowFile::create(
            *dir / "episodes.csv",
            "body_a,body_b,first_step,last_step,first_time,last_time,worst,worst_step,"
            "worst_scenario,worst_pairs\n"));
        log.episodes_file_.emplace(std::move(episodes));
        auto coverage = CD_TRY(
            RowFile::create(*dir / "coverage.csv", std::string(coverage_columns) + ",failed\n"));
        log.coverage_file_.emplace(std::move(coverage));
    }
    return log;
}

Status SceneLog::add(const ScenarioResult& result) {
    CD_TRY(add_steps_before(steps_->step_of(result.index)));
    failed_ += result.kind == ScenarioClass::Failed ? 1 : 0;
    if (learned_) {
        learned_->add(result);
    }
    return add_episodes(sum_.add(result));
}

Status SceneLog::finish() {
    CD_TRY(add_steps_before(steps_->steps()));
    CD_TRY(add_episodes(sum_.finish()));
    for (std::optional<RowFile>* file : {&episodes_file_, &coverage_file_}) {
        if (file->has_value()) {
            CD_TRY((*file)->commit());
        }
    }
    return Done{};
}

Status SceneLog::add_steps_before(std::uint64_t step) {
    for (; step_ < step; ++step_) {
        if (coverage_file_) {
            CD_TRY(coverage_file_->add(
                std::string_view(coverage_row(*steps_, step_)), ",", failed_, "\n"));
        }
        failed_ = 0;
    }
    return Done{};
}

Status SceneLog::add_episodes(const std::vector<BodyEpisode>& episodes) {
    for (const BodyEpisode& episode : episodes) {
        ++episodes_;
        if (!worst_ || episode.badness > worst_->badness) {
            worst_ = episode;
        }
        if (!episodes_file_) {
            continue;
        }
        CD_TRY(episodes_file_->add(std::string_view(csv_field(names_[episode.bodies.a])),
                                   ",",
                                   std::string_view(csv_field(names_[episode.bodies.b])),
                                   ",",
                                   episode.first_step,
                                   ",",
                                   episode.last_step,
                                   ",",
                                   steps_->time_of(episode.first_step),
                                   ",",
                                   steps_->time_of(episode.last_step),
                                   ",",
                                   to_text(episode.worst),
                                   ",",
                                   steps_->step_of(episode.worst_scenario),
                                   ",",
                                   episode.worst_scenario,
                                   ",",
                                   episode.badness.pairs,
                                   "\n"));
    }
    return Done{};
}

SceneFindings SceneLog::findings() const {
    SceneFindings findings;
    findings.steps = steps_->steps();
    for (const StepCoverage& step : steps_->coverage()) {
        findings.coverage += step;
    }
    findings.episodes = episodes_;
    if (worst_) {
        findings.worst = EpisodeFound{names_[worst_->bodies.a],
                                      names_[worst_->bodies.b],
                                      worst_->first_step,
                                      worst_->last_step,
                                      worst_->worst};
    }
    if (learned_) {
        findings.learned_step = learned_->step();
        findings.learned = learned_->text();
    }
    return findings;
}

} // namespace cd
