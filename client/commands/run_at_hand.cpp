#include "client/commands/run_at_hand.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/temporary_folder.hpp"
#include "client/cluster/fetched_job.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/scene/rule_pattern.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace cd {

namespace {

/// A run and its inputs, which stay valid when its folder is removed.
struct RunWithInputs {
    OpenedRun run;
    JobInputs inputs;
    std::optional<ContactMap> map;
};

Result<RunWithInputs>
open_folder(const std::filesystem::path& dir, bool reads_map, const ReadInputs& read) {
    auto run = CD_TRY(OpenedRun::open(dir));
    auto inputs = CD_TRY(read(run));
    std::optional<ContactMap> map;
    if (reads_map) {
        map = CD_TRY(run.kept_map());
    }
    return RunWithInputs{std::move(run), std::move(inputs), std::move(map)};
}

Result<RunWithInputs> fetch(const std::string& id,
                            const MasterOptions& master,
                            const std::string& tree_cache,
                            bool reads_map,
                            const ReadInputs& read) {
    const auto folder = CD_TRY(TemporaryFolder::make("cdctl"));
    auto connected = CD_TRY(open_job_of_argument(master, id));
    auto job = CD_TRY(FetchedJob::open(std::move(connected), tree_cache_folder(tree_cache)));
    job.prepared().spec.output.dir = folder.path();
    job.prepared().spec.output.formats.clear();
    FolderRunOptions options = folder_options({}, master);
    options.inputs_bytes_max = UINT64_MAX; // No limit, since there is no other local copy.
    CD_TRY(job.write(std::move(options), "text"));
    return open_folder(folder.path(), reads_map, read);
}

Result<RunWithInputs> open_or_fetch(const std::string& argument,
                                    const MasterOptions& master,
                                    const std::string& tree_cache,
                                    bool reads_map,
                                    const ReadInputs& read) {
    if (is_folder(argument)) {
        return open_folder(argument, reads_map, read);
    }
    InterruptGuard::begin_to_flag();
    auto run = fetch(argument, master, tree_cache, reads_map, read);
    InterruptGuard::begin_to_end();
    return run;
}

bool is_same_rule(const SceneRule& left, const SceneRule& right) {
    return left.ignores == right.ignores && left.one == right.one && left.other == right.other;
}

bool is_about_parts(const SceneRule& rule) {
    return RulePattern::from_text(rule.one).has_part() ||
           RulePattern::from_text(rule.other).has_part();
}

bool has_same_group(const SceneBodySpec& left, const SceneBodySpec& right) {
    return left.name == right.name && left.group == right.group;
}

/// True if two runs of the same bodies ignore the same pairs of bodies. What rules about parts
/// ignore depends on the meshes.
bool have_same_rules(const RunAtHand& earlier, const RunAtHand& later) {
    const SceneSpec& was = *earlier.job.spec.scene;
    const SceneSpec& is = *later.job.spec.scene;
    const bool have_equal_meshes = std::ranges::equal(earlier.run.manifest().bodies,
                                                      later.run.manifest().bodies,
                                                      {},
                                                      &ManifestBody::mesh,
                                                      &ManifestBody::mesh);
    return std::ranges::equal(was.rules.order, is.rules.order, &is_same_rule) &&
           std::ranges::equal(was.bodies, is.bodies, &has_same_group) &&
           (have_equal_meshes || std::ranges::none_of(is.rules.order, &is_about_parts));
}

ApartPairs apart_pairs_of(const RunAtHand& run, bool has_rules_of_other) {
    const JobScene& scene = *run.job.scene;
    return {scene.steps, scene.are_fixed, run.job.query, has_rules_of_other};
}

} // namespace

std::optional<std::array<ApartPairs, 2>> apart_pairs(const RunAtHand& earlier,
                                                     const RunAtHand& later) {
    if (!earlier.job.scene || !later.job.scene) {
        return std::nullopt;
    }
    const bool have_rules = have_same_rules(earlier, later);
    return std::array{apart_pairs_of(earlier, have_rules), apart_pairs_of(later, have_rules)};
}

Result<RunAtHand> open_run_at_hand(const std::string& argument,
                                   const MasterOptions& master,
                                   const std::string& tree_cache,
                                   RunNeeds needs,
                                   ThreadPool& pool,
                                   const ReadInputs& read) {
    auto [run, inputs, map] = CD_TRY(open_or_fetch(argument, master, tree_cache, needs.map, read));
    auto spec = CD_TRY(run.spec());
    TreeCache cache(tree_cache_folder(tree_cache));
    auto job = CD_TRY(prepare_again(
        run.manifest(), std::move(inputs), std::move(spec), needs.trees, cache, pool));
    return RunAtHand{std::move(run), std::move(job), std::move(map)};
}

} // namespace cd
