// Proves that deciding pairs allocates no memory after the first pairs: in all stages up to
// WideInteger, under any pose, counting every allocation of the program.
#include "tests/common/pair/pair_batch.hpp"

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

TEST(PairAllocations, NoStageUpToWideIntegerAllocatesInTheSteadyState) {
    std::size_t batches = 0;
    for (const auto& [name, make] : pair_makers()) {
        Batch batch;
        PosePair poses;
        for (SeededRandom random : seeds(40)) {
            const PosedPair pair = make(random);
            batch.add(pair.a, pair.b);
            poses = random.seed == 0 ? pair.poses : poses;
        }
        for (const PairStage first : {PairStage::Float,
                                      PairStage::Double,
                                      PairStage::Lattice,
                                      PairStage::DoubleDouble,
                                      PairStage::WideInteger}) {
            TrianglePairTest test(poses, first);
            const auto run = [&] {
                static_cast<void>(test.classify(batch.a(), batch.b(), batch.candidates));
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
