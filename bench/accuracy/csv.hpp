// Tables as CSV files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cd::bench {

/// Quotes cells where needed. Ends the program if the file cannot be written: a report must be
/// complete.
class CsvFile {
  public:
    CsvFile(const std::filesystem::path& path, const std::vector<std::string>& header);

    void row(const std::vector<std::string>& cells);

  private:
    std::ofstream file_;
    std::size_t columns_;
};

/// Returns the shortest decimal that reads back as the same number.
[[nodiscard]] std::string cell(double value);
[[nodiscard]] std::string cell(std::uint64_t value);

} // namespace cd::bench
