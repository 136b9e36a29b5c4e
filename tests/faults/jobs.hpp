// The jobs that simulations submit, and their right results.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/job/scenario.hpp"
#include "common/search/contact_pair.hpp"
#include "master/geometry/geometry_store.hpp"
#include "proto/messages/client_messages.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd::tests {

struct KnownJob {
    Submit submit; ///< Without cluster options.
    std::vector<Scenario> scenarios;
    std::vector<Sha256> digests; ///< Digest of each scenario's right result.
    /// Pairs of each scenario if its contacts are summed.
    std::vector<std::vector<ContactPair>> pairs;
    std::shared_ptr<const BodyPartRuns> parts; ///< Of the bodies.
};

/// Returns jobs that are made once per process.
[[nodiscard]] std::span<const KnownJob> known_jobs();
[[nodiscard]] const KnownJob& known_job(const std::string& name);
/// Returns a job with several scenarios for each of some hundred workers, made on first use.
[[nodiscard]] const KnownJob& large_job();
/// Returns the store with all jobs' geometry. It outlives every simulation.
[[nodiscard]] GeometryStore& known_geometry();

class World;
/// Deletes or damages block files and drops them from memory, so that readers must make them again.
void lose_known_blocks(World& world);
/// Restores all blocks after a simulation.
void keep_known_blocks();

/// Returns the digest of the failure result of a scenario that kills every worker.
[[nodiscard]] Sha256 digest_of_lost(const KnownJob& job, std::uint64_t scenario);

} // namespace cd::tests
