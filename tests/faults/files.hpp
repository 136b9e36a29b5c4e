// In-memory files that model which data survives a power loss.
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
    std::vector<Write> pending; ///< Writes since the last sync.
    bool is_named_for_ever = false;
};

using SimulatedFiles = std::map<std::string, std::shared_ptr<SimulatedFile>>;

class Files {
  public:
    SimulatedFiles by_path;

    /// Keeps or drops each unsynced write, and each new name, at random. Returns whether anything
    /// is lost.
    bool lose_power(std::mt19937_64& random);
};

/// Holds geometry files, which no fault affects.
[[nodiscard]] Files& safe_files();

} // namespace cd::tests
