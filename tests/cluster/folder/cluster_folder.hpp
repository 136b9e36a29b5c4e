// A test fixture that starts a cluster and runs cdctl into results folders, locally or on the
// cluster's master.
#pragma once

#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

/// Runs job.toml of the test's folder.
class ClusterFolder : public Cluster {
  protected:
    [[nodiscard]] Ran cdctl_here(std::vector<std::string> words) {
        words.insert(words.begin(), cdctl());
        return tests::run(words);
    }
    [[nodiscard]] Ran cdctl_at_master(std::vector<std::string> words) {
        words.insert(words.end(), {"--master", master_->address()});
        return cdctl_here(std::move(words));
    }
    /// Runs the job into a folder. Returns its manifest.
    nlohmann::json run_into(const std::string& name, std::vector<std::string> more = {}) {
        std::vector<std::string> words{"run", folder_ / "job.toml", "--out", folder_ / name};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = cdctl_here(words);
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return read_json(name, "run.json");
    }
    [[nodiscard]] nlohmann::json read_json(const std::string& name, const std::string& file) {
        return nlohmann::json::parse(read_text(folder_ / name / file));
    }
    [[nodiscard]] std::string read(const std::string& name, const std::string& file) {
        return read_text(folder_ / name / file);
    }
    [[nodiscard]] std::string id_of_last_job() {
        const Ran jobs = cdctl_at_master({"get", "jobs", "-o", "name"});
        const std::string ids = jobs.output.substr(0, jobs.output.find_last_not_of('\n') + 1);
        return ids.substr(ids.rfind('\n') + 1);
    }
};

} // namespace cd::tests
