// Sorts many numbers quickly.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// Keeps scratch memory between calls; one thread at a time.
class NumberSorter {
  public:
    NumberSorter();
    ~NumberSorter();

    /// Ascending.
    void sort(std::vector<std::uint32_t>& numbers) const;

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

} // namespace cd
