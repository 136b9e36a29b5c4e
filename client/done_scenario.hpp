// What a thread has found out about one scenario.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/hash.hpp"
#include "common/job/result.hpp"
#include "common/tree/contact_pair.hpp"

#include <vector>

namespace cd {

/// A result as it comes from a thread, which has encoded and digested it.
struct DoneScenario {
    ScenarioResult result;
    Bytes record;    ///< Canonical.
    Sha256 digest{}; ///< Of the record.
    /// All pairs in contact, where the query is for maps.
    std::vector<ContactPair> found;
};

} // namespace cd
