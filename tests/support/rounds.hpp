// Loops of tests over seeds and SIMD targets. Failures name the round.
#pragma once

#include "common/geometry/simd_target.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>

namespace cd::tests {

/// A generator that knows its seed.
struct SeededRandom : std::mt19937_64 {
    explicit SeededRandom(std::uint64_t from) : std::mt19937_64(from), seed(from) {}
    std::uint64_t seed;
};

class SeedRange {
  public:
    SeedRange(std::uint64_t first, std::uint64_t end) : first_(first), end_(end) {}

    class Iterator {
      public:
        explicit Iterator(std::uint64_t seed) : seed_(seed) { name(); }
        SeededRandom operator*() const { return SeededRandom(seed_); }
        Iterator& operator++() {
            ++seed_;
            name();
            return *this;
        }
        bool operator!=(std::uint64_t end) const { return seed_ != end; }

      private:
        void name() {
            trace_.reset();
            trace_.emplace(__FILE__, __LINE__, testing::Message() << "seed " << seed_);
        }

        std::uint64_t seed_;
        std::optional<testing::ScopedTrace> trace_;
    };

    [[nodiscard]] Iterator begin() const { return Iterator(first_); }
    [[nodiscard]] std::uint64_t end() const { return end_; }

  private:
    std::uint64_t first_;
    std::uint64_t end_;
};

/// Returns the first seeds: `for (SeededRandom random : seeds(40))`.
[[nodiscard]] inline SeedRange seeds(std::uint64_t count, std::uint64_t first = 0) {
    return {first, first + count};
}

/// Returns `count` times the environment variable CD_ROUNDS, or `count` without one: a long run by
/// hand raises the rounds of a test.
[[nodiscard]] inline std::uint64_t raised(std::uint64_t count) {
    const char* const factor = std::getenv("CD_ROUNDS");
    return factor == nullptr ? count : count * std::strtoull(factor, nullptr, 10);
}

/// Calls `work` with each SIMD target of this host in use, then restores the best one.
template <class Work>
void on_every_target(const Work& work) {
    for (const SimdTarget target : available_simd_targets()) {
        SCOPED_TRACE(to_text(target));
        ASSERT_TRUE(force_simd_target(to_text(target)));
        work(target);
    }
    ASSERT_TRUE(force_simd_target("auto"));
}

} // namespace cd::tests
