#include "tests/fuzz/memory_file.hpp"

#include "tests/fuzz/require.hpp"

#include <sys/mman.h>
#include <unistd.h>

namespace cd::fuzz {

MemoryFile::MemoryFile(std::span<const std::byte> bytes) : descriptor_(memfd_create("fuzz", 0)) {
    require(descriptor_ >= 0, "memory for a file");
    const auto written = write(descriptor_, bytes.data(), bytes.size());
    require(written == static_cast<ssize_t>(bytes.size()), "room in memory for a file");
}

MemoryFile::~MemoryFile() {
    close(descriptor_);
}

std::filesystem::path MemoryFile::path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
}

} // namespace cd::fuzz
