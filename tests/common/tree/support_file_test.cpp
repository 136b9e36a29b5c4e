// Proves that support points come back from disk bit for bit and part bodies as made ones do, and
// that a damaged file, or one of another tree, is rejected.
#include "common/tree/support_file.hpp"

#include "common/search/wide_search.hpp"
#include "common/tree/tree_file.hpp"
#include "common/tree/wide/wide_tree.hpp"
#include "tests/support/process.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace cd::tests {

namespace {

class SupportFile : public testing::Test {
  protected:
    SupportFile() {
        with_points_ = tree_;
        with_points_.prepare_planes();
    }
    [[nodiscard]] static Sha256 key_of(const ObbTree& tree) {
        return tree_key(tree.mesh().hash(), BuildOptions{});
    }
    [[nodiscard]] Status write() const {
        return write_support_file(path_, with_points_, key_of(tree_), Durability::Unsynced);
    }
    [[nodiscard]] Result<std::shared_ptr<const ObbTree>> read(const ObbTree& tree) const {
        return read_support_file(path_, tree, key_of(tree));
    }

    TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "one.points";
    ObbTree tree_ = make_tree(make_torus(1, 0.3, 60, 30));
    ObbTree with_points_ = tree_;
};

TEST_F(SupportFile, PointsComeBackAsTheyWere) {
    EXPECT_EQ(read(tree_).error().code, ErrorCode::NotFound);
    ASSERT_TRUE(write());
    const auto back = read(tree_);
    ASSERT_TRUE(back) << back.error().detail;
    const SupportView made = with_points_.view().wide.support;
    const SupportView found = back.value()->view().wide.support;
    EXPECT_TRUE(same_bytes(found.sets, made.sets));
    EXPECT_TRUE(same_bytes(found.columns, made.columns));
    EXPECT_EQ(found.center, made.center);
    EXPECT_EQ(found.radius, made.radius);
    EXPECT_TRUE(same_bytes(back.value()->view().wide.nodes, tree_.view().wide.nodes));
    EXPECT_TRUE(back.value()->has_binary());
}

TEST_F(SupportFile, PointsFromDiskPartBodies) {
    ASSERT_TRUE(write());
    const auto back = read(tree_).value();
    std::mt19937_64 random(4);
    std::array<std::uint64_t, 3> box_tests{};
    int free = 0;
    for (int i = 0; i < 100; ++i) {
        const PosePair poses{Pose{}, make_pose(random, 1.5)};
        std::array<std::uint64_t, 3> contacts{};
        const std::array<const ObbTree*, 3> trees{&tree_, &with_points_, back.get()};
        for (std::size_t k = 0; k < trees.size(); ++k) {
            WideSearch search(poses);
            search.collect(trees[k]->view(), trees[k]->view());
            contacts[k] = search.contacts().count();
            box_tests[k] += contacts[k] == 0 ? search.report().statistics.box_tests : 0;
        }
        EXPECT_EQ(contacts[1], contacts[0]);
        EXPECT_EQ(contacts[2], contacts[0]);
        free += contacts[0] == 0 ? 1 : 0;
    }
    EXPECT_GT(free, 10);
    EXPECT_EQ(box_tests[1], box_tests[2]);
    EXPECT_LT(box_tests[2], box_tests[0] * 3 / 4);
}

TEST_F(SupportFile, AnyChangedByteIsDamage) {
    ASSERT_TRUE(write());
    const std::string whole = read_text(path_);
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 300) {
        std::string text = whole;
        text[i] ^= 1;
        write_text(path_, text);
        const auto back = read(tree_);
        ASSERT_FALSE(back) << "byte " << i;
        EXPECT_EQ(back.error().code, ErrorCode::Io);
        EXPECT_THAT(back.error().detail, testing::HasSubstr(path_.string()));
    }
}

TEST_F(SupportFile, PointsOfAnotherTreeAreRefused) {
    ASSERT_TRUE(write());
    const ObbTree other = make_tree(make_torus(1, 0.3, 60, 31));
    EXPECT_EQ(read(other).error().code, ErrorCode::Io) << "the key differs";
    EXPECT_THAT(read_support_file(path_, other, key_of(tree_)).error().detail,
                testing::HasSubstr("not those of the tree"));
}

TEST_F(SupportFile, IndicesOutOfBoundsAreRefused) {
    const WideView& wide = with_points_.view().wide;
    const std::vector<SupportSet> sets(wide.support.sets.begin(), wide.support.sets.end());
    const auto is_refused = [&](auto change) {
        std::vector<SupportSet> changed = sets;
        change(changed);
        WideView view = wide;
        view.support.sets = changed;
        const ObbTree tree(tree_.mesh_pointer(),
                           tree_.binary(),
                           std::make_shared<const WideTree>(view, nullptr),
                           tree_.topology());
        EXPECT_TRUE(write_support_file(path_, tree, key_of(tree_), Durability::Unsynced));
        return !read(tree_);
    };
    ASSERT_TRUE(sets.front().is_chosen);
    ASSERT_FALSE(sets.back().is_chosen);
    EXPECT_FALSE(is_refused([](auto&) {}));
    EXPECT_TRUE(is_refused([](auto& all) { all.pop_back(); }));
    EXPECT_TRUE(is_refused([](auto& all) { all.front().first = 0xFFFFFFFF; }));
    EXPECT_TRUE(is_refused([](auto& all) { all.front().count = 0xFFFF; }));
    EXPECT_TRUE(is_refused([](auto& all) { all.front().count = 0; }));
    EXPECT_TRUE(is_refused([](auto& all) { all.back().first += 0x10000; }));
}

} // namespace

} // namespace cd::tests
