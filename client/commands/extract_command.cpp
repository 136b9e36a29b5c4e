// The verb `extract`: turns scenarios of a run into a separate job, or into pictures.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/words.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/folder/extracted_case.hpp"
#include "client/folder/opened_run.hpp"
#include "client/picture/body_picture.hpp"
#include "common/core/host/stop_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_max = 100'000; ///< Per case, since results are in memory.

struct Range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
};

std::optional<std::uint64_t> whole_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

/// Parses "N" or "N-M".
Result<Range> parse_range(const std::string& text, std::uint64_t count) {
    const std::size_t dash = text.find('-');
    const auto first = whole_number(std::string_view(text).substr(0, dash));
    const auto last =
        dash == std::string::npos ? first : whole_number(std::string_view(text).substr(dash + 1));
    if (!first || !last || *last < *first) {
        return Error{ErrorCode::BadInput,
                     "\"" + text + "\" is no scenario: give its number, or first-last"};
    }
    if (*last >= count) {
        return Error{ErrorCode::BadInput,
                     "the run has the scenarios 0 to " + std::to_string(count - 1)};
    }
    if (*last - *first >= scenarios_max) {
        return Error{ErrorCode::BadInput,
                     "a case has at most " + grouped(scenarios_max) + " scenarios"};
    }
    return Range{*first, *last};
}

Result<CaseScenarios> read_case(OpenedRun& run, PreparedJob& job, const Range& range) {
    CaseScenarios found;
    auto scenarios = job.poses->read(range.first, range.last - range.first + 1);
    if (!scenarios) {
        return scenarios.error();
    }
    found.scenarios = std::move(scenarios.value());
    for (std::uint64_t index = range.first; index <= range.last; ++index) {
        const auto record = run.records().find(index);
        if (!record) {
            return record.error();
        }
        if (!record.value()) {
            return Error{ErrorCode::Incomplete,
                         "the run has no result of scenario " + std::to_string(index)};
        }
        found.results.push_back(record.value()->result);
    }
    return found;
}

/// The bodies of a scenario in their poses, with the triangles of the result's pairs as contacts.
std::vector<PicturedBody>
pictured(const PreparedJob& job, const Scenario& scenario, const ScenarioResult& result) {
    constexpr std::array<Colour, 2> colours{{{150, 170, 200}, {225, 190, 120}}};
    std::vector<PicturedBody> bodies{
        {job.meshes[scenario.body_a].get(), scenario.poses.a, colours[0], {}},
        {job.meshes[scenario.body_b].get(), scenario.poses.b, colours[1], {}}};
    for (const ContactPair& pair : result.pairs) {
        bodies[0].contacts.push_back(pair.a);
        bodies[1].contacts.push_back(pair.b);
    }
    for (PicturedBody& body : bodies) {
        std::ranges::sort(body.contacts);
        body.contacts.erase(std::ranges::unique(body.contacts).begin(), body.contacts.end());
    }
    return bodies;
}

/// Draws a picture of each scenario: DIR/N.png.
Status write_pictures(const PreparedJob& job,
                      const CaseScenarios& found,
                      std::uint64_t first,
                      const std::filesystem::path& dir) {
    std::error_code failed;
    std::filesystem::create_directories(dir, failed);
    if (failed) {
        return Error{ErrorCode::Io, dir.string() + ": " + failed.message()};
    }
    for (std::size_t i = 0; i < found.scenarios.size(); ++i) {
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        const Image image = draw_contacts(pictured(job, found.scenarios[i], found.results[i]));
        const std::filesystem::path path = dir / (std::to_string(first + i) + ".png");
        if (Status written = write_png(image, path); !written) {
            return written;
        }
    }
    return Done{};
}

} // namespace

int execute(const ExtractCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    const std::filesystem::path tree_cache = tree_cache_folder(command.tree_cache);
    auto at_hand = RunAtHand::open(command.run, command.master, tree_cache);
    if (!at_hand) {
        return fail(at_hand.error());
    }
    OpenedRun& run = at_hand.value().run;
    const auto range = parse_range(command.scenarios, run.manifest().poses.count);
    if (!range) {
        return fail(range.error());
    }
    ThreadPool pool(command.threads);
    TreeCache cache(tree_cache);
    auto job = at_hand.value().prepare(Trees::ForPosesOnly, cache, pool);
    if (!job) {
        return fail(job.error());
    }
    const auto found = read_case(run, job.value(), range.value());
    if (!found) {
        return fail(found.error());
    }
    InterruptGuard::begin_to_flag(); // A signal must not leave partial files.
    const std::string dir = command.out.empty() ? "scenario-" + command.scenarios : command.out;
    if (command.as == "png") {
        const Status drawn = write_pictures(job.value(), found.value(), range.value().first, dir);
        if (!drawn) {
            return fail(drawn.error());
        }
        const std::size_t count = found.value().results.size();
        std::printf("%s in %s\n", counted(count, "picture").c_str(), dir.c_str());
        return exit_done;
    }
    const Status written = write_case(
        job.value(), found.value(), {command.minimal, &InterruptGuard::has_come}, dir, pool);
    if (!written) {
        return fail(written.error());
    }
    std::printf("%s: cdctl run %s/job.toml\n",
                counted(found.value().results.size(), "scenario").c_str(),
                dir.c_str());
    return exit_done;
}

} // namespace cd
