// Proves, in the shells themselves, that the scripts of `cdctl completion` complete command lines.
#include "proto/channel/asio.hpp"
#include "tests/cluster/cluster_fixture.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

/// Completes `words`, the last of which is under the cursor, in bash. Returns a word a line.
std::string completed_in_bash(const std::string& words, const std::string& before = "") {
    const Ran ran = run({"/usr/bin/env",
                         "PATH=" + program("cdctl").parent_path().string() + ":/usr/bin:/bin",
                         "bash",
                         "--norc",
                         "-c",
                         "source <(cdctl completion bash); " + before + "COMP_WORDS=(" + words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _cdctl; "
                             "printf '%s\\n' \"${COMPREPLY[@]}\""});
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.errors, "");
    return ran.output;
}

TEST(Shell, BashCompletesVerbsOptionsAndValues) {
    EXPECT_EQ(completed_in_bash("cdctl re"), "results\nreport\n");
    EXPECT_EQ(completed_in_bash("cdctl run --lev"), "--level\n");
    EXPECT_EQ(completed_in_bash("cdctl run --level = co"), "count\ncontacts\n");
    EXPECT_EQ(completed_in_bash("cdctl get ''"), "jobs\nworkers\nmeshes\n");
    EXPECT_EQ(completed_in_bash("cdctl status --unknown-"), "\n");
}

TEST(Shell, BashCompletesFiles) {
    const TemporaryFolder folder;
    write_text(folder / "car one.obj", "");
    write_text(folder / "van.obj", "");
    const std::string before = "cd '" + folder.path().string() + "'; ";
    EXPECT_EQ(completed_in_bash("cdctl inspect ca", before), "car one.obj\n");
    EXPECT_EQ(completed_in_bash("cdctl run --a v", before), "van.obj\n");
    EXPECT_EQ(completed_in_bash("cdctl run --level v", before), "\n");
}

class ShellOfACluster : public Cluster {};

TEST_F(ShellOfACluster, BashCompletesTheIdsOfJobs) {
    const JobId id = submit(make_job(4), Query{}, many_blocks());
    start_worker();
    EXPECT_EQ(finish(id, [](const JobStatus&) {}).state, JobState::Done);
    const std::string named = "cdctl watch --master " + master_->address();
    const std::string found = completed_in_bash(named + " j-");
    EXPECT_THAT(found, testing::MatchesRegex("j-[0-9a-f]+\n"));
    EXPECT_EQ(
        completed_in_bash("cdctl watch ''", "export CDCTL_MASTER=" + master_->address() + "; "),
        found);
    EXPECT_EQ(completed_in_bash(named + " j-zz"), "\n");
}

TEST(Shell, AMasterThatDoesNotAnswerEndsNoCompletion) {
    // Nobody answers the connections of a socket that only listens.
    asio::io_context context;
    asio::ip::tcp::acceptor silent(context, {asio::ip::address_v4::loopback(), 0});
    const std::string silent_master = "127.0.0.1:" + std::to_string(silent.local_endpoint().port());
    EXPECT_EQ(completed_in_bash("cdctl watch --master " + silent_master + " ''"), "\n");
    EXPECT_EQ(completed_in_bash("cdctl watch --master 127.0.0.1:1 ''"), "\n");
}

TEST(Shell, TheOtherShellsTakeTheirScripts) {
    const TemporaryFolder folder;
    for (const char* shell : {"zsh", "fish"}) {
        const Ran script = run({program("cdctl").string(), "completion", shell});
        EXPECT_EQ(script.exit_code, 0);
        EXPECT_THAT(script.output, HasSubstr("complete")) << shell;
        if (run({"/usr/bin/env", shell, "--version"}).exit_code != 0) {
            ASSERT_FALSE(skips_are_failures()) << "CI is set and a shell is missing: " << shell;
            GTEST_SKIP() << "no " << shell;
        }
        write_text(folder / shell, script.output);
        const Ran checked = run({"/usr/bin/env", shell, "-n", (folder / shell).string()});
        EXPECT_EQ(checked.exit_code, 0) << checked.errors;
        EXPECT_EQ(checked.errors, "");
    }
}

TEST(Shell, FishCompletesWords) {
    if (run({"/usr/bin/env", "fish", "--version"}).exit_code != 0) {
        ASSERT_FALSE(skips_are_failures()) << "CI is set and fish is missing";
        GTEST_SKIP() << "no fish";
    }
    const TemporaryFolder home;
    const Ran ran = run({"/usr/bin/env",
                         "HOME=" + home.path().string(),
                         "PATH=" + program("cdctl").parent_path().string() + ":/usr/bin:/bin",
                         "fish",
                         "--no-config",
                         "-c",
                         "cdctl completion fish | source; complete -C 'cdctl run --level co'"});
    EXPECT_EQ(ran.output, "contacts\ncount\n") << ran.errors;
}

} // namespace
} // namespace cd::tests
