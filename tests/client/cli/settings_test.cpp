// Proves what a configuration file may say, and what precedes it.
#include "client/cli/settings.hpp"

#include "client/base/exit_code.hpp"
#include "client/spec/job_options.hpp"
#include "common/core/files/state_folder.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Sets or unsets a variable of the environment for a scope.
class SettingVariable {
  public:
    SettingVariable(const char* name, const char* value) : name_(name) {
        if (const char* const before = std::getenv(name)) {
            before_ = before;
        }
        value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
    }
    SettingVariable(const SettingVariable&) = delete;
    SettingVariable& operator=(const SettingVariable&) = delete;
    ~SettingVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

std::string problem_in_settings(const char* text) {
    const auto read = parse_settings(text, "/etc/cdctl.toml");
    return read ? "no error" : read.error().detail;
}

TEST(Settings, EachKeyIsReadWithItsLine) {
    const SettingVariable home("HOME", "/home/me");
    const auto read = parse_settings("master = \"node-1:7600\"\n"
                                     "credential = \"~/me.pem\"\n"
                                     "formats = [\"csv\", \"npz\"]\n"
                                     "\n"
                                     "level = \"count\"\n"
                                     "tree-cache = \"trees\"\n",
                                     "/conf/cdctl.toml");
    ASSERT_TRUE(read) << read.error().detail;
    const Settings& settings = read.value();
    EXPECT_EQ(settings.find("master")->value, "node-1:7600");
    EXPECT_EQ(settings.find("credential")->value, "/home/me/me.pem");
    EXPECT_EQ(settings.find("formats")->value, "csv,npz");
    EXPECT_EQ(settings.find("level")->value, "count");
    EXPECT_EQ(settings.find("level")->line, 5u);
    EXPECT_EQ(settings.find("tree-cache")->value, "/conf/trees");
    EXPECT_EQ(parse_settings("credential = \"none\"\ntree-cache = \"off\"\n", "/c")
                  .value()
                  .find("tree-cache")
                  ->value,
              "off");
    EXPECT_TRUE(parse_settings("", "/c").value().values.empty());
}

TEST(Settings, AnErrorNamesFileAndLine) {
    EXPECT_EQ(problem_in_settings("\nmastr = \"a:1\"\n"),
              "/etc/cdctl.toml:2: cdctl has no setting \"mastr\"; did you mean \"master\"?");
    EXPECT_EQ(problem_in_settings("level = \"most\"\nzzzz = 1\n").substr(0, 18),
              "/etc/cdctl.toml:1:")
        << "the first wrong line is told";
    EXPECT_THAT(problem_in_settings("formats = [\"csv\", \"xls\"]\n"),
                StartsWith("/etc/cdctl.toml:1: format \"xls\" is not known"));
    EXPECT_THAT(problem_in_settings("master = \"a:1\"\nmaster = \"b:1\"\n"),
                StartsWith("/etc/cdctl.toml:2: "));
    EXPECT_THAT(problem_in_settings("master = \"\"\n"), HasSubstr(":1: master has to be one text"));
    EXPECT_THAT(problem_in_settings("level = [\"any\", \"count\"]\n"),
                HasSubstr(":1: level has to be"));
    EXPECT_THAT(problem_in_settings("[master]\na = 1\n"), StartsWith("/etc/cdctl.toml:1: "));
}

TEST(Settings, TheFileIsWhereTheEnvironmentSays) {
    const SettingVariable home("HOME", "/h");
    {
        const SettingVariable named("CDCTL_CONFIG", "/x/y.toml");
        EXPECT_EQ(settings_path(), "/x/y.toml");
    }
    {
        const SettingVariable none("CDCTL_CONFIG", "none");
        EXPECT_EQ(settings_path(), "");
        EXPECT_TRUE(read_settings().value().values.empty());
    }
    const SettingVariable unnamed("CDCTL_CONFIG", nullptr);
    {
        const SettingVariable config("XDG_CONFIG_HOME", "/c");
        EXPECT_EQ(settings_path(), "/c/cdcluster/cdctl.toml");
    }
    const SettingVariable config("XDG_CONFIG_HOME", nullptr);
    EXPECT_EQ(settings_path(), "/h/.config/cdcluster/cdctl.toml");
    const SettingVariable no_home("HOME", nullptr);
    EXPECT_EQ(settings_path(), "");
}

class SettingsFile : public testing::Test {
  protected:
    /// Writes the configuration file that the command lines of this test read.
    void write(const std::string& text) const { write_text(file_, text); }

    [[nodiscard]] static CommandLine parse(std::vector<std::string> arguments) {
        return parse_command_line(std::move(arguments));
    }
    template <class T>
    [[nodiscard]] static T command(std::vector<std::string> arguments) {
        const CommandLine line = parse(std::move(arguments));
        EXPECT_TRUE(line.command) << line.text;
        return line.command ? std::get<T>(*line.command) : T();
    }

    TemporaryFolder folder_;
    std::string file_ = (folder_ / "cdctl.toml").string();
    SettingVariable named_{"CDCTL_CONFIG", file_.c_str()};
    SettingVariable no_master_{"CDCTL_MASTER", nullptr};
    SettingVariable no_credential_{"CDCTL_CREDENTIAL", nullptr};
    SettingVariable no_cache_{"CDCTL_TREE_CACHE", nullptr};
};

TEST_F(SettingsFile, AnOptionPrecedesTheEnvironmentPrecedesTheFile) {
    write("master = \"file:1\"\ncredential = \"/file.pem\"\ntree-cache = \"/file\"\n");
    EXPECT_EQ(command<StatusCommand>({"status"}).master.address, "file:1");
    EXPECT_EQ(command<StatusCommand>({"status"}).master.credential, "/file.pem");
    EXPECT_EQ(command<ViewCommand>({"view"}).tree_cache, "/file");
    EXPECT_EQ(command<TokenCommand>({"token", "create"}).master.address, "file:1");
    const SettingVariable master("CDCTL_MASTER", "env:2");
    const SettingVariable cache("CDCTL_TREE_CACHE", "/env");
    EXPECT_EQ(command<StatusCommand>({"status"}).master.address, "env:2");
    EXPECT_EQ(command<ViewCommand>({"view"}).tree_cache, "/env");
    EXPECT_EQ(command<StatusCommand>({"status", "--master", "o:3"}).master.address, "o:3");
    EXPECT_EQ(command<ViewCommand>({"view", "--tree-cache", "off"}).tree_cache, "off");
}

TEST_F(SettingsFile, ARunTakesItsMasterFromTheFileAlone) {
    write("");
    const auto address_of = [](const RunCommand& run) { return run.master.address; };
    EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml"})), "");
    {
        const SettingVariable master("CDCTL_MASTER", "env:2");
        EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml"})), "");
        write("master = \"file:1\"\n");
        EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml"})), "env:2")
            << "as `cdctl config` shows it";
    }
    EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml"})), "file:1");
    EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml", "--master", "o:3"})), "o:3");
    EXPECT_EQ(address_of(command<RunCommand>({"run", "j.toml", "--master", "here"})), "");
}

TEST_F(SettingsFile, ABrokenFileEndsEveryVerbButNoHelp) {
    write("\nlevel = 3\n");
    const CommandLine line = parse({"status"});
    EXPECT_FALSE(line.command);
    EXPECT_EQ(line.exit_code, exit_usage);
    EXPECT_THAT(line.text, StartsWith("cdctl: " + file_ + ":2: level \"3\" is not known"));
    EXPECT_EQ(parse({"config"}).exit_code, exit_usage);
    EXPECT_EQ(parse({"status", "--help"}).exit_code, exit_done);
    EXPECT_EQ(parse({"--version"}).exit_code, exit_done);
    EXPECT_TRUE(parse({"complete", "st"}).command);
    std::filesystem::remove(file_);
    EXPECT_EQ(parse({"status"}).text, "cdctl: " + file_ + ": cannot be read\n");
}

TEST_F(SettingsFile, AManualPageHasNoneOfIt) {
    write("master = \"secret-node:1\"\n");
    EXPECT_THAT(parse({"--man"}).text, testing::Not(HasSubstr("secret-node")));
}

TEST_F(SettingsFile, ACompletionAsksTheMasterOfTheFile) {
    write("master = \"file:1\"\ncredential = \"/me.pem\"\n");
    const auto asked = command<CompleteCommand>({"complete", "watch", "j-"});
    EXPECT_EQ(asked.master.address, "file:1");
    EXPECT_EQ(asked.master.credential, "/me.pem");
}

TEST_F(SettingsFile, ConfigTellsWhereEachValueComesFrom) {
    write("formats = [\"json\"]\nmaster = \"file:1\"\n");
    const SettingVariable cache("CDCTL_TREE_CACHE", "/env");
    const auto config = command<ConfigCommand>({"config", "--level", "any"});
    EXPECT_EQ(config.file, file_);
    EXPECT_TRUE(config.file_exists);
    const auto texts = [&] {
        std::vector<std::string> all;
        for (const ChosenSetting& setting : config.settings) {
            all.push_back(setting.key + "=" + setting.value + " " + setting.place);
        }
        return all;
    }();
    EXPECT_THAT(texts,
                ElementsAre("master=file:1 " + file_ + ":2",
                            "credential= ",
                            "formats=json " + file_ + ":1",
                            "level=any --level",
                            "tree-cache=/env CDCTL_TREE_CACHE"));
    EXPECT_EQ(config.settings[0].origin, SettingOrigin::File);
    EXPECT_EQ(config.settings[1].origin, SettingOrigin::Default);
    EXPECT_EQ(config.settings[3].origin, SettingOrigin::Option);
    EXPECT_EQ(config.settings[4].origin, SettingOrigin::Environment);
}

/// Makes the job that `run` makes of a job file and further arguments.
Result<JobSpec> job_of(const RunCommand& run) {
    return make_job_spec(run.job);
}

TEST_F(SettingsFile, AJobFilePrecedesFormatsAndLevel) {
    write("formats = [\"json\", \"glb\"]\nlevel = \"count\"\n");
    const std::string job = (folder_ / "job.toml").string();
    const std::string bodies = "[a]\nmesh = \"a\"\n[b]\nmesh = \"b\"\n[poses]\nfile = \"p.csv\"\n";
    const auto spec_of = [&](const std::string& more, std::vector<std::string> options = {}) {
        write_text(job, bodies + more);
        options.insert(options.begin(), {"run", job});
        auto spec = job_of(command<RunCommand>(options));
        EXPECT_TRUE(spec) << spec.error().detail;
        return std::move(spec.value());
    };
    JobSpec spec = spec_of("");
    EXPECT_EQ(spec.query.level, Level::Count);
    EXPECT_THAT(spec.output.formats, ElementsAre("json")) << "count without maps has no glb";
    EXPECT_THAT(spec_of("", {"--level", "pairs"}).output.formats, ElementsAre("json", "glb"));
    spec = spec_of("[query]\nlevel = \"any\"\n[output]\nformats = [\"csv\"]\n");
    EXPECT_EQ(spec.query.level, Level::Any);
    EXPECT_THAT(spec.output.formats, ElementsAre("csv"));
    spec = spec_of("[query]\nclearance = 1\n[output]\ndir = \"o\"\n", {"--formats", "npz"});
    EXPECT_EQ(spec.query.level, Level::Count);
    EXPECT_THAT(spec.output.formats, ElementsAre("npz"));
    // A motion cannot be asked at level count.
    EXPECT_EQ(spec_of("[motion]\nresolution = 1\n").query.level, Level::Pairs);
    // Nor can pairs be limited at it.
    EXPECT_EQ(spec_of("", {"--limit-pairs", "9"}).query.level, Level::Pairs);
}

TEST_F(SettingsFile, AResultTakesTheFormatsOfTheFile) {
    write("formats = [\"json\"]\n");
    EXPECT_THAT(command<ResultsCommand>({"results", "j-1"}).usual_formats, ElementsAre("json"));
    EXPECT_TRUE(command<ResultsCommand>({"results", "j-1"}).formats.empty());
    EXPECT_THAT(command<SubmitCommand>({"submit", "j.toml"}).job.output.usual_formats,
                ElementsAre("json"));
}

} // namespace
} // namespace cd::tests
