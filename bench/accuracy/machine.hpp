// Records the machine on which a report was measured.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace cd::bench {

/// Writes machine.csv: processor, threads, compiler, versions, and missing peers.
void write_machine(const std::filesystem::path& folder, std::span<const std::string> missing);

} // namespace cd::bench
