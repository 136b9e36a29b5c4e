// Compares `put_settled` with encoding the settled result anew.
#pragma once

#include "common/job/result/result.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {

/// Expects of each result, with one flag changed, that `put_settled` gives its encoding.
inline void expect_settled_records(std::vector<ScenarioResult> results) {
    for (ScenarioResult& result : results) {
        const Bytes before = encode_result(result);
        result.surfaces_only = !result.surfaces_only;
        ByteWriter settled;
        put_settled(settled, result, before);
        EXPECT_EQ(settled.bytes(), encode_result(result));
    }
}

} // namespace cd::tests
