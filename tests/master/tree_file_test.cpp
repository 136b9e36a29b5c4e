// Proves that a tree comes back from disk as it was, and that a damaged file is never taken for
// one.

#include "master/tree_file.hpp"

#include "common/tree/build.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class TreeFile : public testing::Test {
  protected:
    TemporaryFolder folder_;
    ThreadPool pool_{1};
    std::shared_ptr<const Mesh> mesh_ = share(join({make_sphere(1), make_box({3, 3, 3})}));
    ObbTree tree_ = build_tree(mesh_, BuildOptions{}, pool_);
    std::filesystem::path path_ = folder_ / "one.tree";
};

TEST_F(TreeFile, ComesBackAsItWas) {
    ASSERT_TRUE(write_tree_file(path_, tree_));
    const auto read = read_tree_file(path_, mesh_);

    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_TRUE(std::ranges::equal(read.value()->nodes(), tree_.nodes()));
    EXPECT_TRUE(std::ranges::equal(read.value()->triangle_ids(), tree_.triangle_ids()));
    EXPECT_EQ(read.value()->topology().component_triangles, tree_.topology().component_triangles);
    EXPECT_EQ(read.value()->topology().is_closed(), tree_.topology().is_closed());
    EXPECT_EQ(read.value()->topology().duplicate, tree_.topology().duplicate);
    EXPECT_EQ(tree_checksum(*read.value()), tree_checksum(tree_));
}

TEST_F(TreeFile, AnyChangedByteIsDamage) {
    ASSERT_TRUE(write_tree_file(path_, tree_));
    const std::string whole = read_text(path_);
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 200) {
        std::string text = whole;
        text[i] ^= 1;
        write_text(path_, text);
        const auto read = read_tree_file(path_, mesh_);
        ASSERT_FALSE(read) << "byte " << i;
        EXPECT_EQ(read.error().code, ErrorCode::Io);
        EXPECT_THAT(read.error().detail, testing::HasSubstr(path_.string()));
    }
}

TEST_F(TreeFile, AnyShorterFileIsDamage) {
    ASSERT_TRUE(write_tree_file(path_, tree_));
    const std::string whole = read_text(path_);
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200) {
        write_text(path_, whole.substr(0, size));
        EXPECT_FALSE(read_tree_file(path_, mesh_)) << size << " bytes";
    }
}

TEST_F(TreeFile, AnotherMeshAndNoFileAreErrors) {
    EXPECT_EQ(read_tree_file(path_, mesh_).error().code, ErrorCode::NotFound);
    ASSERT_TRUE(write_tree_file(path_, tree_));
    EXPECT_EQ(read_tree_file(path_, share(make_sphere(2))).error().code, ErrorCode::Io);
}

} // namespace
} // namespace cd::tests
