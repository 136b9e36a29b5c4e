#include "bench/accuracy/csv.hpp"

#include "common/core/check.hpp"

#include <array>
#include <charconv>
#include <stdexcept>

namespace cd::bench {

namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c;
        if (c == '"') {
            result += c;
        }
    }
    return result + '"';
}

} // namespace

CsvFile::CsvFile(const std::filesystem::path& path, const std::vector<std::string>& header)
    : file_(path), columns_(header.size()) {
    row(header);
    if (!file_) {
        throw std::runtime_error("cannot write " + path.string());
    }
}

void CsvFile::row(const std::vector<std::string>& cells) {
    CD_CHECK(cells.size() == columns_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        file_ << (i == 0 ? "" : ",") << quoted(cells[i]);
    }
    // Flushed at once: a child would otherwise inherit the buffer and write it again.
    file_ << std::endl;
}

std::string cell(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

std::string cell(std::uint64_t value) {
    return std::to_string(value);
}

} // namespace cd::bench
