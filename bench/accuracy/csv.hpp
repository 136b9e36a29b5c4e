// Tables as files of comma-separated values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cd::bench {

/// Cells are quoted where they must be. A file that cannot be written ends the program: a report
/// with holes is none.
class CsvFile {
  public:
    CsvFile(const std::filesystem::path& path, const std::vector<std::string>& header);

    void row(const std::vector<std::string>& cells);

  private:
    std::ofstream file_;
    std::size_t columns_;
};

/// Shortest decimal that reads back as the same number.
[[nodiscard]] std::string cell(double value);
[[nodiscard]] std::string cell(std::uint64_t value);

} // namespace cd::bench
