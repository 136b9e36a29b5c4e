// A question about two meshes in many poses, which come at once or part by part.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/job/query.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/statistics.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace cdcluster {

/// What a results folder needs of a call beside its job.
struct KeptAnswers {
    cd::Bytes records; ///< The canonical records in order, each after its length as u32.
    std::optional<cd::ContactMap> map;
    double seconds = 0;
    unsigned threads = 1; ///< Number of threads that answered.
    cd::JobStatistics statistics;
};

/// Answers a question for the poses of its calls, which are numbered on from call to call.
class PoseSweep {
  public:
    /// Errors: BadInput for what does not go together; a pattern that matches no part.
    PoseSweep(Mesh a, Mesh b, Query query);

    [[nodiscard]] const cd::Query& query() const { return query_; }

    /// Answers the next poses, as `find_contacts` with windows or, without `each_window`, at once.
    /// Appends to `kept` unless it is null. The results have the digest of all answers so far only
    /// if this is the `last` call. Errors: as `find_contacts`; after one, `next` may not be called.
    [[nodiscard]] Results next(const Poses& poses,
                               bool last,
                               const std::function<void(Results&&)>& each_window = {},
                               KeptAnswers* kept = nullptr);

  private:
    class Part;

    Mesh a_;
    Mesh b_;
    Query asked_;
    cd::Query query_;
    std::uint64_t first_ = 0; ///< Number of the next pose.
    cd::Sha256Stream digest_; ///< Over the digests of all records so far.
};

} // namespace cdcluster
