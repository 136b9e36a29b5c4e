// Proves that --version describes the build, in text and in JSON, and that nothing else is taken
// for such output.
#include "common/core/build_info.hpp"

#include "common/core/version.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

std::string answer(const std::vector<std::string>& arguments) {
    return version_answer("cdx", "avx2", arguments).value_or("none");
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(BuildInfo, TheTextHasALineForEachFact) {
    const std::string text = answer({"--version"});
    EXPECT_TRUE(text.starts_with("cdx " + std::string(version) + "\n  commit")) << text;
    EXPECT_TRUE(has(text, "\n  compiler    ")) << text;
    EXPECT_TRUE(has(text, "\n  SIMD        avx2\n")) << text;
    EXPECT_TRUE(has(text, "\n  libraries   assimp 5.")) << text;
    EXPECT_TRUE(has(text, ", OpenSSL 3.")) << text;
    for (const char* const library : {", Expat 2.", ", fmt 9.", ", HDF5 1.", ", pugixml 1."}) {
        EXPECT_TRUE(has(text, library)) << text;
    }
    EXPECT_FALSE(build_commit().empty());
}

TEST(BuildInfo, JsonIsAskedForAfterTheFlag) {
    for (const auto& arguments : {std::vector<std::string>{"--version", "-o", "json"},
                                  {"--version", "--output", "json"},
                                  {"--version", "-ojson"}}) {
        const std::string text = answer(arguments);
        EXPECT_TRUE(text.starts_with("{\n  \"program\": \"cdx\",\n")) << text;
        EXPECT_TRUE(has(text, "\"commit\": \"" + std::string(build_commit()) + "\"")) << text;
        EXPECT_TRUE(has(text, "\"simd\": \"avx2\",\n  \"libraries\": {\n    \"assimp\": \""))
            << text;
        EXPECT_TRUE(text.ends_with("\"\n  }\n}\n")) << text;
    }
}

TEST(BuildInfo, OtherArgumentsAreNotAnswered) {
    EXPECT_EQ(answer({}), "none");
    EXPECT_EQ(answer({"run", "--version"}), "none");
    EXPECT_EQ(answer({"--version", "-o", "xml"}), "none");
    EXPECT_EQ(answer({"--version", "--listen", "x"}), "none");
}

} // namespace cd::tests
