// Files in memory, which know what of them would be there after a loss of power.
#pragma once

#include "common/core/files/bytes.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

struct SimulatedFile {
    Bytes content;
    Bytes durable;
    struct Write {
        std::uint64_t offset = 0;
        Bytes bytes;
    };
    std::vector<Write> pending; ///< Since the last sync.
    bool is_named_for_ever = false;
};

using SimulatedFiles = std::map<std::string, std::shared_ptr<SimulatedFile>>;

class Files {
  public:
    SimulatedFiles by_path;

    /// Of what was not synced each write may be there or not, and a new name as well. Whether
    /// anything is gone.
    bool lose_power(std::mt19937_64& random);
};

/// Of the files that no accident happens to: geometry.
[[nodiscard]] Files& safe_files();

} // namespace cd::tests
