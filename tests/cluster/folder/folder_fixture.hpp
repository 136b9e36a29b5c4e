// Runs the real cdctl into results folders of the test.
#pragma once

#include "common/job/result/record_file.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

/// Provides a torus a.obj, a sphere b.obj, and jobs with them.
class FolderTest : public testing::Test {
  protected:
    FolderTest() {
        write_obj(folder_ / "a.obj", make_torus(1.0, 0.4, 24, 12));
        write_obj(folder_ / "b.obj", make_sphere(2));
    }

    /// Writes a job of `count` x `count` poses on a grid.
    void write_job(int count, const std::string& query) {
        const std::string n = std::to_string(count);
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\n"
                   "grid = { x = [-2.5, 2.5, " +
                       n + "], yaw_deg = [0, 350, " + n + "] }\n[query]\n" + query + "\n");
    }

    [[nodiscard]] std::vector<std::string>
    command(const std::string& verb, const std::string& what, std::vector<std::string> more) {
        std::vector<std::string> words{cdctl(), verb, verb == "run" && what.empty() ? job_ : what};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    [[nodiscard]] Ran run(std::vector<std::string> more) {
        return tests::run(command("run", "", std::move(more)));
    }
    [[nodiscard]] nlohmann::json read_json(const std::filesystem::path& path) {
        return nlohmann::json::parse(read_text(path));
    }

    /// Starts the job into `out` and sends the signal once a whole block of results is on disk.
    std::string stop_early(int signal, const std::string& out) {
        Process process(command("run", "", {"--out", folder_ / out}), folder_ / "stopped");
        const std::filesystem::path records = folder_ / out / ".part" / "records";
        EXPECT_TRUE(comes_true([&] {
            const auto kept = RecordFile::open_unfinished(records);
            return kept && kept.value().count() > 0;
        }));
        process.signal(signal);
        EXPECT_EQ(process.wait(), 128 + signal) << process.errors();
        return process.errors();
    }

    const TemporaryFolder folder_;
    const std::string job_ = folder_ / "job.toml";
};

} // namespace cd::tests
