// Trees of test meshes.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <span>
#include <utility>

namespace cd::tests {

[[nodiscard]] inline ObbTree
make_tree(Mesh mesh, const BuildOptions& options = {}, unsigned threads = 1) {
    ThreadPool pool(threads);
    return build_tree(share(std::move(mesh)), options, pool);
}

/// Returns the tree's view for a wide search, then for a binary one.
[[nodiscard]] inline std::array<TreeView, 2> forms_of(const ObbTree& tree) {
    TreeView binary = tree.view();
    binary.wide = {};
    return {tree.view(), binary};
}

template <class T>
[[nodiscard]] bool same_bytes(std::span<const T> a, std::span<const T> b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

/// Expects equality bit for bit.
inline void expect_same(const WideView& a, const WideView& b) {
    EXPECT_TRUE(same_bytes(a.nodes, b.nodes));
    EXPECT_TRUE(same_bytes(a.triangles.floats, b.triangles.floats));
    EXPECT_TRUE(same_bytes(a.triangles.doubles, b.triangles.doubles));
    EXPECT_TRUE(same_bytes(a.triangles.vertex_begin, b.triangles.vertex_begin));
    EXPECT_TRUE(same_bytes(a.triangles.corners, b.triangles.corners));
    EXPECT_TRUE(same_bytes(a.triangles.ids, b.triangles.ids));
    EXPECT_EQ(a.triangles.reach, b.triangles.reach);
    EXPECT_EQ(a.extent, b.extent);
}

} // namespace cd::tests
