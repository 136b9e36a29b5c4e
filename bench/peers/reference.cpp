#include "bench/peers/reference.hpp"

#include "common/core/check.hpp"
#include "tests/support/oracle.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace cd::bench {

namespace {

/// 512 MiB of address space; only used pages take memory.
constexpr std::size_t keys_max = std::size_t{1} << 26;

std::uint64_t key(const IdPair& pair) {
    return std::uint64_t{pair.first} << 32 | pair.second;
}

IdPair pair_of(std::uint64_t key) {
    return {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}

} // namespace

PairSet pair_set(MeshAnswer answer) {
    std::sort(answer.pairs.begin(), answer.pairs.end());
    answer.pairs.erase(std::unique(answer.pairs.begin(), answer.pairs.end()), answer.pairs.end());
    return std::move(answer.pairs);
}

Reference::Reference(const Scene& scene, const Engine& ours, std::chrono::seconds limit)
    : keys_(keys_max), ends_(scene.poses.size() + 1) {
    const Ending ending = run_isolated(limit, [&] {
        const auto engine = ours.make_meshes();
        engine->load(scene.a, scene.b);
        for (std::size_t p = 0; p < scene.poses.size(); ++p) {
            const PairSet found = pair_set(engine->ask(scene.poses[p], Level::Pairs));
            CD_CHECK(found.size() <= keys_max - ends_[p]);
            std::transform(found.begin(), found.end(), &keys_[ends_[p]], key);
            ends_[p + 1] = ends_[p] + found.size();
        }
    });
    if (ending != Ending::Done) {
        throw std::runtime_error(ours.name + " on " + scene.name + ": " +
                                 std::string(to_text(ending)));
    }
}

std::uint64_t Reference::pair_count(std::size_t pose) const {
    return ends_[pose + 1] - ends_[pose];
}

PairSet Reference::pairs(std::size_t pose) const {
    const auto keys = keys_.values().subspan(ends_[pose], pair_count(pose));
    PairSet pairs;
    std::transform(keys.begin(), keys.end(), std::back_inserter(pairs), pair_of);
    return pairs;
}

std::vector<Disagreement>
disagreements(const Reference& reference, std::size_t pose, const PairSet& found) {
    const PairSet expected = reference.pairs(pose);
    std::vector<Disagreement> all;
    const auto add = [&](const PairSet& left, const PairSet& right, bool is_extra) {
        PairSet only;
        std::set_difference(
            left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(only));
        for (const auto& [a, b] : only) {
            all.push_back({pose, a, b, is_extra});
        }
    };
    add(expected, found, false);
    add(found, expected, true);
    return all;
}

std::uint64_t ours_wrong(const Scene& scene, std::span<const Disagreement> judged) {
    const auto is_ours_wrong = [&](const Disagreement& d) {
        // Ids of missing triangles are the engine's own error.
        if (d.a >= scene.a->triangles().size() || d.b >= scene.b->triangles().size()) {
            return false;
        }
        const PairClass truth =
            tests::oracle_class(scene.a->corners(d.a), scene.b->corners(d.b), scene.poses[d.pose]);
        return d.is_extra == (truth != PairClass::Separate);
    };
    return static_cast<std::uint64_t>(std::count_if(judged.begin(), judged.end(), is_ours_wrong));
}

} // namespace cd::bench
