// Proves that CAD models and archives are distinguished from meshes, and the message says what to
// do.
#include "client/import/foreign/foreign_format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

using testing::HasSubstr;
using testing::Optional;

TEST(ForeignFormat, CadModelsAndArchivesAreNamed) {
    EXPECT_THAT(foreign_format(".stp", ""), Optional(HasSubstr("CAD model (STEP)")));
    EXPECT_THAT(foreign_format(".obj", "ISO-10303-21;\n"), Optional(HasSubstr("(STEP)")));
    EXPECT_THAT(foreign_format(".sldprt", ""), Optional(HasSubstr("SolidWorks")));
    EXPECT_THAT(foreign_format(".gz", ""), Optional(HasSubstr("archive (gzip); unpack it")));
}

TEST(ForeignFormat, MeshesAreNotNamedAsForeign) {
    for (const char* extension :
         {".obj", ".stl", ".ply", ".off", ".glb", ".gltf", ".dae", ".3mf", ".ac", ".npz", ""}) {
        EXPECT_EQ(foreign_format(extension, "solid x"), std::nullopt) << extension;
    }
}

} // namespace cd::tests
