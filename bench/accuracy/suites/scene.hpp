// Two bodies under a list of poses, with all contacts, found without the engine.
#pragma once

#include "bench/peers/engines/engine.hpp"
#include "common/tree/obb_tree.hpp"

#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

struct Scene {
    std::string suite; ///< "scenes", "motion" or "vehicles".
    std::string name;
    std::shared_ptr<const Mesh> a;
    std::shared_ptr<const Mesh> b;
    std::vector<PosePair> poses;
};

/// A pair in contact with its true class.
struct TruePair {
    IdPair ids;
    PairClass kind = PairClass::Touch;
};

/// All contacts of one pose, sorted by their triangles.
using TrueContacts = std::vector<TruePair>;

/// Returns the contacts of each pose. The oracle decides all pairs whose world boxes, widened
/// beyond any rounding error, overlap. Uses `threads` threads, which have ended on return.
[[nodiscard]] std::vector<TrueContacts> true_contacts(const Scene& scene, unsigned threads);

/// Returns Separate for a pair that is not in contact.
[[nodiscard]] PairClass true_class(const TrueContacts& contacts, const IdPair& ids);

} // namespace cd::bench
