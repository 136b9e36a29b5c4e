// Proves that a glTF file is refused by node where its transform holds no numbers, or its nodes are
// nested without a bound.
#include "client/import/gltf_check.hpp"

#include "tests/client/import/import_text.hpp"
#include "tests/support/memory_bound.hpp"

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// One triangle, whose mesh is 0: nine floats and three indices.
std::string gltf(const std::string& nodes) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},)"
           R"({"buffer":0,"byteOffset":36,"byteLength":6}],"accessors":[)"
           R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

std::string chain(int length) {
    std::string nodes;
    for (int i = 1; i <= length; ++i) {
        nodes += R"({"children":[)" + std::to_string(i) + "]},";
    }
    return gltf(nodes + R"({"mesh":0})");
}

} // namespace

TEST(GltfCheck, TransformsThatAreNoNumbersAreNamedByNode) {
    const auto moved = [](const std::string& number) {
        return gltf(R"({"mesh":0,"translation":[0,0,)" + number + "]}");
    };
    EXPECT_TRUE(import_text("good.gltf", moved("1.5")));
    EXPECT_THAT(error_of("null.gltf", moved("null")), HasSubstr("node 0"));
    EXPECT_THAT(error_of("large.gltf", moved("1e39")), HasSubstr("face 0"));
}

TEST(GltfCheck, NestingHasABound) {
    EXPECT_TRUE(import_text("nested.gltf", chain(900)));
    EXPECT_THAT(error_of("deep.gltf", chain(100'000)), HasSubstr("node 1000: is nested more than"));
}

TEST(GltfCheck, ANodeHasOneParent) {
    EXPECT_THAT(error_of("twice.gltf", gltf(R"({"children":[1,2]},{"children":[2]},{"mesh":0})")),
                HasSubstr("node 2: is the child of two nodes"));
    EXPECT_THAT(error_of("again.gltf", gltf(R"({"children":[1,1]},{"mesh":0})")),
                HasSubstr("node 1: is the child of two nodes"));
    EXPECT_THAT(error_of("cycle.gltf", gltf(R"({"children":[1]},{"children":[0],"mesh":0})")),
                HasSubstr("is nested more than"));
}

/// A scene that names a node again and again stands for no more than the node.
TEST(GltfCheck, WhatASceneNamesOftenTakesNoMemory) {
    constexpr int often = 20'000;
    std::string named;
    std::string children;
    std::string nodes;
    for (int i = 1; i <= often; ++i) {
        named += ",0";
        children += (i == 1 ? "" : ",") + std::to_string(i);
        nodes += ",{}";
    }
    const TemporaryFolder folder;
    write_text(folder / "named.gltf",
               R"({"scenes":[{"nodes":[0)" + named + R"(]}],"nodes":[{"children":[)" + children +
                   "]}" + nodes + "]}");
    const MemoryBound bound(1u << 30);
    EXPECT_TRUE(check_gltf(folder / "named.gltf", false));
}

} // namespace cd::tests
