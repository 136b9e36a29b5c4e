// One test case for each category of the corpus, so that they run in parallel.
#pragma once

#include "tests/corpus/pairs.hpp"
#include "tests/corpus/scenes.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <vector>

namespace cd::tests {

/// Turns a category's name into a part of a test's name.
inline std::string test_name(const testing::TestParamInfo<std::string>& category) {
    std::string name = category.param;
    for (char& letter : name) {
        letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    }
    return name;
}

/// Returns the categories of scenes in order.
[[nodiscard]] std::vector<std::string> scene_categories();

/// Returns the scenes of one category.
[[nodiscard]] std::vector<const Scene*> scenes_of(const std::string& category);

} // namespace cd::tests
