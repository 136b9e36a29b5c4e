// Proves that cached trees are found again and stay within the bound, least recently used evicted
// first; that an unusable folder costs only a warning; and that a job gets its bodies' trees in the
// forms it searches.
#include "client/trees/tree_cache.hpp"

#include "client/trees/body_trees.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/wide/wide_tree.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

namespace cd::tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TreeCacheTest : public testing::Test {
  protected:
    [[nodiscard]] ObbTree build(const std::shared_ptr<const Mesh>& mesh) {
        return build_tree(mesh, {}, pool_);
    }
    [[nodiscard]] std::vector<fs::path> files() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            files.push_back(entry.path());
        }
        std::ranges::sort(files);
        return files;
    }
    [[nodiscard]] std::uint64_t bytes() const {
        std::uint64_t sum = 0;
        for (const fs::path& file : files()) {
            sum += fs::file_size(file);
        }
        return sum;
    }

    TemporaryFolder parent_;
    fs::path folder_ = parent_ / "made/when/needed";
    ThreadPool pool_{2};
    std::shared_ptr<const Mesh> closed_ = share(make_sphere(3));
    std::shared_ptr<const Mesh> open_ =
        share(make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}));
    /// Exceeds the range of a wide tree.
    std::shared_ptr<const Mesh> huge_ = share(make_box({0x1p60, 0x1p60, 0x1p60}));
};

TEST_F(TreeCacheTest, WhatIsKeptIsFoundAgain) {
    TreeCache cache(folder_);
    EXPECT_EQ(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_FALSE(fs::exists(folder_)) << "looking leaves no trace";
    cache.keep(TreeForm::Wide, build(closed_));
    const auto wide = TreeCache(folder_).find(TreeForm::Wide, closed_);
    ASSERT_NE(wide, nullptr);
    EXPECT_FALSE(wide->has_binary());
    EXPECT_EQ(cache.find(TreeForm::Binary, closed_), nullptr) << "each form is kept by itself";
    EXPECT_EQ(cache.find(TreeForm::Wide, open_), nullptr);
    cache.keep(TreeForm::Binary, build(closed_));
    ASSERT_NE(cache.find(TreeForm::Binary, closed_), nullptr);
    EXPECT_EQ(files().size(), 2u);
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
}

TEST_F(TreeCacheTest, AFifoUnderTheNameOfATreeIsAWarning) {
    TreeCache cache(folder_);
    cache.keep(TreeForm::Wide, build(closed_));
    const fs::path file = files().front();
    fs::remove(file);
    ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(cache.find(TreeForm::Wide, closed_), nullptr) << "and returns at once";
    EXPECT_THAT(cache.take_warnings(), ElementsAre(HasSubstr("is no regular file")));
    cache.keep(TreeForm::Wide, build(closed_));
    EXPECT_NE(cache.find(TreeForm::Wide, closed_), nullptr);
}

TEST_F(TreeCacheTest, WithoutAFolderNothingIsKept) {
    TreeCache cache(tree_cache_folder("off"));
    cache.keep(TreeForm::Wide, build(closed_));
    EXPECT_EQ(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
}

TEST_F(TreeCacheTest, BeyondTheBoundTheLongestUnusedLeaves) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (int i = 0; i < 4; ++i) {
        meshes.push_back(share(translated(make_sphere(2), {0.5 * i, 0, 0})));
    }
    std::uint64_t one = 0;
    {
        TreeCache cache(folder_);
        cache.keep(TreeForm::Wide, build(meshes[0]));
        one = bytes();
    }
    TreeCache cache(folder_, 3 * one + one / 2);
    cache.keep(TreeForm::Wide, build(meshes[1]));
    cache.keep(TreeForm::Wide, build(meshes[2]));
    // All files are old, then two of them are used.
    for (const fs::path& file : files()) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(9));
    }
    EXPECT_NE(cache.find(TreeForm::Wide, meshes[0]), nullptr);
    EXPECT_NE(cache.find(TreeForm::Wide, meshes[1]), nullptr);
    write_text(folder_ / "notes.txt", std::string(4 * one, 'x')); // A foreign file.
    cache.keep(TreeForm::Wide, build(meshes[3]));
    EXPECT_EQ(cache.find(TreeForm::Wide, meshes[2]), nullptr);
    for (const std::size_t kept : {0u, 1u, 3u}) {
        EXPECT_NE(cache.find(TreeForm::Wide, meshes[kept]), nullptr) << kept;
    }
    EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

TEST_F(TreeCacheTest, ATreeLargerThanTheBoundDoesNotStay) {
    TreeCache cache(folder_, 100);
    cache.keep(TreeForm::Wide, build(closed_));
    EXPECT_THAT(files(), IsEmpty());
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
}

TEST_F(TreeCacheTest, WhatAnEndedProcessLeftHalfWrittenGoesToo) {
    TreeCache cache(folder_, 1 << 20);
    cache.keep(TreeForm::Wide, build(closed_));
    const fs::path left = files().front().string() + ".tmp-abcdef";
    write_text(left, std::string(1 << 20, 'x'));
    fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(3));
    cache.keep(TreeForm::Wide, build(open_));
    EXPECT_FALSE(fs::exists(left));
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(TreeCacheTest, ADamagedFileIsAWarningAndIsReplaced) {
    TreeCache cache(folder_);
    cache.keep(TreeForm::Wide, build(closed_));
    const fs::path file = files().front();
    std::string text = read_text(file);
    text[text.size() / 2] ^= 1;
    write_text(file, text);
    EXPECT_EQ(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_THAT(cache.take_warnings(),
                ElementsAre(testing::AllOf(HasSubstr("built anew"), HasSubstr(file.string()))));
    cache.keep(TreeForm::Wide, build(closed_));
    EXPECT_NE(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
}

TEST_F(TreeCacheTest, AFolderThatCannotBeWrittenIsAWarning) {
    write_text(parent_ / "file", "");
    TreeCache cache(parent_ / "file");
    EXPECT_EQ(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_THAT(cache.take_warnings(), testing::SizeIs(1));
    cache.keep(TreeForm::Wide, build(closed_));
    EXPECT_THAT(cache.take_warnings(), ElementsAre(HasSubstr("not kept for later runs")));
}

TEST_F(TreeCacheTest, AFolderThatMayOnlyBeReadStillGivesItsTrees) {
    TreeCache cache(folder_);
    cache.keep(TreeForm::Wide, build(closed_));
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(cache.find(TreeForm::Wide, closed_), nullptr);
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
    cache.keep(TreeForm::Wide, build(open_));
    // Root ignores permissions.
    EXPECT_THAT(cache.take_warnings(), testing::SizeIs(::geteuid() == 0 ? 0 : 1));
    fs::permissions(folder_, fs::perms::owner_all);
}

class BodyTreesTest : public TreeCacheTest {
  protected:
    using Trees = std::vector<std::shared_ptr<const ObbTree>>;

    /// Makes the trees from scratch, from the resulting cache, and without a cache.
    [[nodiscard]] std::vector<Trees> make(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                                          const TreeUse& use) {
        fs::remove_all(folder_);
        std::vector<Trees> made;
        for (const fs::path& folder : {folder_, folder_, fs::path()}) {
            TreeCache cache(folder);
            made.push_back(make_body_trees(meshes, use, cache, pool_));
            EXPECT_THAT(cache.take_warnings(), IsEmpty());
        }
        return made;
    }
    static void expect_forms(const Trees& trees, bool binary, bool wide) {
        for (const auto& tree : trees) {
            EXPECT_EQ(tree->has_binary(), binary);
            EXPECT_EQ(tree->wide() != nullptr, wide);
        }
    }
};

TEST_F(BodyTreesTest, BodiesOfOneMeshShareATreeAmongMany) {
    TreeCache cache{fs::path()};
    const Trees trees =
        make_body_trees({open_, closed_, open_, closed_}, {.settles = true}, cache, pool_);
    ASSERT_EQ(trees.size(), 4u);
    EXPECT_EQ(trees[0], trees[2]);
    EXPECT_EQ(trees[1], trees[3]);
    EXPECT_NE(trees[0], trees[1]);
    // Two closed bodies may be inside one another; an open one is in none.
    EXPECT_TRUE(trees[1]->has_binary());
    EXPECT_FALSE(trees[0]->has_binary());
}

TEST_F(BodyTreesTest, OpenBodiesOrNoInsidesTakeTheWideFormAlone) {
    for (const Trees& trees : make({closed_, open_}, {.settles = true})) {
        expect_forms(trees, false, true);
        EXPECT_TRUE(trees[0]->topology().is_closed());
        EXPECT_FALSE(trees[1]->topology().is_closed());
    }
    EXPECT_EQ(files().size(), 2u);
    for (const Trees& trees : make({closed_, closed_}, {.settles = false})) {
        expect_forms(trees, false, true);
    }
    EXPECT_EQ(files().size(), 1u) << "one body twice is one tree";
}

TEST_F(BodyTreesTest, InsidesOfClosedBodiesTakeBothForms) {
    const auto other = share(make_box({1, 1, 1}));
    for (const Trees& trees : make({closed_, other}, {.settles = true})) {
        expect_forms(trees, true, true);
    }
    EXPECT_EQ(files().size(), 4u);
}

TEST_F(BodyTreesTest, WhereOneBodyHasNoWideTreeBothHaveTheBinaryOne) {
    for (const Trees& trees : make({open_, huge_}, {})) {
        expect_forms(trees, true, true);
        EXPECT_TRUE(trees[1]->view().wide.nodes.empty());
    }
}

TEST_F(BodyTreesTest, EqualMeshesShareOneTree) {
    TreeCache cache(folder_);
    const Trees trees = make_body_trees({closed_, share(make_sphere(3))}, {}, cache, pool_);
    EXPECT_EQ(trees[0], trees[1]);
}

TEST_F(BodyTreesTest, AKeptBinaryTreeIsCollapsedInsteadOfBuilt) {
    TreeCache cache(folder_);
    cache.keep(TreeForm::Binary, build(closed_));
    const Trees trees = make_body_trees({closed_, closed_}, {.settles = false}, cache, pool_);
    EXPECT_TRUE(std::ranges::equal(trees[0]->view().wide.triangles.ids,
                                   build(closed_).view().wide.triangles.ids));
    expect_forms(trees, false, true);
    EXPECT_EQ(files().size(), 2u);
}

TEST_F(BodyTreesTest, ALongJobMakesPointsWhichShorterOnesFind) {
    const auto makes_and_has = [&](bool makes, const fs::path& folder) {
        TreeCache cache(folder);
        const Trees trees =
            make_body_trees({closed_, open_}, {.makes_points = makes}, cache, pool_);
        EXPECT_THAT(cache.take_warnings(), IsEmpty());
        const bool has = !trees[0]->view().wide.support.sets.empty();
        EXPECT_EQ(!trees[1]->view().wide.support.sets.empty(), has);
        expect_forms(trees, false, true);
        return has;
    };
    EXPECT_FALSE(makes_and_has(false, folder_));
    EXPECT_EQ(files().size(), 2u);
    EXPECT_TRUE(makes_and_has(true, folder_));
    EXPECT_EQ(files().size(), 4u);
    EXPECT_TRUE(makes_and_has(false, folder_));
    EXPECT_TRUE(makes_and_has(true, fs::path())) << "without a cache";
    for (const Trees& trees : make({huge_, huge_}, {.makes_points = true})) {
        EXPECT_TRUE(trees[0]->view().wide.support.sets.empty());
    }
}

TEST_F(BodyTreesTest, DamagedPointsAreAWarningAndAreMadeAgain) {
    TreeCache cache(folder_);
    const auto make_trees = [&] {
        return make_body_trees({closed_, closed_}, {.makes_points = true}, cache, pool_);
    };
    static_cast<void>(make_trees());
    const std::vector<fs::path> all = files();
    const auto points =
        std::ranges::find(all, ".points", [](const fs::path& file) { return file.extension(); });
    ASSERT_NE(points, all.end());
    write_text(*points, "damaged");
    EXPECT_FALSE(make_trees()[0]->view().wide.support.sets.empty());
    EXPECT_THAT(cache.take_warnings(), ElementsAre(HasSubstr("support points are not used")));
    EXPECT_FALSE(make_trees()[0]->view().wide.support.sets.empty());
    EXPECT_THAT(cache.take_warnings(), IsEmpty());
}

} // namespace
} // namespace cd::tests
