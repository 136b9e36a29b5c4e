#include "bench/accuracy/suites/pair_batch.hpp"

#include "common/core/host/thread_pool.hpp"
#include "tests/support/oracle.hpp"

#include <numeric>
#include <utility>

namespace cd::bench {

PairGroup first_candidates(PairGroup group, std::size_t count) {
    const auto first = [&](std::span<const Candidate> all) {
        return all.first(std::min(all.size(), count));
    };
    group.candidates = first(group.candidates);
    group.in_blocks.candidates = first(group.in_blocks.candidates);
    return group;
}

PairBatch::PairBatch(std::span<const tests::PosedPair> pairs) {
    for (std::size_t begin = 0; begin < pairs.size();) {
        std::size_t end = begin + 1;
        while (end < pairs.size() && pairs[end].poses == pairs[begin].poses) {
            ++end;
        }
        std::vector<Vec3>& a = vertices_.emplace_back();
        std::vector<Vec3>& b = vertices_.emplace_back();
        std::vector<Triangle>& triangles = triangles_.emplace_back();
        std::vector<Candidate>& candidates = candidates_.emplace_back();
        for (std::size_t i = begin; i < end; ++i) {
            const auto first = static_cast<std::uint32_t>(a.size());
            a.insert(a.end(), pairs[i].a.begin(), pairs[i].a.end());
            b.insert(b.end(), pairs[i].b.begin(), pairs[i].b.end());
            triangles.push_back({first, first + 1, first + 2});
            candidates.push_back({first / 3, first / 3});
        }
        groups_.push_back({pairs[begin].poses, {a, triangles}, {b, triangles}, candidates});
        begin = end;
    }
    count();
}

PairBatch::PairBatch(std::vector<PairGroup> groups) : groups_(std::move(groups)) {
    count();
}

void PairBatch::count() {
    size_ = 0;
    for (const PairGroup& group : groups_) {
        size_ += group.candidates.size();
    }
}

PairBatch PairBatch::swapped() const {
    PairBatch other;
    for (const PairGroup& group : groups_) {
        std::vector<Candidate>& candidates = other.candidates_.emplace_back();
        for (const Candidate& c : group.candidates) {
            candidates.push_back({c.b, c.a});
        }
        // Uses the mesh's arrays: only the answers are compared.
        other.groups_.push_back({{group.poses.b, group.poses.a}, group.b, group.a, candidates});
    }
    other.count();
    return other;
}

PairBatch PairBatch::reordered() const {
    PairBatch other;
    for (const PairGroup& group : groups_) {
        std::vector<Triangle>& a = other.triangles_.emplace_back();
        for (const Triangle& t : group.a.triangles) {
            a.push_back({t[1], t[2], t[0]});
        }
        std::vector<Triangle>& b = other.triangles_.emplace_back();
        for (const Triangle& t : group.b.triangles) {
            b.push_back({t[2], t[1], t[0]});
        }
        other.groups_.push_back(
            {group.poses, {group.a.vertices, a}, {group.b.vertices, b}, group.candidates});
    }
    other.count();
    return other;
}

std::vector<PairClass> PairBatch::truth(unsigned threads) const {
    std::vector<std::pair<const PairGroup*, const Candidate*>> pairs;
    pairs.reserve(size_);
    for (const PairGroup& group : groups_) {
        for (const Candidate& c : group.candidates) {
            pairs.emplace_back(&group, &c);
        }
    }
    std::vector<PairClass> classes(pairs.size());
    ThreadPool pool(threads);
    parallel_for(pool, pairs.size(), [&](std::size_t i) {
        const auto& [group, c] = pairs[i];
        classes[i] =
            tests::oracle_class(group->a.corners_at(c->a), group->b.corners_at(c->b), group->poses);
    });
    return classes;
}

} // namespace cd::bench
