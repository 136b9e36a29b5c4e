// An in-memory file with a path, for readers that take paths.
#pragma once

#include <filesystem>
#include <span>

namespace cd::fuzz {

class MemoryFile {
  public:
    explicit MemoryFile(std::span<const std::byte> bytes);
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();

    [[nodiscard]] std::filesystem::path path() const;

  private:
    int descriptor_ = -1;
};

} // namespace cd::fuzz
