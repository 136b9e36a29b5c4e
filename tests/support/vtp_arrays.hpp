// Reads the arrays of a .vtp file with appended raw data. tests/export/run reads such files with
// VTK.
#pragma once

#include "tests/support/process.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace cd::tests {

/// A .vtp file: the attributes of each array by name, and the bytes of its block. Cells have the
/// names Verts.connectivity, Verts.offsets, and so on.
struct VtpArrays {
    struct Array {
        std::string type;
        std::string bytes;

        template <class Number>
        [[nodiscard]] std::vector<Number> as() const {
            std::vector<Number> numbers(bytes.size() / sizeof(Number));
            std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
            return numbers;
        }
    };
    std::map<std::string, Array> arrays;
    std::string xml;

    [[nodiscard]] bool has(const std::string& name) const { return arrays.count(name) != 0; }
};

inline VtpArrays read_vtp(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    const std::size_t begin = text.find("<AppendedData encoding=\"raw\">\n_");
    VtpArrays found;
    found.xml = text.substr(0, begin);
    const std::string data = text.substr(text.find('_', begin) + 1);
    const std::regex element("<(Verts|Lines|Polys|Points)>|<(?:Data)?Array type=\"(\\w+)\" "
                             "Name=\"(\\w+)\"[^>]* offset=\"(\\d+)\"/>");
    std::string section;
    for (std::sregex_iterator at(found.xml.begin(), found.xml.end(), element), end; at != end;
         ++at) {
        const std::smatch& match = *at;
        if (match[1].matched) {
            section = match[1];
            continue;
        }
        const std::size_t offset = std::stoull(match[4]);
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, data.data() + offset, sizeof bytes);
        const std::string name = match[3];
        const bool is_of_cells = name == "connectivity" || name == "offsets";
        found.arrays[is_of_cells ? section + "." + name : name] = {
            match[2], data.substr(offset + sizeof bytes, bytes)};
    }
    return found;
}

} // namespace cd::tests
