// Proves that the demo finds and unpacks its vehicle, otherwise names the package to install, and
// ends the programs it starts.
#include "client/base/child_process.hpp"
#include "client/formats/gunzip.hpp"
#include "client/local/local_cluster.hpp"
#include "client/trees/demo_vehicles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <csignal>
#include <fstream>
#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class Demo : public testing::Test {
  protected:
    Demo() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        dir_ = fs::temp_directory_path() /
               ("cd-demo-" + std::to_string(getpid()) + "-" + test->name());
        fs::create_directories(dir_);
    }
    ~Demo() override { fs::remove_all(dir_); }

    static void write(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
    }
    static void write_gz(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        gzFile file = gzopen(path.c_str(), "wb");
        ASSERT_NE(file, nullptr);
        gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
        gzclose(file);
    }
    static std::string read(const fs::path& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }

    fs::path dir_;
};

constexpr const char* packed =
    "usr/share/doc/openfoam-examples/examples/resources/geometry/motorBike.obj.gz";
constexpr const char* tram = "usr/share/sumo/data/3D/tram.obj";

} // namespace

TEST_F(Demo, TheVehicleIsUnpackedOnce) {
    const std::string text(3'000'000, 'v');
    write_gz(dir_ / "root" / packed, text);
    write(dir_ / "root" / tram, "v 0 0 0\n");
    const auto found = find_vehicles(dir_ / "cache", dir_ / "root");
    ASSERT_TRUE(found) << found.error().detail;
    EXPECT_EQ(read(found.value()[0]), text);

    fs::remove(dir_ / "root" / packed);
    EXPECT_TRUE(find_vehicles(dir_ / "cache", dir_ / "root"));
}

TEST_F(Demo, AMissingPackageIsNamed) {
    for (const bool has_tram : {false, true}) {
        if (has_tram) {
            write(dir_ / "root" / tram, "v 0 0 0\n");
        }
        const auto found = find_vehicles(dir_ / "cache", dir_ / "root");
        ASSERT_FALSE(found);
        EXPECT_THAT(
            found.error().detail,
            HasSubstr("apt-get install --no-install-recommends openfoam-examples sumo-tools"));
    }
}

TEST_F(Demo, AnArchiveCutShortIsRefused) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) {
        text += std::to_string(i * 7919 % 10007) + "\n";
    }
    write_gz(dir_ / "whole.gz", text);
    const std::string bytes = read(dir_ / "whole.gz");
    write(dir_ / "cut.gz", bytes.substr(0, bytes.size() / 2));
    const Status done = gunzip(dir_ / "cut.gz", dir_ / "out");
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().detail, HasSubstr("cut.gz: damaged"));
    EXPECT_FALSE(fs::exists(dir_ / "out"));
    EXPECT_FALSE(fs::exists(dir_ / "out.partial"));
}

TEST_F(Demo, AChildEndsWithItsOwner) {
    pid_t id = 0;
    {
        auto child = ChildProcess::start("/bin/sleep", {"1000"}, dir_ / "log");
        ASSERT_TRUE(child) << child.error().detail;
        id = child.value().id();
        EXPECT_TRUE(child.value().is_running());
        EXPECT_EQ(kill(id, 0), 0);
    }
    EXPECT_EQ(kill(id, 0), -1);
}

TEST_F(Demo, AMissingProgramIsNamed) {
    LocalClusterOptions options;
    options.programs = dir_;
    options.state = dir_ / "state";
    options.logs = dir_ / "logs";
    const auto cluster = LocalCluster::start(options, [] { return false; });
    ASSERT_FALSE(cluster);
    EXPECT_THAT(cluster.error().detail, HasSubstr("cdmaster: no such program"));
}

TEST_F(Demo, AMasterThatEndsAtOnceIsReported) {
    fs::create_symlink("/bin/false", dir_ / "cdmaster");
    LocalClusterOptions options;
    options.programs = dir_;
    options.state = dir_ / "state";
    options.logs = dir_ / "logs";
    const auto cluster = LocalCluster::start(options, [] { return false; });
    ASSERT_FALSE(cluster);
    EXPECT_THAT(cluster.error().detail, HasSubstr("cdmaster ended at once"));
}

} // namespace cd::tests
