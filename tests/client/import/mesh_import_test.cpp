// Proves that the importer accepts a file whole or refuses it with one clear line: real models with
// known counts, the order of triangles, units, and archives of arrays.
#include "client/import/mesh_import.hpp"

#include "client/formats/npz.hpp"
#include "client/report/inspect.hpp"
#include "tests/client/import/import_text.hpp"
#include "tests/support/memory_bound.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

struct Model {
    const char* file;
    std::uint64_t triangles;
    std::uint64_t degenerate;
    std::uint64_t duplicate;
    double size[3];
    std::uint64_t edges[3]; ///< Boundary, non-manifold, inconsistent.
};

/// Prints the name that test runners show.
void PrintTo(const Model& model, std::ostream* out) {
    *out << model.file;
}

constexpr Model models[] = {
    {"audi_body.obj", 41'868, 0, 18'646, {4.87779, 2.18632, 1.2802}, {290, 27'306, 1'336}},
    {"curiosity_rover.stl", 149'656, 2, 7, {3.94473, 2.74499, 2.21469}, {4'571, 2'171, 193}},
    {"drivaer_fastback.ply", 417'114, 0, 0, {4.61258, 2.0298, 1.41838}, {0, 33, 0}},
    {"hatchback.obj", 788, 0, 0, {84.2702, 157.524, 61.7281}, {8, 0, 0}},
    {"jet_fighter.obj", 36'446, 6, 4, {13.9876, 4.77665, 10.026}, {4'644, 259, 10}},
    {"lugged_wheel.obj", 11'182, 0, 0, {0.898808, 0.326872, 0.89836}, {0, 0, 0}},
    {"m113_apc.glb", 348'519, 1, 0, {5.4007, 2.686, 2.83176}, {51'848, 92, 32}},
    {"man_kat1_8x8.glb", 53'711, 1, 9, {9.71773, 2.47294, 3.24483}, {6'901, 11, 0}},
    {"motorbike.ply", 331'653, 0, 67'326, {2.04281, 0.682556, 1.35156}, {49, 100'089, 0}},
    {"polaris_ranger.dae", 7'714, 0, 0, {58.7465, 107.467, 76.7909}, {806, 6, 0}},
    {"pushback_tractor.ac", 21'932, 0, 184, {9.0921, 2.2937, 3.567}, {5'196, 651, 99}},
    {"sedan.obj", 75'314, 182, 0, {4.8895, 1.84912, 1.65882}, {3'147, 187, 78}},
    {"stanford_bunny.ply", 69'451, 0, 0, {0.155699, 0.154334, 0.120673}, {223, 0, 0}},
    {"toy_truck.glb", 989, 15, 10, {1.5, 1.55, 2.8}, {81, 9, 0}},
};

class ImportModel : public testing::TestWithParam<Model> {};

} // namespace

TEST_P(ImportModel, HasTheCountsAndTheSizeThatAreKnownOfIt) {
    CD_NEEDS_MODEL(path, GetParam().file);

    const auto imported = import_mesh(path, {});
    ASSERT_TRUE(imported) << imported.error().detail;
    const MeshReport report = inspect_mesh(GetParam().file, imported.value());

    EXPECT_EQ(report.mesh().triangles().size(), GetParam().triangles);
    EXPECT_EQ(report.topology.duplicate, GetParam().duplicate);
    EXPECT_EQ(report.topology.degenerate, GetParam().degenerate);
    EXPECT_EQ(report.topology.boundary_edges, GetParam().edges[0]);
    EXPECT_EQ(report.topology.non_manifold_edges, GetParam().edges[1]);
    EXPECT_EQ(report.topology.inconsistent_edges, GetParam().edges[2]);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(report.box.size()[axis], GetParam().size[axis], 2e-5 * GetParam().size[axis]);
    }
    EXPECT_FALSE(report.mesh().parts().empty());
    EXPECT_EQ(report.mesh().parts().back().triangles_end, report.mesh().triangles().size());
}

INSTANTIATE_TEST_SUITE_P(All, ImportModel, testing::ValuesIn(models), [](const auto& param) {
    std::string name = param.param.file;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

TEST(MeshImport, TheWheelIsClosedAndTheSedanIsOpen) {
    CD_NEEDS_MODEL(wheel, "lugged_wheel.obj");
    CD_NEEDS_MODEL(sedan, "sedan.obj");
    EXPECT_TRUE(inspect_mesh("", import_mesh(wheel, {}).value()).topology.is_closed());
    EXPECT_FALSE(inspect_mesh("", import_mesh(sedan, {}).value()).topology.is_closed());
}

TEST(MeshImport, KeepsTheOrderOfFacesAndTheNamesOfParts) {
    const auto imported = import_text("two.obj",
                                      "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                      "f 1 2 3\nf 1 3 4\no right\nf 2 3 4\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    const Mesh& mesh = *imported.value().mesh;
    ASSERT_EQ(mesh.triangles().size(), 3u);
    ASSERT_EQ(mesh.parts().size(), 2u);
    EXPECT_EQ(mesh.parts()[0], (Part{"left", 0, 2}));
    EXPECT_EQ(mesh.parts()[1], (Part{"right", 2, 3}));
    EXPECT_EQ(mesh.corners(1)[2], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.corners(2)[0], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.vertices().size(), 4u);
}

TEST(MeshImport, KeepsDegenerateAndDuplicateFaces) {
    const auto imported =
        import_text("dirty.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 1 2\nf 3 1 2\n");
    ASSERT_TRUE(imported) << imported.error().detail;
    const Topology topology = analyse_topology(*imported.value().mesh);
    EXPECT_EQ(imported.value().mesh->triangles().size(), 4u);
    EXPECT_EQ(topology.degenerate, 1u);
    EXPECT_EQ(topology.duplicate, 2u);
}

TEST(MeshImport, AppliesTheUnitInDouble) {
    const TemporaryFolder folder;
    write_text(folder / "one.obj", "v 0 0 0\nv 3.3 0 0\nv 0 7.7 0\nf 1 2 3\n");
    const auto imported = import_mesh(folder / "one.obj", {0.0254});
    EXPECT_EQ(mesh_of(imported).vertices()[1].x(), 0.0254 * 3.3);
    EXPECT_EQ(mesh_of(imported).precision(), Precision::Double);
}

TEST(MeshImport, TheOriginIsSubtractedInDoubleAfterUnitAndTurn) {
    const TemporaryFolder folder;
    write_text(folder / "one.obj", "v 0 0 0\nv 3.3 0 0\nv 0 7.7 0.5\nf 1 2 3\n");
    ImportOptions options{0.0254};
    options.is_y_up = true;
    options.origin = {0.1, -0.2, 0.3};
    const auto imported = import_mesh(folder / "one.obj", options);
    const Mesh& mesh = mesh_of(imported);
    EXPECT_EQ(mesh.vertices()[1], Vec3(0.0254 * 3.3 - 0.1, 0.2, -0.3));
    EXPECT_EQ(mesh.vertices()[2], Vec3(-0.1, -(0.0254 * 0.5) + 0.2, 0.0254 * 7.7 - 0.3));
    EXPECT_EQ(mesh.precision(), Precision::Double);
    options.rounds_to_float = true;
    const auto rounded = import_mesh(folder / "one.obj", options);
    EXPECT_EQ(mesh_of(rounded).vertices()[1].x(), static_cast<float>(0.0254 * 3.3 - 0.1));
    EXPECT_EQ(mesh_of(rounded).precision(), Precision::Float);
}

TEST(MeshImport, AMeshOfFloatsKeepsThemIfTheyHoldAllDifferences) {
    const TemporaryFolder folder;
    write_text(folder / "one.obj", "v 0 0 0\nv 3 0 0\nv 0 7 0\nf 1 2 3\n");
    ImportOptions options;
    options.origin = {1.5, 0, 0};
    EXPECT_EQ(mesh_of(import_mesh(folder / "one.obj", options)).precision(), Precision::Float);
    options.origin = {0.1, 0, 0};
    EXPECT_EQ(mesh_of(import_mesh(folder / "one.obj", options)).precision(), Precision::Double);
    options.origin = {-1.7e308, 0, 0};
    write_text(folder / "one.obj", "v 0 0 0\nv 1e308 0 0\nv 0 7 0\nf 1 2 3\n");
    EXPECT_THAT(import_mesh(folder / "one.obj", options).error().detail,
                HasSubstr("one.obj: vertex 1 has a coordinate that is not finite"));
}

TEST(MeshImport, AUnitThatMakesACoordinateInfiniteIsRefusedByFace) {
    const TemporaryFolder folder;
    write_text(folder / "far.obj", "v 0 0 0\nv 1e308 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(import_mesh(folder / "far.obj", {}));
    EXPECT_THAT(import_mesh(folder / "far.obj", {1000}).error().detail, HasSubstr("far.obj:4"));
}

TEST(MeshImport, FilesThatCannotBeOpenedAreNamed) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink(folder / "loop.obj", folder / "loop.obj");
    EXPECT_THAT(import_mesh(folder / "loop.obj", {}).error().detail,
                HasSubstr("loop.obj: cannot be opened: Too many levels of symbolic links"));
    EXPECT_THAT(import_mesh(folder.path(), {}).error().detail, HasSubstr("is a folder"));
    EXPECT_THAT(import_mesh("", {}).error().detail, HasSubstr("without a name"));
}

TEST(MeshImport, RefusesWhatIsNoMesh) {
    EXPECT_THAT(error_of("empty.stl", ""), HasSubstr("empty"));
    EXPECT_THAT(error_of("text.fbx", "this is no mesh"), HasSubstr("cannot be read"));
    EXPECT_THAT(error_of("unknown.xyz1", "v 0 0 0"), HasSubstr("cannot be read"));
    EXPECT_NE(error_of("no_faces.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "was taken");
    const auto missing = import_mesh("/nowhere/at/all.obj", {});
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().detail, "/nowhere/at/all.obj: no such file");
}

TEST(MeshImport, WarnsWhereFloatsAreCoarse) {
    const auto far = import_text("far.obj", "v 1e7 0 0\nv 10000001 0 0\nv 1e7 1 0\nf 1 2 3\n");
    ASSERT_TRUE(far) << far.error().detail;
    ASSERT_EQ(far.value().warnings.size(), 1u);
    EXPECT_THAT(far.value().warnings[0], HasSubstr("coarse"));
    EXPECT_TRUE(
        import_text("near.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").value().warnings.empty());
}

TEST(MeshImport, ReadsNpzInDoubles) {
    const TemporaryFolder folder;
    const std::vector<double> vertices{0, 0, 0, 1.0 / 3, 0, 0, 0, 1e7 + 1e-3, 0};
    const auto write = [&](const std::vector<double>& points,
                           const std::vector<std::int64_t>& faces) {
        NpzWriter writer(folder / "mesh.npz");
        const auto v = writer.add_array({"vertices", NpyType::F8, 3});
        const auto f = writer.add_array({"faces", NpyType::I8, 3});
        EXPECT_TRUE(writer.append(v, std::span<const double>(points)));
        EXPECT_TRUE(writer.append(f, std::span<const std::int64_t>(faces)));
        ASSERT_TRUE(writer.finish());
    };
    write(vertices, {0, 1, 2});
    const auto imported = import_mesh(folder / "mesh.npz", {});
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().mesh->precision(), Precision::Double);
    EXPECT_EQ(imported.value().mesh->vertices()[1].x(), 1.0 / 3);
    EXPECT_EQ(imported.value().mesh->vertices()[2].y(), 1e7 + 1e-3);

    write(vertices, {0, 1, 2, 0, 1, 3});
    EXPECT_THAT(import_mesh(folder / "mesh.npz", {}).error().detail, HasSubstr("face 1"));
    write({0, 0, 0, 1, std::numeric_limits<double>::quiet_NaN(), 0, 0, 1, 0}, {0, 1, 2});
    EXPECT_THAT(import_mesh(folder / "mesh.npz", {}).error().detail, HasSubstr("vertex 1"));
    write_text(folder / "mesh.npz", "PK no archive");
    EXPECT_THAT(import_mesh(folder / "mesh.npz", {}).error().detail, HasSubstr("mesh.npz"));
}

TEST(MeshImport, OfAnArchiveOnlyTheNeededArraysAreUnpacked) {
    const TemporaryFolder folder;
    NpzWriter writer(folder / "mesh.npz");
    const auto v = writer.add_array({"vertices", NpyType::F8, 3});
    const auto f = writer.add_array({"faces", NpyType::I8, 3});
    const auto other = writer.add_array({"other", NpyType::F8});
    ASSERT_TRUE(
        writer.append(v, std::span<const double>(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0})));
    ASSERT_TRUE(
        writer.append(f, std::span<const std::int64_t>(std::vector<std::int64_t>{0, 1, 2})));
    const std::vector<double> zeros(1u << 20, 0);
    for (int i = 0; i < 8; ++i) {
        ASSERT_TRUE(writer.append(other, std::span<const double>(zeros)));
    }
    ASSERT_TRUE(writer.finish());
    const MemoryBound bound(32u << 20); // Half of the other array's size.
    const auto imported = import_mesh(folder / "mesh.npz", {});
    ASSERT_TRUE(imported) << imported.error().detail;
    EXPECT_EQ(imported.value().mesh->triangles().size(), 1u);
}

} // namespace cd::tests
