// Reads all arrays of an .npz file.
#pragma once

#include "client/formats/npz_file.hpp"

#include <map>
#include <string>

namespace cd::tests {

inline Result<std::map<std::string, NpyArray>> read_npz(const std::filesystem::path& path) {
    const auto file = NpzFile::open(path);
    if (!file) {
        return file.error();
    }
    std::map<std::string, NpyArray> arrays;
    for (const std::string& name : file.value().names()) {
        auto array = file.value().read(name);
        if (!array) {
            return array.error();
        }
        arrays.emplace(name, std::move(array.value()));
    }
    return arrays;
}

} // namespace cd::tests
