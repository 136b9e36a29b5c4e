// Proves that the corpus of pairs is bit-identical everywhere, that the oracle agrees with its slow
// reference on it, and that every class of pair is frequent.
#include "tests/corpus/pairs.hpp"

#include "tests/corpus/fingerprint.hpp"
#include "tests/support/clipping_oracle.hpp"
#include "tests/support/oracle.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace cd::tests {

namespace {

/// Fingerprints of the first 64 pairs of each category.
const std::map<std::string, std::uint64_t> golden{
    {"a quaternion and its rounded matrix", 0xb270e259d55725c8},
    {"boxes touching, decimal", 0xd4942dbd3540bf41},
    {"boxes touching, dyadic", 0xdeadec3a4896730f},
    {"coplanar, overlapping", 0x45fd270c23450deb},
    {"coplanar, touching along an edge", 0x3d843638ac50e91c},
    {"coplanar, touching at a vertex", 0x17ab547f90d078e3},
    {"corners, edges and faces that nearly meet in the world", 0xf8f7f21585e215d9},
    {"degenerate to a point", 0x987edbaf4fee5d69},
    {"degenerate to a segment", 0x9229fa163f634fd0},
    {"degenerate to segments and points", 0x0ff3f544e36b8c94},
    {"denormal", 0x10f2fb3182542c06},
    {"denormal, many steps", 0x70143f40500d3add},
    {"edge crossing edge", 0xc705397612032f2a},
    {"edge crossing edge, one ulp off", 0xfc2d2e3969e2ee80},
    {"edges at gaps 1e-6 to 1e-17", 0x8779bb3e6b21ed59},
    {"edges that cross in a point", 0x624fdbeb44ded205},
    {"eighth turns, rounded", 0x8a21638ce4e94b18},
    {"far away, small features", 0xb15c4d7aa4d17005},
    {"far poses that cancel", 0x2bb068d479aa306a},
    {"gaps and penetrations 1e-6 to 1e-17", 0xfeee91f5301943d3},
    {"huge", 0x9c117d6464200735},
    {"huge 2^400, nearly touching", 0x9786387244912433},
    {"identical", 0xe4ea5f432ef3a945},
    {"identical, posed together", 0xcdb46e3d234b3ee9},
    {"lattice in one plane", 0xc6c6f50cd0aaae2d},
    {"lattice under quarter turns", 0xbb1c8fa16df13ac5},
    {"lattice: ties and degenerate ones", 0xc2a6c3ec4f6883b8},
    {"matrices that are not rigid", 0xb2a04eb72b67cdf8},
    {"near-coplanar 1e-8 to 1e-16", 0x3dcd5a6772dcd3e6},
    {"nearly coplanar", 0x2a59bb1b18580ad6},
    {"needles 1e6 to 1e12", 0xccd0e00cdc21dfe3},
    {"of scenes: UTM buildings", 0x96c8cf64550363eb},
    {"of scenes: boxes that cross along their grid lines", 0xa4aad8f1d85b1ad8},
    {"of scenes: gears", 0x855f75beda5bae52},
    {"of scenes: nested boxes", 0x2ab5b4eada2835f5},
    {"of scenes: spheres", 0x92f309c04a42d8e0},
    {"of scenes: stacked boxes", 0x0f3a3aa93b79dc47},
    {"of scenes: terrain", 0x8c42ee01cf8fb60d},
    {"of scenes: thin walls", 0x223cf59fa6448bed},
    {"of scenes: tori", 0x8d1344c895247130},
    {"of scenes: turned boxes", 0x07d3b387c231c01b},
    {"offset 1e7 with features of 1e-3", 0xea69fee48c9360d7},
    {"one large, one small", 0xb4bf7466743a0406},
    {"one pose for both: shared vertices", 0xe09dd7e903422fd9},
    {"one rotation written in two ways", 0x7df7f68d868aa7d8},
    {"quarter turns, exact", 0xe2517e1e122aa699},
    {"quarter turns, rounded", 0x182bb2cd424c7888},
    {"quaternions of any norm", 0x2ccad5709f126910},
    {"random", 0x698494e1ec7d1897},
    {"random, both posed", 0x4557885d8910d9cd},
    {"random, matrix poses", 0x53fadd96e328db64},
    {"rational rotations", 0xf07e2025691c5bb8},
    {"scales 1e-6 with 1e6", 0x6a3b0b251c98c31b},
    {"shared edge", 0x95a3f6df1910443b},
    {"shared vertex", 0x007a243f06fdb99d},
    {"slivers 1e6 to 1e12", 0xeba2a4476c0df868},
    {"slivers and needles", 0xcfdfe8217e5cd1c5},
    {"tiny", 0x5c496e7051dc12f5},
    {"tiny 1e-20", 0xb7adb972bad628ca},
    {"vertex on face", 0x9052183d6fa51e95},
    {"vertex on face, one ulp off", 0xbe866c4a8f87c056},
    {"walls in UTM coordinates", 0x137010031c5f120c},
};

} // namespace

TEST(CorpusPairs, AreTheSameEverywhere) {
    EXPECT_EQ(golden.size(), pair_categories().size());
    for (const std::string& category : pair_categories()) {
        Fingerprint fingerprint;
        for (std::uint64_t seed = 0; seed < 64; ++seed) {
            fingerprint.add(corpus_pair(category, seed));
        }
        const auto expected = golden.find(category);
        ASSERT_NE(expected, golden.end()) << category;
        EXPECT_EQ(fingerprint.value(), expected->second) << category;
    }
}

TEST(CorpusPairs, TheOracleEqualsItsSlowTwin) {
    std::map<PairClass, int> seen;
    for (const std::string& category : pair_categories()) {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const PosedPair c = corpus_pair(category, seed);
            const PairClass expected = clipping_oracle_class(c.a, c.b, c.poses);
            ASSERT_EQ(oracle_class(c.a, c.b, c.poses), expected) << category << ", seed " << seed;
            ++seen[expected];
        }
    }
    EXPECT_EQ(seen.size(), 4u);
    for (const auto& [kind, count] : seen) {
        EXPECT_GT(count, 200) << static_cast<int>(kind);
    }
}

} // namespace cd::tests
