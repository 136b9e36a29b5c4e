// Proves that trees are restored from disk bit for bit and answer as built ones; that a damaged or
// truncated file, or one of another mesh, build or version, is rejected; and that several processes
// may write a file at once.

#include "common/tree/tree_file.hpp"

#include "common/core/files/section_file.hpp"
#include "common/search/contact_search.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <functional>

namespace cd::tests {
namespace {

using Tree = Result<std::shared_ptr<const ObbTree>>;

void expect_same_topology(const Topology& a, const Topology& b) {
    EXPECT_EQ(a.degenerate, b.degenerate);
    EXPECT_EQ(a.duplicate, b.duplicate);
    EXPECT_EQ(a.boundary_edges, b.boundary_edges);
    EXPECT_EQ(a.non_manifold_edges, b.non_manifold_edges);
    EXPECT_EQ(a.inconsistent_edges, b.inconsistent_edges);
    EXPECT_EQ(a.component_triangles, b.component_triangles);
}

class TreeFile : public testing::Test {
  protected:
    [[nodiscard]] Sha256 key() const { return tree_key(mesh_->hash(), BuildOptions{}); }
    [[nodiscard]] Status write_binary() const {
        return write_tree_file(path_, tree_, key(), Durability::Synced);
    }
    [[nodiscard]] Status write_wide() const {
        return write_wide_tree_file(path_, tree_, key(), Durability::Unsynced);
    }
    [[nodiscard]] Tree read_binary() const { return read_tree_file(path_, mesh_, key()); }
    [[nodiscard]] Tree read_wide() const { return read_wide_tree_file(path_, mesh_, key()); }

    /// Reads and writes both kinds of files.
    struct Kind {
        std::function<Status()> write;
        std::function<Tree()> read;
    };
    [[nodiscard]] std::vector<Kind> kinds() const {
        return {{[this] { return write_binary(); }, [this] { return read_binary(); }},
                {[this] { return write_wide(); }, [this] { return read_wide(); }}};
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "one.tree";
    std::shared_ptr<const Mesh> mesh_ = share(join({make_sphere(2), make_box({3, 3, 3})}));
    ObbTree tree_ = make_tree(Mesh(*mesh_));
};

TEST_F(TreeFile, TheBinaryFormComesBackAsItWas) {
    ASSERT_TRUE(write_binary());
    const Tree read = read_binary();

    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value()->wide(), nullptr);
    EXPECT_TRUE(same_bytes(read.value()->nodes(), tree_.nodes()));
    EXPECT_TRUE(same_bytes(read.value()->triangle_ids(), tree_.triangle_ids()));
    EXPECT_TRUE(same_bytes(read.value()->view().triangles, tree_.view().triangles));
    expect_same_topology(read.value()->topology(), tree_.topology());
    EXPECT_EQ(tree_checksum(*read.value()), tree_checksum(tree_));
}

TEST_F(TreeFile, TheWideFormComesBackAsItWas) {
    std::mt19937_64 random(1);
    // In doubles, in floats, and of a body without a wide tree.
    const Mesh soup = make_triangle_soup(random, 700);
    for (const Mesh& mesh :
         {soup, make_gridded_box({2, 4, 8}, 7), translated(soup, {1e30, 0, 0})}) {
        mesh_ = share(Mesh(mesh));
        tree_ = make_tree(mesh);
        ASSERT_TRUE(write_wide());
        const Tree read = read_wide();
        ASSERT_TRUE(read) << read.error().detail;
        EXPECT_FALSE(read.value()->has_binary());
        ASSERT_NE(read.value()->wide(), nullptr);
        expect_same(read.value()->view().wide, tree_.view().wide);
        expect_same_topology(read.value()->topology(), tree_.topology());
    }
    EXPECT_TRUE(tree_.view().wide.nodes.empty());
}

TEST_F(TreeFile, TreesFromDiskFindTheSamePairs) {
    ASSERT_TRUE(write_binary());
    const auto binary = read_binary().value();
    ASSERT_TRUE(write_wide());
    const auto wide = read_wide().value();
    std::mt19937_64 random(2);
    std::size_t found = 0;
    for (int i = 0; i < 20; ++i) {
        const PosePair poses{make_pose(random, 0.5), make_pose(random, 0.5)};
        const auto expected = contact_pairs(tree_, tree_, poses);
        EXPECT_EQ(contact_pairs(*wide, *wide, poses), expected);
        EXPECT_EQ(contact_pairs(*binary, *binary, poses), expected);
        found += expected.size();
    }
    EXPECT_GT(found, 100u);
}

TEST_F(TreeFile, AnyChangedByteIsDamage) {
    for (const Kind& kind : kinds()) {
        ASSERT_TRUE(kind.write());
        const std::string whole = read_text(path_);
        for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 300) {
            std::string text = whole;
            text[i] ^= 1;
            write_text(path_, text);
            const Tree read = kind.read();
            ASSERT_FALSE(read) << "byte " << i;
            EXPECT_EQ(read.error().code, ErrorCode::Io);
            EXPECT_THAT(read.error().detail, testing::HasSubstr(path_.string()));
        }
    }
}

TEST_F(TreeFile, AnyShorterFileIsDamage) {
    for (const Kind& kind : kinds()) {
        ASSERT_TRUE(kind.write());
        const std::string whole = read_text(path_);
        for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 300) {
            write_text(path_, whole.substr(0, size));
            EXPECT_FALSE(kind.read()) << size << " bytes";
        }
    }
}

TEST_F(TreeFile, AMissingFileOrOneOfAnotherMeshBuildOrKindIsAnError) {
    EXPECT_EQ(read_binary().error().code, ErrorCode::NotFound);
    EXPECT_EQ(read_wide().error().code, ErrorCode::NotFound);
    ASSERT_TRUE(write_binary());
    EXPECT_EQ(read_wide().error().code, ErrorCode::Io);
    const auto other = share(make_sphere(2));
    EXPECT_EQ(read_tree_file(path_, other, tree_key(other->hash(), {})).error().code,
              ErrorCode::Io);
    const Sha256 one_a_leaf = tree_key(mesh_->hash(), {.leaf_triangles_max = 1});
    EXPECT_EQ(read_tree_file(path_, mesh_, one_a_leaf).error().code, ErrorCode::Io);
}

TEST_F(TreeFile, TheKeyTellsApartAllThatDecidesTheTree) {
    const Sha256 mesh = mesh_->hash();
    const std::vector<Sha256> keys{tree_key(mesh, {}),
                                   tree_key(share(make_sphere(2))->hash(), {}),
                                   tree_key(mesh, {.boxes = BoxKind::Aabb}),
                                   tree_key(mesh, {.rule = SplitRule::Bare}),
                                   tree_key(mesh, {.leaf_triangles_max = 3}),
                                   tree_key(mesh, {.sweep_triangles_max = 64})};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(keys[i], keys[k]) << i << " and " << k;
        }
    }
    // The tree's key does not depend on prepared searches.
    EXPECT_EQ(tree_key(mesh, {.prepare_search = false}), keys[0]);
}

/// If this fails because the builder's trees change, raise `tree_build_version`, so that stored
/// trees do not pass for new ones.
TEST_F(TreeFile, TheBuildersTreesAreThoseOfItsVersion) {
    std::mt19937_64 random(3);
    const ObbTree tree = make_tree(make_triangle_soup(random, 5000, 0.1));
    const WideView wide = tree.view().wide;
    EXPECT_EQ(tree_build_version, 2u);
    EXPECT_EQ(tree_checksum(tree), 17357885670689973998u);
    EXPECT_EQ(checksum(std::as_bytes(wide.nodes)), 3836730756955351777u);
    EXPECT_EQ(checksum(std::as_bytes(wide.triangles.ids)), 4093585964538048788u);
}

TEST_F(TreeFile, TwoProcessesThatWriteTheSameAtOnceLeaveOneWholeFile) {
    constexpr int rounds = 60;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        bool written = true;
        for (int i = 0; i < rounds; ++i) {
            written = written && static_cast<bool>(write_wide());
        }
        ::_exit(written ? 0 : 1);
    }
    for (int i = 0; i < rounds; ++i) {
        EXPECT_TRUE(write_wide());
        const Tree read = read_wide();
        ASSERT_TRUE(read) << read.error().detail;
        expect_same(read.value()->view().wide, tree_.view().wide);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1)
        << "nothing is left over";
}

} // namespace
} // namespace cd::tests
