// Proves that VTP files have the meshes, the contact map and the shared points, and that no part of
// a file stays where writing fails.
#include "client/export/result_sink.hpp"
#include "client/export/vtp_file.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/vtp_arrays.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace cd::tests {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

class Vtp : public testing::Test {
  protected:
    Vtp() {
        const Mesh box = make_box({1, 1, 1});
        MeshArrays arrays{box.vertices(),
                          box.triangles(),
                          {{std::string("<a\0&", 4), 0, 4}, {"r\xffight \"", 6, 12}},
                          Precision::Float};
        context_.bodies = {{"a", "a.obj", share(Mesh::create(std::move(arrays)).value())},
                           {"b", "b.obj", share(make_sphere(1))}};
        context_.level = Level::Contacts;
    }

    /// Returns four results: separate, failed, and two in contact.
    static std::vector<ScenarioResult> results() {
        std::vector<ScenarioResult> all(4);
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].index = i;
            all[i].level = Level::Contacts;
            all[i].point_offsets = {0};
        }
        all[1].kind = ScenarioClass::Failed;
        all[2].kind = ScenarioClass::Cross;
        all[2].pairs = {{0, 5, PairClass::Proper}, {7, 2, PairClass::Coplanar}};
        all[2].point_origins = {{10, 0, 0}, {20, 0, 0}};
        all[2].point_offsets = {0, 2, 3};
        all[2].points = {{0.5, 1, 0}, {0.25, 0, -3}, {1, 1, 1}};
        all[3].kind = ScenarioClass::Touch;
        all[3].pairs = {{0, 4, PairClass::Touch}};
        all[3].point_origins = {{0, 0, 0}};
        all[3].point_offsets = {0, 1};
        all[3].points = {{0.125, 0, 0}};
        return all;
    }

    Status write() {
        auto sink = ResultSink::open({dir_, {"vtp"}}, context_);
        if (!sink) {
            return sink.error();
        }
        for (const ScenarioResult& result : results()) {
            if (Status added = sink.value().add(result); !added) {
                return added;
            }
        }
        return sink.value().finish(sink.value().map());
    }

    [[nodiscard]] std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(dir_)) {
            names.insert(entry.path().filename());
        }
        return names;
    }

    const TemporaryFolder folder_;
    fs::path dir_ = folder_.path() / "out";
    ExportContext context_;
};

} // namespace

TEST_F(Vtp, ABodyHasItsMeshItsPartsAndTheMap) {
    ASSERT_TRUE(write());
    EXPECT_EQ(files(), (std::set<std::string>{"a.vtp", "b.vtp", "contacts.vtp", "map.csv"}));
    const VtpArrays a = read_vtp(dir_ / "a.vtp");
    const Mesh& mesh = *context_.bodies[0].mesh;
    EXPECT_EQ(a.arrays.at("Points").type, "Float32");
    EXPECT_EQ(read_vtp(dir_ / "b.vtp").arrays.at("Points").type, "Float64");
    const auto points = a.arrays.at("Points").as<float>();
    const auto corners = a.arrays.at("Polys.connectivity").as<std::int32_t>();
    ASSERT_EQ(corners.size(), 36u);
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const Vec3 corner = mesh.corners(i / 3)[i % 3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = 3 * static_cast<std::size_t>(corners[i]) + axis;
            EXPECT_EQ(points[at], corner[static_cast<int>(axis)]);
        }
    }
    EXPECT_THAT(a.arrays.at("Polys.offsets").as<std::int32_t>(),
                ElementsAre(3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 33, 36));
    EXPECT_THAT(a.arrays.at("scenarios").as<std::int64_t>(),
                ElementsAre(2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0));
    EXPECT_EQ(a.arrays.at("share").as<double>()[0], 2.0 / 3) << "a failure is no share of anything";
    EXPECT_THAT(a.arrays.at("part").as<std::int32_t>(),
                ElementsAre(0, 0, 0, 0, -1, -1, 1, 1, 1, 1, 1, 1));
    EXPECT_EQ(a.arrays.at("triangle").as<std::uint32_t>()[11], 11u);
    EXPECT_EQ(a.arrays.at("part_names").bytes,
              std::string("<a\xef\xbf\xbd&\0r\xef\xbf\xbdight \"\0", 18));
    EXPECT_THAT(a.xml, HasSubstr("NumberOfTuples=\"2\""));
}

TEST_F(Vtp, ContactsHaveEachPointWithItsPair) {
    ASSERT_TRUE(write());
    const VtpArrays contacts = read_vtp(dir_ / "contacts.vtp");
    EXPECT_THAT(contacts.arrays.at("Points").as<double>(),
                ElementsAre(10.5, 1, 0, 10.25, 0, -3, 21, 1, 1, 0.125, 0, 0));
    EXPECT_THAT(contacts.arrays.at("scenario").as<std::int64_t>(), ElementsAre(2, 2, 2, 3));
    EXPECT_THAT(contacts.arrays.at("class").as<std::uint8_t>(), ElementsAre(3, 3, 2, 1));
    EXPECT_THAT(contacts.arrays.at("triangle_a").as<std::uint32_t>(), ElementsAre(0, 0, 7, 0));
    EXPECT_THAT(contacts.arrays.at("triangle_b").as<std::uint32_t>(), ElementsAre(5, 5, 2, 4));
    EXPECT_THAT(contacts.arrays.at("Verts.connectivity").as<std::int32_t>(),
                ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(contacts.arrays.at("Verts.offsets").as<std::int32_t>(), ElementsAre(1, 2, 3, 4));
}

TEST_F(Vtp, ManyPointsAreSpooled) {
    constexpr std::size_t count = 30'000; // More than a buffer of any column holds.
    context_.stop = {};
    auto writer = make_vtp_writer(context_, folder_.path());
    ASSERT_TRUE(writer);
    ScenarioResult result = results()[3];
    for (std::size_t i = 0; i < count; ++i) {
        result.index = i;
        result.points[0].x() = static_cast<double>(i);
        ASSERT_TRUE(writer.value()->add(result));
    }
    ASSERT_TRUE(writer.value()->finish());
    dir_ = folder_.path();
    EXPECT_EQ(files(), std::set<std::string>{"contacts.vtp"}) << "no spool, while the writer lives";
    const VtpArrays contacts = read_vtp(folder_.path() / "contacts.vtp");
    const auto scenarios = contacts.arrays.at("scenario").as<std::int64_t>();
    const auto points = contacts.arrays.at("Points").as<double>();
    ASSERT_EQ(scenarios.size(), count);
    ASSERT_EQ(points.size(), 3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(scenarios[i], static_cast<std::int64_t>(i));
        ASSERT_EQ(points[3 * i], static_cast<double>(i));
    }
}

TEST_F(Vtp, LevelPairsHasNoPoints) {
    context_.level = Level::Pairs;
    ASSERT_TRUE(write());
    EXPECT_EQ(files(), (std::set<std::string>{"a.vtp", "b.vtp", "map.csv"}));
}

TEST_F(Vtp, AMapOfListedPairsHasNoShare) {
    context_.listed.limit_pairs = 2;
    ASSERT_TRUE(write());
    const VtpArrays a = read_vtp(dir_ / "a.vtp");
    EXPECT_FALSE(a.has("share"));
    EXPECT_FALSE(a.has("scenarios"));
    EXPECT_EQ(a.arrays.at("scenarios_of_first_2_pairs").as<std::int64_t>()[0], 2);
}

TEST_F(Vtp, AJobWithoutAMapIsRefused) {
    for (const char* format : {"vtp", "glb"}) {
        for (const Level level : {Level::Any, Level::Count}) {
            context_.level = level;
            const auto refused = ResultSink::open({dir_, {format}}, context_);
            ASSERT_FALSE(refused);
            EXPECT_THAT(refused.error().detail, HasSubstr("at level count with maps = true"));
        }
        context_.listed.maps = true;
        EXPECT_TRUE(ResultSink::open({dir_, {format}}, context_));
        context_.listed.maps = false;
    }
}

TEST_F(Vtp, AMapOfAnotherMeshIsRefused) {
    auto sink = ResultSink::open({dir_, {"vtp"}}, context_);
    ASSERT_TRUE(sink);
    ContactMap map;
    map.bodies[0] = {{12, 1}};
    const Status refused = sink.value().finish(map);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().detail, HasSubstr("triangle 12 of a mesh with 12"));
}

TEST_F(Vtp, NamesOfBodiesAreSafeAndDistinctNamesOfFiles) {
    const auto names = [&](const std::string& a, const std::string& b) {
        context_.bodies[0].name = a;
        context_.bodies[1].name = b;
        return std::pair(body_file_name(context_.bodies, 0), body_file_name(context_.bodies, 1));
    };
    EXPECT_THAT(names("van", "caf\xc3\xa9 2"), testing::Pair("van", "caf\xc3\xa9 2"));
    EXPECT_THAT(names("../x", "a/b\\c<d>\n"), testing::Pair("_.._x", "a_b_c_d__"));
    EXPECT_THAT(names("contacts", "contacts_"), testing::Pair("contacts_", "contacts__"));
    EXPECT_THAT(names("x/y", "x:y"), testing::Pair("x_y", "x_y_"));
    EXPECT_THAT(names("-o", ".part"), testing::Pair("_-o", "_.part"));
    EXPECT_EQ(names(std::string(300, 'x'), "").first.size(), 100u);
    EXPECT_EQ(names(std::string(300, 'x'), "").second, "_");
}

TEST_F(Vtp, NothingStaysOfFilesThatCannotBeWritten) {
    int calls = 0;
    context_.stop = [&] { return ++calls > 8; }; // Four results, and then in the files.
    const Status stopped = write();
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(files(), std::set<std::string>{});

    context_.stop = {};
    context_.bodies[1].mesh = share(make_sphere(5));
    const FileSizeLimit limit(1u << 16);
    const Status full = write();
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().code, ErrorCode::Io);
    EXPECT_THAT(full.error().detail, HasSubstr("b.vtp"));
    for (const std::string& name : files()) {
        EXPECT_THAT(name, testing::Not(HasSubstr("partial")));
        EXPECT_NE(name, "b.vtp");
    }
}

TEST(VtpFile, CellsBeyond32BitsAreWide) {
    const VtpCells narrow = consecutive_cells(1u << 30, 1);
    EXPECT_EQ(narrow.connectivity.type, NpyType::I4);
    const VtpCells wide = consecutive_cells(1u << 30, 2);
    EXPECT_EQ(wide.connectivity.type, NpyType::I8);
    EXPECT_EQ(wide.connectivity.count, 1ull << 31);
    EXPECT_EQ(wide.ends.type, NpyType::I8);
    EXPECT_EQ(consecutive_cells(1, 1, 1ull << 31).ends.type, NpyType::I8);
}

TEST(VtpFile, ASeriesNamesTheFilesOfEachStep) {
    const std::vector<VtpStep> steps{{7, {"a.vtp", "b-7.vtp"}}, {8, {"a.vtp"}}};
    const std::string text = pvd_text(steps);
    EXPECT_THAT(text,
                HasSubstr("<DataSet timestep=\"7\" part=\"0\" file=\"a.vtp\"/>\n"
                          "<DataSet timestep=\"7\" part=\"1\" file=\"b-7.vtp\"/>\n"
                          "<DataSet timestep=\"8\" part=\"0\" file=\"a.vtp\"/>\n"));
}

} // namespace cd::tests
