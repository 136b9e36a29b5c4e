// Sorts numbers: of 64 bits with SIMD (Highway's VQSort), of 32 bits by their digits, which is six
// times as fast as VQSort where compressing stores are slow (AMD's Zen 4).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// A sorter that keeps scratch memory between calls; one thread at a time may use it.
class NumberSorter {
  public:
    NumberSorter();
    ~NumberSorter();

    /// Sorts ascending.
    void sort(std::vector<std::uint32_t>& numbers) const;
    void sort(std::vector<std::uint64_t>& numbers) const;

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

} // namespace cd
