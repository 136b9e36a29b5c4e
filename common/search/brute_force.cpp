#include "common/search/brute_force.hpp"

namespace cd {

std::vector<ContactPair>
contact_pairs_brute_force(const Mesh& a, const Mesh& b, const PosePair& poses) {
    TrianglePairTest test(poses);
    std::vector<ContactPair> pairs;
    for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
            const PairClass kind = test.classify(a.corners(i), b.corners(j));
            if (kind != PairClass::Separate) {
                pairs.push_back({i, j, kind});
            }
        }
    }
    return pairs;
}

} // namespace cd
