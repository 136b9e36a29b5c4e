// What differs between the inputs of two runs: bodies, poses, query.
#pragma once

#include "client/folder/run_manifest.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/query.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cd {

/// A mesh as far as it is compared.
struct ComparedBody {
    Sha256 mesh;
    std::vector<std::string> parts;
};

/// How a body differs between two runs. Parts are compared by name; of parts with equal names each
/// counts.
struct BodyChange {
    std::string name; ///< "A" or "B"; in a scene the body's name.
    bool is_changed = false;
    std::uint64_t parts = 0;      ///< Parts of the later run's body.
    std::uint64_t parts_new = 0;  ///< Parts that only the later run's body has.
    std::uint64_t parts_gone = 0; ///< Parts that only the earlier run's body has.
};

/// Which parts of the query decide whether two runs are comparable.
enum class QueryUse : std::uint8_t {
    Diff, ///< All of it.
    Reuse ///< Without `maps`, which no result depends on.
};

/// How the later of two runs differs from the earlier one.
struct InputChanges {
    std::vector<BodyChange> bodies; ///< One for each body.
    bool are_poses_equal = false;   ///< By the hash of all poses; a grid equals only a grid.
    std::vector<std::string> query; ///< A phrase for each difference: "level pairs, was count".
};

/// Both runs have the same number of bodies (`check_comparable`).
[[nodiscard]] InputChanges changes_between(const RunManifest& earlier, const RunManifest& later);

/// Checks that two runs have as many bodies, and of scenes equal names and lines at equal places:
/// results are compared by body and bundle. Errors: BadInput naming the difference.
[[nodiscard]] Status check_comparable(const RunManifest& earlier, const RunManifest& later);

/// Returns "B changed (7 parts, 2 new), poses equal, query equal".
[[nodiscard]] std::string changes_text(const InputChanges& changes);

/// Checks that results of the earlier run are results of the job for equal poses: that meshes and
/// query are equal. Errors: BadInput "nothing can be reused: B changed (...)".
[[nodiscard]] Status check_reusable(const RunManifest& earlier, const PreparedJob& job);

} // namespace cd
