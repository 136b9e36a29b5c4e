#include "bench/peers/distances/hard_pairs.hpp"

#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"

#include <algorithm>
#include <random>

namespace cd::bench {

namespace {

double largest_coordinate(const tests::PosedPair& pair) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        largest = std::max({largest,
                            pair.poses.a.apply(pair.a[i]).cwiseAbs().maxCoeff(),
                            pair.poses.b.apply(pair.b[i]).cwiseAbs().maxCoeff()});
    }
    return largest;
}

} // namespace

std::vector<PairDistances> measure_hard_pairs(std::span<const DistanceEngine> engines,
                                              std::uint64_t count) {
    std::vector<PairDistances> rows;
    for (const auto& [kind, make] : tests::distance_pair_makers()) {
        const std::size_t first = rows.size();
        for (const DistanceEngine& engine : engines) {
            rows.push_back({kind, engine.name, 0, {}});
        }
        std::mt19937_64 random(1);
        for (std::uint64_t i = 0; i < count; ++i) {
            const tests::PosedPair pair = make(random);
            const tests::DistanceOracle oracle(pair.a, pair.b, pair.poses);
            for (std::size_t e = 0; e < engines.size() && !oracle.share_a_point(); ++e) {
                if (engines[e].of_pair) {
                    rows[first + e].errors.add(engines[e].of_pair(pair.a, pair.b, pair.poses),
                                               oracle.rounded(),
                                               largest_coordinate(pair));
                    ++rows[first + e].pairs;
                }
            }
        }
    }
    std::erase_if(rows, [](const PairDistances& row) { return row.pairs == 0; });
    return rows;
}

} // namespace cd::bench
