// Proves that cdctl heeds its configuration file, in real processes.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Runs cdctl with a configuration file, and with a home of its own.
class ConfiguredCluster : public Cluster {
  protected:
    [[nodiscard]] Ran configured(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(),
                         {"/usr/bin/env",
                          "-u",
                          "CDCTL_CONFIG",
                          "-u",
                          "CDCTL_MASTER",
                          "XDG_CONFIG_HOME=" + (folder_ / "config").string(),
                          "XDG_STATE_HOME=" + (folder_ / "home").string(),
                          "CDCTL_CONFIG=" + file(),
                          cdctl()});
        return cd::tests::run(arguments);
    }
    [[nodiscard]] std::string file() const { return (folder_ / "cdctl.toml").string(); }
};

TEST_F(ConfiguredCluster, VerbsUseTheMasterOfTheFile) {
    write_text(file(), "master = \"" + master_->address() + "\"\nlevel = \"count\"\n");
    start_worker();
    const Ran status = configured({"status"});
    EXPECT_EQ(status.exit_code, 0) << status.errors;

    write_obj(folder_ / "a.obj", make_sphere(2));
    const std::string mesh = (folder_ / "a.obj").string();
    const std::vector<std::string> job{"run", "--a", mesh, "--b", mesh, "--random", "20"};
    const Ran remote = configured(job);
    EXPECT_EQ(remote.exit_code, 0) << remote.errors;
    EXPECT_THAT(remote.errors, StartsWith("  on " + master_->address()));
    std::vector<std::string> here = job;
    here.insert(here.end(), {"--master", "here"});
    const Ran local = configured(here);
    EXPECT_EQ(local.exit_code, 0) << local.errors;
    EXPECT_THAT(local.errors, StartsWith("  here, "));
    EXPECT_EQ(digest_of(local), digest_of(remote));
    // Level count gives other records than level pairs.
    here.insert(here.end(), {"--level", "pairs"});
    EXPECT_NE(digest_of(configured(here)), digest_of(local));
}

TEST_F(ConfiguredCluster, ConfigShowsEachValueAndItsOrigin) {
    write_text(file(), "master = \"" + master_->address() + "\"\n");
    const Ran text = configured({"config", "--level", "any"});
    EXPECT_EQ(text.exit_code, 0) << text.errors;
    EXPECT_THAT(text.output, StartsWith(file() + "\nSETTING "));
    EXPECT_THAT(text.output,
                testing::ContainsRegex("\nmaster +127[^ ]+ +file +" + file() + ":1\n"));
    EXPECT_THAT(text.output, testing::ContainsRegex("\nlevel +any +option +--level\n"));
    EXPECT_THAT(text.output, testing::ContainsRegex("\ntree-cache +off +environment +CDCTL_TREE"));
    EXPECT_THAT(text.output, testing::ContainsRegex("\nformats +csv,npz +default\n"));
    const auto json = nlohmann::json::parse(configured({"config", "-o", "json"}).output);
    EXPECT_EQ(json["file"], file());
    EXPECT_EQ(json["exists"], true);
    EXPECT_EQ(json["settings"][0]["from"], "file");
    EXPECT_EQ(json["settings"][0]["value"], master_->address());
    EXPECT_THAT(json["settings"][1]["value"].get<std::string>(),
                HasSubstr("/home/cdcluster/client/"));
}

TEST_F(ConfiguredCluster, AWrongKeyOrMasterIsNamedWithItsLine) {
    write_text(file(), "# Mine.\nlevels = \"any\"\n");
    const Ran wrong = configured({"status"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_EQ(wrong.errors,
              "cdctl: " + file() +
                  ":2: cdctl has no setting \"levels\"; did you mean \"level\"?\n");
    write_text(file(), "master = \"node-1\"\n");
    const Ran master = configured({"config"});
    EXPECT_EQ(master.exit_code, 2);
    EXPECT_THAT(master.errors, StartsWith("cdctl: " + file() + ":1: "));
}

} // namespace
} // namespace cd::tests
