// Proves that deciding pairs allocates no memory after the first pairs: in all stages up to
// WideInteger, under any pose, counting every allocation of the program.
#include "common/pair/triangle_pair.hpp"
#include "tests/support/hard_pairs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <random>
#include <vector>

namespace {

std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}

} // namespace

// Replaces the operators for the whole program; no smaller scope exists.
void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace cd::tests {

namespace {

/// Triangles of A and of B from hard pairs, all under the first pair's poses.
struct Batch {
    std::vector<Vec3> vertices_a;
    std::vector<Vec3> vertices_b;
    std::vector<Triangle> triangles;
    std::vector<Candidate> candidates;
    PosePair poses;
};

Batch make_batch(const PairMaker& make) {
    Batch batch;
    for (std::uint32_t i = 0; i < 40; ++i) {
        std::mt19937_64 random(i);
        const PosedPair pair = make(random);
        batch.vertices_a.insert(batch.vertices_a.end(), pair.a.begin(), pair.a.end());
        batch.vertices_b.insert(batch.vertices_b.end(), pair.b.begin(), pair.b.end());
        batch.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        batch.candidates.push_back({i, i});
        batch.poses = i == 0 ? pair.poses : batch.poses;
    }
    return batch;
}

} // namespace

TEST(PairAllocations, NoStageUpToWideIntegerAllocatesInTheSteadyState) {
    std::size_t batches = 0;
    for (const auto& [name, make] : pair_makers()) {
        const Batch batch = make_batch(make);
        for (const PairStage first : {PairStage::Float,
                                      PairStage::Double,
                                      PairStage::Lattice,
                                      PairStage::DoubleDouble,
                                      PairStage::WideInteger}) {
            TrianglePairTest test(batch.poses, first);
            const auto run = [&] {
                static_cast<void>(test.classify(TriangleSpan{batch.vertices_a, batch.triangles},
                                                TriangleSpan{batch.vertices_b, batch.triangles},
                                                batch.candidates));
            };
            run();
            if (test.statistics()[PairStage::Arbitrary] > 0) {
                continue; // Needs numbers of arbitrary size.
            }
            const std::uint64_t before = allocations;
            run();
            ASSERT_EQ(allocations, before) << name << " from " << to_text(first);
            ++batches;
        }
    }
    EXPECT_GT(batches, 50u);
}

} // namespace cd::tests
