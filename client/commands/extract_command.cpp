// The verb `extract`: turns scenarios of a run into a separate job, pictures or 3D scenes.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/export/contact_scene.hpp"
#include "client/folder/extracted_case.hpp"
#include "client/folder/extracted_scenes.hpp"
#include "client/folder/motion_case.hpp"
#include "client/folder/opened_run.hpp"
#include "client/folder/scene_pair.hpp"
#include "client/picture/body_picture.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/words.hpp"
#include "common/job/answer_poses.hpp"
#include "common/job/result/drawn_witness.hpp"

#include <cstdio>
#include <filesystem>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_max = 100'000; ///< In a case, since results are in memory.

struct Range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

/// Parses a range of scenarios, "N" or "N-M". Errors: BadInput.
Result<Range> parse_range(const std::string& text, std::uint64_t count) {
    const std::size_t dash = text.find('-');
    const auto first = number_in<std::uint64_t>(std::string_view(text).substr(0, dash));
    const auto last = dash == std::string::npos
                          ? first
                          : number_in<std::uint64_t>(std::string_view(text).substr(dash + 1));
    if (!first || !last || *last < *first) {
        return bad_input("\"" + text + "\" is no scenario: give its number, or first-last");
    }
    if (*last >= count) {
        return bad_input("the run has the scenarios 0 to " + std::to_string(count - 1));
    }
    if (*last - *first >= scenarios_max) {
        return bad_input("a case has at most " + grouped(scenarios_max) + " scenarios");
    }
    return Range{*first, *last};
}

/// Reads scenarios and their results. Motions are at rest under the poses of their answers.
Result<CaseScenarios> read_case(OpenedRun& run, PreparedJob& job, const Range& range) {
    CaseScenarios found;
    found.scenarios = CD_TRY(job.poses->read(range.first, range.last - range.first + 1));
    for (std::uint64_t index = range.first; index <= range.last; ++index) {
        const auto record = CD_TRY(run.records().find(index));
        if (!record) {
            return Error{ErrorCode::Incomplete,
                         "the run has no result of scenario " + std::to_string(index)};
        }
        found.results.push_back(record->result);
        Scenario& scenario = found.scenarios[index - range.first];
        scenario = at_answer(scenario, record->result);
    }
    return found;
}

/// Draws a picture of each scenario: DIR/N.png.
Status write_pictures(const PreparedJob& job,
                      const CaseScenarios& found,
                      std::uint64_t first,
                      const std::filesystem::path& dir) {
    CD_TRY(make_directories(dir));
    for (std::size_t i = 0; i < found.scenarios.size(); ++i) {
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        const Scenario& scenario = found.scenarios[i];
        ScenarioResult result = found.results[i];
        list_witness(result);
        const auto bodies = pictured(*job.meshes[scenario.body_a],
                                     *job.meshes[scenario.body_b],
                                     scenario.poses,
                                     result.pairs);
        const Image image = draw_contacts(bodies, {}, gap_lines(result));
        const std::filesystem::path path = dir / (std::to_string(first + i) + ".png");
        CD_TRY(write_png(image, path));
    }
    return Done{};
}

/// Writes scenarios of a job of two bodies as 3D scenes or as a case.
Result<int> write_of_two(const ExtractCommand& command,
                         PreparedJob& job,
                         CaseScenarios& found,
                         const std::string& dir,
                         ThreadPool& pool) {
    const std::size_t count = found.results.size();
    TreeCache cache(tree_cache_folder(command.tree_cache));
    if (command.as != "case") {
        const SceneFormat format = command.as == "vtp" ? SceneFormat::Vtp : SceneFormat::Glb;
        CD_TRY(write_scenes(job, found, format, dir, cache, pool, &InterruptGuard::has_come));
        std::printf("%s in %s\n", counted(count, "scene").c_str(), dir.c_str());
        return exit_done;
    }
    CD_TRY(rest_at_answers(job, found, cache, pool, &InterruptGuard::has_come));
    CD_TRY(write_case(job, found, {command.minimal, &InterruptGuard::has_come}, dir, pool));
    std::printf("%s: cdctl run %s/job.toml\n", counted(count, "scenario").c_str(), dir.c_str());
    return exit_done;
}

} // namespace

Result<int> perform(const ExtractCommand& command) {
    if (command.minimal && command.as != "case") {
        return bad_input("--minimal belongs to --as case; leave it out");
    }
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    ThreadPool pool(command.threads);
    auto [run, job, map] =
        CD_TRY(open_run_at_hand(command.run, command.master, command.tree_cache, {}, pool));
    if (command.as == "case") {
        CD_TRY(check_exact(run.manifest()));
    }
    const Range range = CD_TRY(parse_range(command.scenarios, job.poses->count()));
    CaseScenarios found = CD_TRY(read_case(run, job, range));
    InterruptGuard::begin_to_flag(); // From here on, a signal must not leave partial files.
    const std::string dir = command.out.empty() ? "scenario-" + command.scenarios : command.out;
    const std::size_t count = found.results.size();
    if (command.as == "png") {
        CD_TRY(write_pictures(job, found, range.first, dir));
        std::printf("%s in %s\n", counted(count, "picture").c_str(), dir.c_str());
        return exit_done;
    }
    if (job.scene) {
        auto pair = CD_TRY(pair_of_scene(job, found));
        return write_of_two(command, pair.job, pair.scenarios, dir, pool);
    }
    return write_of_two(command, job, found, dir, pool);
}

} // namespace cd
