// One finished scenario of a local run.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"

#include <utility>
#include <vector>

namespace cd {

/// A result with its record and digest, which a pool thread computes.
struct DoneScenario {
    ScenarioResult result;
    Bytes record;    ///< The canonical record.
    Sha256 digest{}; ///< `digest_of_record` of the record.
    /// All pairs in contact if the query asks for maps, else empty.
    std::vector<ContactPair> found;
};

[[nodiscard]] inline DoneScenario done_scenario(ScenarioResult result,
                                                std::vector<ContactPair> found) {
    DoneScenario done{std::move(result), {}, {}, std::move(found)};
    done.record = encode_result(done.result);
    done.digest = digest_of_record(done.record);
    return done;
}

} // namespace cd
