// Times searches with a clearance, and the float stage of their decisions on each SIMD target.
#pragma once

#include "bench/accuracy/suites/scene.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

/// What floats take on one SIMD target to compare the distances of candidates with a clearance.
struct NearFloats {
    std::string target;
    std::uint64_t candidates = 0; ///< Those that share no point, of all poses.
    std::uint64_t unknown = 0;    ///< Those that floats leave to doubles.
    double candidate_ns = 0;      ///< Median over the rounds, of processor time.
};

/// Measures all SIMD targets of this processor in turns. The bodies have wide trees. The candidates
/// are those of a search for all pairs within the clearance, without pairs in contact, which the
/// search decides before.
[[nodiscard]] std::vector<NearFloats>
measure_near_floats(const Scene& scene, double clearance, std::size_t rounds);

/// Times searches that tell whether any pair is within a clearance. A round asks every pose of the
/// scene once.
class NearQueries {
  public:
    /// The scene outlives the object.
    NearQueries(const Scene& scene, double clearance);

    void run(std::size_t rounds);

    [[nodiscard]] std::size_t rounds() const { return round_means_.size(); }
    /// Returns the mean seconds a pose in the quickest round, which other load of the machine
    /// disturbs least.
    [[nodiscard]] double quickest_round() const;
    /// Returns the mean seconds a pose in the median round.
    [[nodiscard]] double median_round() const;

  private:
    const Scene& scene_;
    std::shared_ptr<const ObbTree> a_;
    std::shared_ptr<const ObbTree> b_;
    std::unique_ptr<ContactSearch> search_;
    std::vector<double> round_means_;
};

} // namespace cd::bench
