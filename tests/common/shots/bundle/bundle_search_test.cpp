// Proves that what a bundle's search tells is true and whole, and that its error bounds are needed:
// each pair that it decides is judged by integers, and each pair that they know is told.
#include "common/shots/bundle/bundle_search.hpp"

#include "common/shots/segment_hit.hpp"
#include "tests/support/bundle_cases.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/shot_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace cd::tests {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>; ///< Triangle and line, by index in the mesh.

/// What a search tells of a case.
struct Told {
    std::map<Pair, std::uint8_t> passes;
    std::set<Pair> open;
    std::size_t pairs = 0;

    friend bool operator==(const Told&, const Told&) = default;
};

std::optional<Told>
told_of(const ObbTree& a, const ObbTree& b, const PosePair& poses, double bound_scale = 1) {
    const WideView of_a = a.view().wide;
    const WideView of_b = b.view().wide;
    ParallelLines lines;
    BundleSearch search(bound_scale);
    if (of_a.nodes.empty() || of_b.nodes.empty() || !lines.assign(of_b) ||
        !search.start(of_a, lines, poses)) {
        return std::nullopt;
    }
    Told told;
    std::set<std::uint32_t> triangles;
    while (!search.is_done()) {
        const BundleSearch::Found found = search.next();
        for (std::size_t i = 0; i < found.triangles.size(); ++i) {
            const PassedTriangle& passed = found.triangles[i];
            EXPECT_TRUE(triangles.insert(passed.slot).second) << "a triangle is told twice";
            for (const std::uint32_t place : found.lines_of(i)) {
                const std::uint32_t line = of_b.triangles.ids[lines.slots()[place]];
                told.passes[{of_a.triangles.ids[passed.slot], line}] = passed.flags;
            }
        }
        for (const Candidate& pair : found.open) {
            told.open.insert({of_a.triangles.ids[pair.a], of_b.triangles.ids[pair.b]});
        }
        told.pairs += found.lines.size() + found.open.size();
    }
    return told;
}

/// Counts of pairs.
struct Judged {
    int passes = 0;
    int misses = 0;
    int open = 0;
    int wrong = 0;

    [[nodiscard]] int decided() const { return passes + misses; }
};

/// Judges all pairs of a case by `flags_of(corners, line)`.
template <class FlagsOf>
void judge(const BundleCase& c, const Told& told, const FlagsOf& flags_of, Judged& judged) {
    constexpr int inside = hit_flag::edge | hit_flag::corner;
    for (std::uint32_t line = 0; line < c.lines.size(); ++line) {
        for (std::uint32_t i = 0; i < c.body.triangles().size(); ++i) {
            const std::optional<std::uint8_t> truth = flags_of(c.body.corners(i), c.lines[line]);
            const auto pass = told.passes.find({i, line});
            if (told.open.contains({i, line})) {
                ++judged.open;
            } else if (pass == told.passes.end()) {
                ++judged.misses;
                judged.wrong += truth ? 1 : 0;
            } else {
                ++judged.passes;
                judged.wrong += truth == pass->second && (*truth & inside) == 0 ? 0 : 1;
            }
        }
    }
}

/// Searches a case of each kind and round, and judges the search.
Judged judged_kind(const std::string& kind, std::uint64_t rounds, double bound_scale = 1) {
    Judged judged;
    for (SeededRandom random : seeds(rounds)) {
        const BundleCase c = make_bundle_case(kind, random);
        const auto told =
            told_of(make_tree(c.body), make_tree(mesh_of(c.lines)), c.poses, bound_scale);
        if (!told) {
            continue;
        }
        EXPECT_EQ(told->pairs, told->passes.size() + told->open.size()) << "a pair is told twice";
        SegmentHit exact(c.poses, HitStage::Integer);
        judge(
            c,
            *told,
            [&](const Corners& t, const Segment& line) { return exact.flags(t, line); },
            judged);
    }
    return judged;
}

/// Lines, of a grid or not, and triangles one edge of which passes a line by some roundings.
BundleCase brink_case(std::mt19937_64& random, bool is_grid) {
    const double far = std::ldexp(1.0, static_cast<int>(random() % 4));
    const PosePair poses{random() % 2 == 0 ? Pose() : make_pose(random, far),
                         make_pose(random, far)};
    const Mat3 from_world = poses.a.rotation().transpose();
    const auto in_a = [&](const Vec3& of_b) {
        return Vec3(from_world * (poses.b.apply(of_b) - poses.a.translation()));
    };
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<Segment> lines;
    if (is_grid) {
        lines = grid_lines(random, 0, {10, 10}, far / 8, 0, {-9 * far, 9 * far});
    }
    for (std::uint32_t i = 0; i < 300; i += 3) {
        const Vec3 at = is_grid ? lines[random() % lines.size()].p : random_point(random, far);
        const Vec3 way = random_point(random, 1);
        vertices.push_back(in_a(at - way));
        vertices.push_back(in_a(at + uniform(random, 0.5, 2) * way));
        vertices.push_back(in_a(at + random_point(random, 1)));
        triangles.push_back({i, i + 1, i + 2});
        if (!is_grid) {
            lines.push_back({Vec3(-9 * far, at.y(), at.z()), Vec3(9 * far, at.y(), at.z())});
        }
    }
    return {make_mesh(std::move(vertices), std::move(triangles)), std::move(lines), poses};
}

Judged judged_brinks(std::uint64_t rounds, bool is_grid, double bound_scale) {
    Judged judged;
    for (SeededRandom random : seeds(rounds)) {
        const BundleCase c = brink_case(random, is_grid);
        const auto told =
            told_of(make_tree(c.body), make_tree(mesh_of(c.lines)), c.poses, bound_scale);
        SegmentHit exact(c.poses, HitStage::Integer);
        judge(
            c,
            told.value(),
            [&](const Corners& t, const Segment& line) { return exact.flags(t, line); },
            judged);
    }
    return judged;
}

} // namespace

class BundleSearchTest : public testing::TestWithParam<std::string> {};

TEST_P(BundleSearchTest, ToldPairsAreTrueAndWhole) {
    EXPECT_EQ(judged_kind(GetParam(), raised(40)).wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(,
                         BundleSearchTest,
                         testing::ValuesIn(bundle_kinds()),
                         [](const auto& kind) {
                             std::string name;
                             for (const char c : kind.param) {
                                 name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                             }
                             return name;
                         });

TEST(BundleSearch, MostPairsAreDecided) {
    Judged all;
    for (const std::string& kind : bundle_kinds()) {
        const Judged judged = judged_kind(kind, 4);
        all.passes += judged.passes;
        all.misses += judged.misses;
        all.open += judged.open;
    }
    EXPECT_GT(all.passes, 300);
    EXPECT_GT(all.misses, 2000);
    EXPECT_GT(all.open, 300) << "the cases are not hard";
}

TEST(BundleSearch, AgreesWithRationals) {
    Judged judged;
    for (SeededRandom random : seeds(raised(60))) {
        const std::vector<std::string> kinds = bundle_kinds();
        const BundleCase c = make_bundle_case(kinds[random.seed % kinds.size()], random);
        const auto told = told_of(make_tree(c.body), make_tree(mesh_of(c.lines)), c.poses);
        if (!told) {
            continue;
        }
        judge(
            c,
            *told,
            [&](const Corners& t, const Segment& line) {
                const auto hit = oracle_hit(t, line, c.poses);
                return hit ? std::optional(hit->flags) : std::nullopt;
            },
            judged);
    }
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_GT(judged.decided(), 500);
}

TEST(BundleSearch, RandomLinesAreToldAsIntegersDo) {
    Judged judged;
    for (SeededRandom random : seeds(raised(40))) {
        BundleCase c{make_sphere(2), {}, {make_pose(random, 0.3), make_pose(random, 0.3)}};
        c.lines = grid_lines(random, random() % 3, {9, 7}, 0.25, 1, {3, -3});
        const auto told = told_of(make_tree(c.body), make_tree(mesh_of(c.lines)), c.poses);
        SegmentHit exact(c.poses, HitStage::Integer);
        judge(
            c,
            told.value(),
            [&](const Corners& t, const Segment& line) { return exact.flags(t, line); },
            judged);
    }
    EXPECT_EQ(judged.wrong, 0);
    EXPECT_EQ(judged.open, 0);
    EXPECT_GT(judged.decided(), 100'000);
}

TEST(BundleSearch, BoundsThatAreScaledDownAreCaught) {
    for (const bool is_grid : {false, true}) {
        const Judged judged = judged_brinks(raised(20), is_grid, 1);
        EXPECT_EQ(judged.wrong, 0);
        EXPECT_GT(judged.open, 1000);
        EXPECT_GT(judged_brinks(20, is_grid, 0x1p-14).wrong, 0);
    }
}

TEST(BundleSearch, TellsTheSameOnEveryTarget) {
    for (SeededRandom random : seeds(raised(10))) {
        const ObbTree body = make_tree(make_sphere(2));
        const ObbTree lines = make_tree(
            mesh_of(grid_lines(random, random() % 3, {12, 9}, 0.2, random() % 2, {3, -3})));
        const PosePair poses{make_pose(random, 0.3), make_pose(random, 0.3)};
        const auto expected = told_of(body, lines, poses);
        on_every_target([&](SimdTarget) { EXPECT_EQ(told_of(body, lines, poses), expected); });
    }
}

TEST(BundleSearch, TellsTheLinesOfALargeTriangleTogether) {
    std::mt19937_64 random(1);
    const Mesh triangles = make_mesh({Vec3(0, -9, -9), Vec3(0, 9, -9), Vec3(0, 0, 18)},
                                     {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}});
    const ObbTree body = make_tree(triangles);
    const ObbTree lines = make_tree(mesh_of(grid_lines(random, 0, {37, 31}, 0.1, 0, {3, -3})));
    on_every_target([&](SimdTarget) {
        const auto told = told_of(body, lines, {});
        ASSERT_TRUE(told);
        EXPECT_EQ(told->passes.size(), 3u * 37 * 31);
        EXPECT_EQ(told->pairs, told->passes.size());
    });
}

TEST(BundleSearch, RefusesBundlesThatAreNotOnlyTurned) {
    const ObbTree body = make_tree(make_box(Vec3(2, 2, 2)));
    std::mt19937_64 random(1);
    const ObbTree lines = make_tree(mesh_of(grid_lines(random, 0, {3, 3}, 0.3, 0, {3, -3})));
    const Pose matrix = Pose::from_matrix(2 * Mat3::Identity(), Vec3::Zero());
    EXPECT_EQ(told_of(body, lines, {Pose(), matrix}), std::nullopt);
    EXPECT_TRUE(told_of(body, lines, {matrix, Pose()}));
}

TEST(BundleSearch, LooksOnlyWhereLinesAre) {
    const ObbTree body = make_tree(make_gridded_box(Vec3(8, 8, 8), 40));
    const WideView view = body.view().wide;
    const ObbTree line = make_tree(mesh_of({{Vec3(9, 0.013, 0.017), Vec3(-9, 0.013, 0.017)}}));
    ParallelLines lines;
    ASSERT_TRUE(lines.assign(line.view().wide));
    BundleSearch search;
    ASSERT_TRUE(search.start(view, lines, {}));
    std::size_t passes = 0;
    while (!search.is_done()) {
        passes += search.next().lines.size();
    }
    EXPECT_EQ(passes, 2u);
    EXPECT_LT(search.box_tests(), body.mesh().triangles().size() / 20);
}

} // namespace cd::tests
