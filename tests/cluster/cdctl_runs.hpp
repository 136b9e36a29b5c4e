// Runs cdctl as a user does, and parses its output.
#pragma once

#include "tests/support/obj_file.hpp"
#include "tests/support/process.hpp"

#include <regex>
#include <string>

namespace cd::tests {

inline std::string cdctl() {
    return program("cdctl").string();
}

inline std::string digest_of(const Ran& ran) {
    std::smatch found;
    const std::regex pattern("\n +digest +([0-9a-f]{16})"); // Skips the digest of a map.
    return std::regex_search(ran.output, found, pattern) ? found[1].str() : "none: " + ran.errors;
}

} // namespace cd::tests
