// Proves that the demo finds and unpacks the vehicles of Debian packages, otherwise names the
// package to install, and ends the programs it starts.
#include "client/base/child_process.hpp"
#include "client/demo/demo_vehicles.hpp"
#include "client/local/local_cluster.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <csignal>

namespace cd::tests {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class Demo : public testing::Test {
  protected:
    static void write(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        write_text(path, text);
    }
    static void write_gz(const fs::path& path, const std::string& text) {
        fs::create_directories(path.parent_path());
        gzFile file = gzopen(path.c_str(), "wb");
        ASSERT_NE(file, nullptr);
        gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
        gzclose(file);
    }
    /// The error of a local cluster with the programs in `dir_`.
    [[nodiscard]] std::string error_of_start() const {
        const LocalClusterOptions options{dir_, dir_ / "state", dir_ / "logs"};
        const auto cluster = LocalCluster::start(options, [] { return false; });
        return cluster ? "started" : cluster.error().detail;
    }

    const TemporaryFolder folder_;
    const fs::path dir_ = folder_.path();
};

constexpr const char* packed =
    "usr/share/doc/openfoam-examples/examples/resources/geometry/motorBike.obj.gz";
constexpr const char* tram = "usr/share/sumo/data/3D/tram.obj";

} // namespace

TEST_F(Demo, TheVehicleIsUnpackedOnce) {
    const std::string text(3'000'000, 'v');
    write_gz(dir_ / "root" / packed, text);
    write(dir_ / "root" / tram, "v 0 0 0\n");
    const auto found = find_debian_vehicles(dir_ / "cache", dir_ / "root");
    ASSERT_TRUE(found) << found.error().detail;
    EXPECT_EQ(read_text(found.value()[0]), text);

    fs::remove(dir_ / "root" / packed);
    EXPECT_TRUE(find_debian_vehicles(dir_ / "cache", dir_ / "root"));
}

TEST_F(Demo, AMissingPackageIsNamed) {
    for (const bool has_tram : {false, true}) {
        if (has_tram) {
            write(dir_ / "root" / tram, "v 0 0 0\n");
        }
        const auto found = find_debian_vehicles(dir_ / "cache", dir_ / "root");
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
    const std::string bytes = read_text(dir_ / "whole.gz");
    write(dir_ / "root" / packed, bytes.substr(0, bytes.size() / 2));
    write(dir_ / "root" / tram, "v 0 0 0\n");
    const auto found = find_debian_vehicles(dir_ / "cache", dir_ / "root");
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().detail, HasSubstr("motorBike.obj.gz: damaged"));
    EXPECT_TRUE(fs::is_empty(dir_ / "cache"));
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

TEST_F(Demo, AMissingProgramIsNamedAndAMasterThatEndsAtOnceIsReported) {
    EXPECT_THAT(error_of_start(), HasSubstr("cdmaster: no such program"));
    fs::create_symlink("/bin/false", dir_ / "cdmaster");
    EXPECT_THAT(error_of_start(), HasSubstr("cdmaster ended at once"));
}

} // namespace cd::tests
