// What a report was measured on.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace cd::bench {

/// Writes machine.csv: processor, threads, compiler, versions, and the peers that are missing.
void write_machine(const std::filesystem::path& folder, std::span<const std::string> missing);

} // namespace cd::bench
