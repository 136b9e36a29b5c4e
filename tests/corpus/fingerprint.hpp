// A hash over the bits of what the corpus makes, so that a test can say that it did not change.
#pragma once

#include "tests/corpus/scenes.hpp"
#include "tests/support/hard_pairs.hpp"

#include <cstdint>

namespace cd::tests {

class Fingerprint {
  public:
    void add(std::uint64_t value);
    void add(double value); ///< Its bits.
    void add(const Pose& pose);
    void add(const PosedPair& pair);
    void add(const Scene& scene);

    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

} // namespace cd::tests
