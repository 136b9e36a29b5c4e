#include "client/folder/extracted_scenes.hpp"

#include "client/base/units.hpp"
#include "client/export/contact_scene.hpp"
#include "client/export/vtp_file.hpp"
#include "client/formats/output_file.hpp"
#include "client/trees/body_trees.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/job/answer_poses.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// Runs scenarios of a job for drawing: all pairs, or the nearest pair of a known distance, with
/// their points.
class SceneRunner {
  public:
    SceneRunner(const PreparedJob& job, TreeCache& cache, ThreadPool& pool, const StopCheck& stop)
        : trees_(make_body_trees(job.meshes, {}, cache, pool)), of_run_(job.query) {
        query_.level = Level::Contacts;
        query_.ignored = job.query.ignored;
        query_.clearance = job.query.clearance;
        options_.stop = stop;
    }

    /// Runs a scenario. Errors: Interrupted; BadInput if the result contradicts the run's.
    [[nodiscard]] Result<ScenarioResult> run(const Scenario& scenario,
                                             const ScenarioResult& known) {
        const SubtreePair whole{trees_[0]->view(), trees_[1]->view()};
        const Query& query = known.nearest ? of_run_ : query_;
        KeptSearch& kept = known.nearest ? nearest_ : contacts_;
        ScenarioRun done =
            run_on_subtrees(kept, {&whole, 1}, at_answer(scenario, known), query, options_);
        if (done.is_stopped) {
            return interrupted();
        }
        if (done.result.kind == ScenarioClass::Failed) {
            return bad_input(done.result.failure);
        }
        if (!agrees(done.result, known)) {
            return bad_input("scenario " + std::to_string(scenario.index) +
                             " has other contacts here than in the run; `cdctl verify` tells "
                             "whether the run is right");
        }
        list_witness(done.result);
        return std::move(done.result);
    }

  private:
    /// Compares with the run's result, as far as the run's query asked for all pairs exactly, or
    /// for the distance.
    [[nodiscard]] bool agrees(const ScenarioResult& drawn, const ScenarioResult& known) const {
        if (known.nearest != drawn.nearest) {
            return false;
        }
        const bool says_pairs = of_run_.level != Level::Any && !of_run_.first_hits &&
                                known.kind != ScenarioClass::Undecided &&
                                known.kind != ScenarioClass::Failed;
        return !says_pairs ||
               (drawn.pair_count == known.pair_count && drawn.near_count == known.near_count &&
                known.pairs.size() <= drawn.pairs.size() &&
                std::ranges::equal(known.pairs, std::span(drawn.pairs).first(known.pairs.size())));
    }

    std::vector<std::shared_ptr<const ObbTree>> trees_;
    const Query& of_run_;
    Query query_;
    RunOptions options_;
    KeptSearch contacts_; ///< Searches of `query_`.
    KeptSearch nearest_;  ///< Searches of `of_run_`.
};

/// Writes the files of a series for ParaView.
class SceneSeries {
  public:
    /// `names` are those of the bodies' files, without endings.
    SceneSeries(const std::vector<Scenario>& scenarios,
                std::array<std::string, 2> names,
                fs::path dir,
                StopCheck stop)
        : names_(std::move(names)), dir_(std::move(dir)), stop_(std::move(stop)) {
        const PosePair& first = scenarios.front().poses;
        stands_ = {
            std::ranges::all_of(scenarios, [&](const Scenario& s) { return s.poses.a == first.a; }),
            std::ranges::all_of(scenarios,
                                [&](const Scenario& s) { return s.poses.b == first.b; })};
    }

    [[nodiscard]] Status add(const ContactScene& scene, std::uint64_t scenario) {
        const std::string number = "-" + std::to_string(scenario);
        VtpStep step{scenario, {}};
        for (std::size_t body = 0; body < names_.size(); ++body) {
            if (stands_[body] && !steps_.empty()) {
                step.files.push_back(steps_.front().files[body]);
                continue;
            }
            step.files.push_back(new_file(names_[body] + (stands_[body] ? "" : number)));
            CD_TRY(write_scene_body(scene, body, dir_ / step.files.back(), stop_));
        }
        step.files.push_back(new_file("contacts" + number));
        CD_TRY(write_scene_contacts(scene, dir_ / step.files.back(), stop_));
        steps_.push_back(std::move(step));
        return Done{};
    }

    [[nodiscard]] Status finish() const {
        return write_file(dir_ / "scenarios.pvd", pvd_text(steps_));
    }

  private:
    /// Returns a name of a file that the series does not have yet: a body may be named `b-7`.
    std::string new_file(std::string name) {
        while (!taken_.insert(name).second) {
            name += "_";
        }
        return name + ".vtp";
    }

    std::array<std::string, 2> names_;
    fs::path dir_;
    StopCheck stop_;
    std::set<std::string> taken_;
    std::array<bool, 2> stands_{}; ///< Which bodies have one pose in all scenarios.
    std::vector<VtpStep> steps_;
};

} // namespace

Status write_scenes(const PreparedJob& job,
                    const CaseScenarios& given,
                    SceneFormat format,
                    const fs::path& dir,
                    TreeCache& cache,
                    ThreadPool& pool,
                    const StopCheck& stop) {
    CD_TRY(make_directories(dir));
    SceneRunner runner(job, cache, pool, stop);
    const auto names = body_file_names(job);
    SceneSeries series(given.scenarios, names, dir, stop);
    const double metres = unit_factor(job.spec.unit, "m").value_or(1);
    for (std::size_t i = 0; i < given.scenarios.size(); ++i) {
        const Scenario& scenario = given.scenarios[i];
        const ScenarioResult result = CD_TRY(runner.run(scenario, given.results[i]));
        const ContactScene scene =
            make_contact_scene({SceneBody{export_name(job.spec, 0), job.meshes[0], {}, {}},
                                SceneBody{export_name(job.spec, 1), job.meshes[1], {}, {}}},
                               scenario,
                               result);
        const std::string number = std::to_string(scenario.index);
        CD_TRY(format == SceneFormat::Glb
                   ? write_scene_glb(scene, metres, dir / (number + ".glb"), stop)
                   : series.add(scene, scenario.index));
    }
    return format == SceneFormat::Vtp ? series.finish() : Status(Done{});
}

} // namespace cd
