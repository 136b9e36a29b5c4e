// Hashes the bits of the corpus, so that a test can detect changes.
#pragma once

#include "tests/corpus/scenes.hpp"
#include "tests/support/hard_pairs.hpp"

#include <cstdint>

namespace cd::tests {

class Fingerprint {
  public:
    void add(std::uint64_t value);
    void add(double value); ///< Hashes its bits.
    void add(const Pose& pose);
    void add(const PosedPair& pair);
    void add(const Scene& scene);

    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace cd::tests
