// The run that an argument names: a results folder or a job on a master.
#pragma once

#include "client/cli/cli.hpp"
#include "client/compare/paired_results.hpp"
#include "client/compare/scenario_match.hpp"
#include "client/folder/opened_run.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace cd {

/// A run, and its job prepared as it was submitted. A job on a master was fetched into a temporary
/// folder, which has already been removed.
struct RunAtHand {
    OpenedRun run;
    PreparedJob job;
    std::optional<ContactMap> map; ///< The contact map that the folder keeps, if `RunNeeds::map`.

    /// Returns the scenarios, to match them with those of another run.
    [[nodiscard]] MatchedRun matched() const {
        return {*job.poses, job.labels, job.scene.has_value()};
    }
    /// Returns the sums by part of a run that lists no pairs; null for other runs.
    [[nodiscard]] const PartContacts* sums() const {
        return job.query.level < Level::Pairs && map ? &map->parts : nullptr;
    }
};

/// Returns which pairs of bodies each of two runs leaves out because their boxes are apart; nothing
/// unless both are scenes.
[[nodiscard]] std::optional<std::array<ApartPairs, 2>> apart_pairs(const RunAtHand& earlier,
                                                                   const RunAtHand& later);

/// The contents of a run that a verb needs beside its records and inputs.
struct RunNeeds {
    Trees trees = Trees::ForPosesOnly;
    bool map = false; ///< Reads the contact map.
};

/// Reads the inputs of a run, which stay valid when its folder is removed.
using ReadInputs = std::function<Result<JobInputs>(const OpenedRun&)>;

/// Opens a folder, or fetches a job into a temporary folder, which is removed even after a signal.
/// Needs an `InterruptGuard`; after the fetch, a signal ends the process. `tree_cache` is the value
/// of --tree-cache; `read` reads the inputs. Errors: as `OpenedRun`, `read`, `FetchedJob` and
/// `prepare_again`; with `RunNeeds::map`, `OpenedRun::kept_map`.
[[nodiscard]] Result<RunAtHand> open_run_at_hand(const std::string& argument,
                                                 const MasterOptions& master,
                                                 const std::string& tree_cache,
                                                 RunNeeds needs,
                                                 ThreadPool& pool,
                                                 const ReadInputs& read = &read_inputs);

} // namespace cd
