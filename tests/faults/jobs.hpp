// The jobs that simulations submit, and the truth about them.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/job/scenario.hpp"
#include "common/search/contact_pair.hpp"
#include "master/geometry/geometry_store.hpp"
#include "proto/messages/client_messages.hpp"

#include <span>
#include <string>
#include <vector>

namespace cd::tests {

struct KnownJob {
    Submit submit; ///< Without cluster options.
    std::vector<Scenario> scenarios;
    std::vector<Sha256> digests; ///< Of the right result of each.
    /// The pairs of each, where the query is for maps.
    std::vector<std::vector<ContactPair>> pairs;
};

/// Made once in a program.
[[nodiscard]] std::span<const KnownJob> known_jobs();
[[nodiscard]] const KnownJob& known_job(const std::string& name);
/// One more, with several scenarios for each of some hundred workers. Made when it is first asked
/// for.
[[nodiscard]] const KnownJob& large_job();
/// With the geometry of all of them. Outlives every simulation.
[[nodiscard]] GeometryStore& known_geometry();

class World;
/// Files of blocks are gone, or damaged, and nobody has them in memory: who wants them makes them
/// again.
void lose_known_blocks(World& world);
/// After a simulation: all is as it was made.
void keep_known_blocks();

/// What becomes of a scenario that no worker survives.
[[nodiscard]] Sha256 digest_of_lost(const KnownJob& job, std::uint64_t scenario);

} // namespace cd::tests
