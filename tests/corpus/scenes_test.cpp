// Proves that the hard scenes are bit-identical everywhere and open or closed as declared, and that
// trees of every kind, wide and binary, find exactly each scene's contacts on every SIMD target:
// none is lost in boxes, none invented.
#include "tests/corpus/scenes.hpp"

#include "common/search/contact_search.hpp"
#include "tests/corpus/categories.hpp"
#include "tests/corpus/fingerprint.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_oracle.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace cd::tests {

namespace {

const std::map<std::string, std::uint64_t> golden{
    {"stacked boxes, dyadic", 0x223c6a79f64bf365},
    {"stacked boxes, dyadic, moved", 0xed297e77894bdd58},
    {"stacked boxes, dyadic, half a cell aside", 0x55ad9f3b9b667eb8},
    {"stacked boxes, dyadic, a third of a cell aside", 0x156dfc8c4d174698},
    {"stacked boxes, edge on edge", 0x934279a843f11cc5},
    {"stacked boxes, corner on corner", 0x5c925413eef6e838},
    {"stacked boxes, one step apart", 0xcf74ed6e7f71b199},
    {"stacked boxes, one step into each other", 0xe9485315660bc92d},
    {"stacked boxes, 1e-9 into each other", 0xac4672f8ddb4bcb2},
    {"stacked boxes, both turned by 3-4-5", 0x5bc0c9ccbad02bf8},
    {"stacked boxes, upper turned by 3-4-5", 0x3026a9f5fd2b29fc},
    {"stacked boxes, decimal", 0xdbe42fe719c48f19},
    {"stacked boxes, decimal, from 0.3", 0xc6d6004aff4ecb7d},
    {"stacked boxes, decimal, moved by 0.1 0.2 0.5", 0xf1f73fefa3d57f24},
    {"stacked boxes, decimal, both moved", 0x9bf779959386f603},
    {"boxes crossing along their grid lines", 0x8694b2b4ac610ac5},
    {"boxes crossing along their grid lines, both posed", 0x3871a198edfe5e80},
    {"boxes crossing, one axis in common", 0x8694f2b4ac617785},
    {"boxes crossing, end to end", 0xa690c9a00701aa18},
    {"boxes crossing, bars in one plane", 0xb1eae1ee51cf74e5},
    {"boxes crossing, bars in one plane, both posed", 0x7d25930b31880645},
    {"boxes crossing, a coarse one through a fine one", 0xfc49d27a83a06485},
    {"boxes crossing, generic", 0x2756311f8f987bb9},
    {"boxes apart in the corner of a grid", 0x334c6467ea8f8d11},
    {"nested boxes, free", 0xbf86322620840204},
    {"nested boxes, on the floor", 0xc921bccea85181e5},
    {"nested boxes, on the floor of a coarse one", 0x7deef4394edd4735},
    {"nested boxes, in a corner", 0x9f5a738b14ecaa35},
    {"nested, a corner on the floor", 0xf1c61ab894b2f485},
    {"nested, corners on all walls", 0xbec47dc17f7c7865},
    {"nested, edges on the walls", 0xfbf10273710fcc45},
    {"nested boxes, the smaller first", 0x318a46d1e98ccbe4},
    {"nested boxes, free, both posed", 0x0727094f7e554b44},
    {"a box turned by 90 degrees beside it", 0x1e9ad2701979c245},
    {"a box turned by 90 degrees, rounded, beside it", 0x89dd310c65ae77cd},
    {"a box turned by 90 degrees, rounded quaternion, on it", 0x5b0745c400cb7af8},
    {"a box turned by 45 degrees, edge on face", 0x59f6df07d4a3aaea},
    {"a box turned by 45 degrees, edge on face, quaternion", 0x81e7315aab89f633},
    {"a box turned by 45 degrees on top", 0xc51313a7b9ca94c5},
    {"a box on itself", 0xf9fdce7e0a84a805},
    {"a box on itself, posed by a quaternion", 0xd0098afed22208a5},
    {"a box on itself, posed by a matrix", 0x67fbf330bfa36c9d},
    {"a box on itself, a quaternion and its rounded matrix", 0x3144d847d6b224de},
    {"a box on itself, upside down", 0x26a3b047166f8544},
    {"a sphere on itself", 0xeae36b716c15fba5},
    {"a sphere on itself, posed", 0x58b4ab4bd24b1355},
    {"a sphere on itself, posed by a rounded matrix", 0x5fde9137f72152a5},
    {"a sphere on itself, a quaternion and its rounded matrix", 0xa9bbf34a46704cbd},
    {"a sphere on itself, turned a quarter", 0x70157a8bc653abf9},
    {"tangent spheres", 0xa0b4698ca2239865},
    {"tangent spheres, one step apart", 0x767aad0e7fbe6824},
    {"tangent spheres, one step into each other", 0x05b31749ce9c8fdd},
    {"tangent spheres, posed by rational turns", 0xb34a8ba6c91a5f83},
    {"tangent spheres, face to face", 0xab86484179060f88},
    {"spheres, crossing", 0xa29ba4f010dfbf6d},
    {"spheres, apart", 0x03d36d9116819f20},
    {"a sphere inside", 0x085c45de9a1b0d50},
    {"a sphere inside, tangent", 0xb4207fd7aeb65d88},
    {"a sphere inside, one step from the wall", 0xdd17f681646781bc},
    {"tori, linked", 0x79242dc5beafd2a4},
    {"tori, stacked", 0x638aa18cc85af3e8},
    {"tori, side by side", 0x70b6e9edc741b221},
    {"tori, crossing", 0x36a66fd809b52205},
    {"tori, one on itself", 0xda9c86959a93c325},
    {"gears, meshing", 0xd781f700c196d439},
    {"gears, tip to tip", 0xce9b006df66b5f71},
    {"gears, tip into tip", 0x252e2d2927ec56b6},
    {"gears, stacked", 0x057187bbdf854448},
    {"gears, stacked by half a tooth", 0x8df5ee1bf82ec664},
    {"gears, meshing, both posed", 0x6067824ee9b14f9e},
    {"gears, one on itself, posed", 0xace7b81b0e7291f5},
    {"gears, one on itself, a tooth further", 0x7574658f8949acf0},
    {"terrain on itself", 0xdaa584d119af82bd},
    {"terrain lifted by 1e-9", 0x15d3610c0c5124b8},
    {"terrain lifted by 1e-9 by its pose", 0x4e6755d2f1ab7ec2},
    {"terrain in UTM coordinates on itself", 0xd0c906a4cd034425},
    {"terrain in UTM coordinates lifted by 1e-9", 0x6aeb71d00b80330a},
    {"terrain shifted by a cell", 0x4deb9e540a544c70},
    {"terrain over other terrain", 0x855448f3efb148ee},
    {"terrain tiles, edge on edge", 0xa4dcf5ae487dbab5},
    {"a box on terrain", 0x5ab67d52e8bfc5ad},
    {"thin walls, 1e-9 apart", 0x670a7ef0887528b1},
    {"thin walls, back to back", 0x59a88124fae8030d},
    {"thin walls, half into each other", 0x620bc53a32871c1d},
    {"thin walls, shifted along", 0x9d49c5857432eac0},
    {"thin walls, end to end", 0xb94a1679fed9fc8d},
    {"thin walls, crossing", 0x4d46bb4c44cda361},
    {"thin walls, T", 0xcb421a38814c7cf1},
    {"a thin wall within a thick one", 0x1c9e3479b2dd4644},
    {"a thin wall on a thick one", 0x143af0647b3e2d34},
    {"thin walls, crossing, both posed", 0x080ae8efdd860f33},
    {"UTM buildings, wall to wall", 0x06353cf3e6856d45},
    {"UTM buildings, wall to wall, shifted", 0xd4d22b740d2104f1},
    {"UTM buildings, 1 mm into each other", 0xb1fc2702a336b349},
    {"UTM buildings, turned rows", 0xe65c1800153fc561},
    {"UTM buildings, one in the corner of the other", 0x9d3d7bd0ca3a1c71},
    {"UTM buildings, moved there by their poses", 0x267bbdf3789eb53b},
    {"a box inside an open box", 0x6b95f86c25887560},
    {"open boxes, stacked", 0x3bc8e69e4d97a5c5},
    {"open boxes, crossing", 0x96f2502eb72d7398},
    {"an open sphere on the whole one", 0x7189fa2c9a476d85},
    {"an open sphere in a box", 0x60369514a7aad30b},
    {"a sphere of 1e-6 around a corner of one of 1e6", 0x6c3a2cd5c1321d7c},
    {"a sphere of 1e-6 on a corner of one of 1e6", 0xc2ca2fa84884987d},
    {"a sphere of 1e-6 in the middle of one of 1e6", 0x2ab1b32ff90b7add},
    {"a sphere of 1e-6 beside one of 1e6", 0x90335e67bf752025},
    {"soup 0", 0x0eedfd2661bc8cb8},
    {"degenerate soup 0", 0xc592ec8a93a6014f},
    {"degenerate soup 0, posed", 0xc394eb4bb7fd2627},
    {"soup 1", 0xfe99805713ed6735},
    {"degenerate soup 1", 0x56d5bdab475ae8c3},
    {"degenerate soup 1, posed", 0x2288ee9b499170fc},
    {"soup 2", 0xa970da1250e427a6},
    {"degenerate soup 2", 0xd58c0ac8694c0d1f},
    {"degenerate soup 2, posed", 0xcb19b7804f0c4d7d},
    {"soup 3", 0xdd3190259244bde3},
    {"degenerate soup 3", 0x6d9405c66af768ec},
    {"degenerate soup 3, posed", 0x9b4a3bd0775cf959},
    {"tiny boxes, stacked", 0x5975af7980cf24cd},
    {"tiny boxes, crossing", 0x54466edbee812dd5},
    {"tiny soup, turned", 0xca9477dca1910d87},
    {"denormal boxes, stacked", 0x3ce91dfc51059e75},
    {"denormal boxes, crossing", 0x96db3658543c0495},
    {"denormal soup, turned", 0x8d225b29a2a5988b},
    {"huge boxes, stacked", 0x75a4373474e1f262},
    {"huge boxes, crossing", 0x4d8824d94d41473d},
    {"huge soup, turned", 0xef2ec978c997c49b},
};

const std::array<BuildOptions, 3> variants{
    BuildOptions{}, BuildOptions{.leaf_triangles_max = 1}, BuildOptions{.boxes = BoxKind::Aabb}};

void expect_found(const TreeView& a,
                  const TreeView& b,
                  const PosePair& poses,
                  const std::vector<ContactPair>& expected) {
    const auto search = make_search(a, b, poses);
    search->collect(a, b);
    search->contacts().sort();
    ASSERT_EQ(search->contacts().pairs(), expected);
    ASSERT_EQ(make_search(a, b, poses)->any(a, b), !expected.empty());
}

bool is_extreme(const Mesh& mesh) {
    Vec3 low = mesh.vertices().front();
    Vec3 high = low;
    for (const Vec3& vertex : mesh.vertices()) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const double reach = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    return reach >= 0x1p50 || (high - low).maxCoeff() <= 0x1p-40;
}

} // namespace

TEST(CorpusScenes, AreTheSameEverywhere) {
    EXPECT_EQ(golden.size(), corpus_scenes().size());
    for (const Scene& scene : corpus_scenes()) {
        Fingerprint fingerprint;
        fingerprint.add(scene);
        const auto expected = golden.find(scene.name);
        ASSERT_NE(expected, golden.end()) << scene.name;
        EXPECT_EQ(fingerprint.value(), expected->second) << scene.name;
    }
}

TEST(CorpusScenes, AreAsClosedAsTheySay) {
    for (const Scene& scene : corpus_scenes()) {
        EXPECT_EQ(analyse_topology(*scene.a.mesh).is_closed(), scene.a.closed) << scene.name;
        EXPECT_EQ(analyse_topology(*scene.b.mesh).is_closed(), scene.b.closed) << scene.name;
    }
}

class SceneContacts : public testing::TestWithParam<std::string> {};

TEST_P(SceneContacts, AreExactlyThose) {
    for (const Scene* scene : scenes_of(GetParam())) {
        SCOPED_TRACE(scene->name);
        const SceneOracle oracle(*scene->a.mesh, *scene->b.mesh, scene->poses);
        for (const BuildOptions& options : variants) {
            const ObbTree a = make_tree(*scene->a.mesh, options);
            const ObbTree b = make_tree(*scene->b.mesh, options);
            // Only coordinates beyond the range of floats have no wide tree.
            ASSERT_EQ(a.view().wide.nodes.empty(), is_extreme(*scene->a.mesh));
            ASSERT_EQ(b.view().wide.nodes.empty(), is_extreme(*scene->b.mesh));
            expect_found(forms_of(a)[1], forms_of(b)[1], scene->poses, oracle.contact_pairs());
            on_every_target([&](SimdTarget) {
                expect_found(a.view(), b.view(), scene->poses, oracle.contact_pairs());
            });
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, SceneContacts, testing::ValuesIn(scene_categories()), test_name);

} // namespace cd::tests
