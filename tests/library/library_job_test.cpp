// Proves that the library runs jobs of every kind as `cdctl run` does: same digests, and arrays
// equal to those of results.npz; and that results folders are written, resumed and read.
#include "library/include/cdcluster/cdcluster.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <ranges>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr const char* pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "g base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

const std::string two = "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n";
const std::string grid =
    "[poses]\ngrid = { x = [-1.5, 1.5, 13], y = [-1, 1, 5], yaw_deg = [0, 90, 3] }\n";

/// A job of each kind.
const std::map<std::string, std::string> jobs{
    {"pairs", two + grid},
    {"any", two + grid + "[query]\nlevel = \"any\"\n"},
    {"maps", two + grid + "[query]\nlevel = \"count\"\nmaps = true\n"},
    {"near", two + grid + "[query]\nlevel = \"contacts\"\nclearance = 0.1\n"},
    {"distance", two + grid + "[query]\nlevel = \"distance\"\nup_to = 1\n"},
    {"motion",
     two + "[poses]\nline = { from = [3, 0.1, 0.1], to = [-3, 0, 0] }\n"
           "[motion]\nresolution = 0.01\n[query]\nlevel = \"pairs\"\n"},
    {"shots",
     "[a]\nmesh = \"a.obj\"\n[shots]\nspacing = 0.125\nazimuth_deg = [0, 90, 2]\n"
     "elevation_deg = [0, 45, 2]\n[query]\nlevel = \"pairs\"\n"},
    {"lines",
     "[bodies]\ncar = { mesh = \"a.obj\", count = 3 }\n[poses]\nfile = \"steps.csv\"\n"
     "[shots]\nspacing = 0.125\ntile = 4\nazimuth_deg = [0, 90, 2]\n"
     "[query]\nlevel = \"pairs\"\n"},
    {"scene",
     "[bodies]\ncar = { mesh = \"a.obj\", count = 3 }\nwall = { mesh = \"b.obj\", pose = [0, 0, 0, "
     "0, 0, 0, 1], quat_order = \"xyzw\" }\n[poses]\nfile = \"steps.csv\"\n"
     "[query]\nlevel = \"pairs\"\n"}};

class LibraryJob : public testing::TestWithParam<std::pair<const std::string, std::string>> {
  protected:
    LibraryJob() {
        write_text(folder_ / "a.obj", pyramid);
        write_text(folder_ / "b.obj", std::string(pyramid) + "f 2 3 1\n");
        std::string steps = "step,body,x,y\n";
        for (int step = 0; step < 6; ++step) {
            for (int car = 0; car < 3; ++car) {
                steps += std::to_string(step) + ",car." + std::to_string(car) + "," +
                         std::to_string(car * 0.7 - step * 0.2) + "," + std::to_string(0.1 * car) +
                         "\n";
            }
        }
        write_text(folder_ / "steps.csv", steps);
    }

    [[nodiscard]] cdcluster::Job job(const std::string& text) const {
        return cdcluster::Job::from_toml(text, folder_.path());
    }

    /// Runs the job by the program; returns the digest in its summary.
    [[nodiscard]] std::string digest_of_program(const std::string& text) const {
        write_text(folder_ / "job.toml", text);
        const Ran ran = run({program("cdctl"),
                             "run",
                             folder_ / "job.toml",
                             "--out",
                             folder_ / "by-program",
                             "--formats",
                             "npz",
                             "--tree-cache",
                             "off"});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return nlohmann::json::parse(read_text(folder_ / "by-program/summary.json"))
            .at("digest")
            .get<std::string>();
    }

    TemporaryFolder folder_;
};

using Arrays = std::map<std::string, NpyArray>;

/// Expects that an array of the archive, if it has it, has the bytes of `values`.
template <class T>
void expect_array(const Arrays& arrays, const std::string& name, const std::vector<T>& values) {
    const auto found = arrays.find(name);
    if (found == arrays.end()) {
        EXPECT_TRUE(values.empty()) << name;
        return;
    }
    const Bytes& data = found->second.data;
    ASSERT_EQ(data.size(), values.size() * sizeof(T)) << name;
    EXPECT_TRUE(data.empty() || std::memcmp(data.data(), values.data(), data.size()) == 0) << name;
}

void expect_arrays(const Arrays& arrays, const cdcluster::Results& results) {
    expect_array(arrays, "class", results.kind);
    expect_array(arrays, "count", results.count);
    expect_array(arrays, "near_count", results.near_count);
    expect_array(arrays, "surfaces_only", results.surfaces_only);
    if (results.hit_depth.empty()) { // Else they are in shots.npz.
        expect_array(arrays, "offsets", results.offsets);
        expect_array(arrays, "pairs", results.pairs);
        expect_array(arrays, "pair_class", results.pair_class);
    }
    expect_array(arrays, "point_offsets", results.point_offsets);
    expect_array(arrays, "points_world", results.points);
    expect_array(arrays, "pair_distance", results.pair_distance);
    expect_array(arrays, "distance", results.distance);
    expect_array(arrays, "witness", results.witness);
    expect_array(arrays, "witness_points", results.witness_points);
    expect_array(arrays, "step", results.step);
    expect_array(arrays, "end", results.motion.end);
    expect_array(arrays, "depth", results.motion.depth);
    expect_array(arrays, "t0", results.motion.t0);
    expect_array(arrays, "t1", results.motion.t1);
    expect_array(arrays, "run_offsets", results.motion.run_offsets);
    expect_array(arrays, "runs", results.motion.runs);
}

} // namespace

TEST_P(LibraryJob, RunsAsTheProgramDoes) {
    const std::string digest = digest_of_program(GetParam().second);
    const auto results = cdcluster::run(job(GetParam().second));
    EXPECT_EQ(results.digest, digest);
    EXPECT_GT(results.size(), 0u);
    EXPECT_TRUE(std::ranges::any_of(std::views::iota(std::size_t{0}, results.size()),
                                    [&](std::size_t i) { return results.is_hit(i); }));
    const auto arrays = read_npz(folder_ / "by-program/results.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    expect_arrays(arrays.value(), results);
    expect_arrays(arrays.value(), cdcluster::open(folder_ / "by-program"));
    EXPECT_EQ(cdcluster::open(folder_ / "by-program").map_a, results.map_a);
    EXPECT_EQ(results.map_a.empty(), GetParam().first != "maps");
}

TEST_F(LibraryJob, LinesThroughASceneHaveTheArraysOfTheirFile) {
    (void)digest_of_program(jobs.at("lines"));
    const auto results = cdcluster::run(job(jobs.at("lines")));
    const auto arrays = read_npz(folder_ / "by-program/shots.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    ASSERT_EQ(results.bundle.size(), results.size());
    expect_array(arrays.value(), "step", results.step);
    expect_array(arrays.value(), "bundle", results.bundle);
    expect_array(arrays.value(), "body", results.body_a);
    expect_array(arrays.value(), "offsets", results.offsets);
    expect_array(arrays.value(), "hits", results.pairs);
    expect_array(arrays.value(), "depth", results.hit_depth);
    EXPECT_GT(*std::ranges::max_element(results.bundle), 1u);
    EXPECT_TRUE(cdcluster::run(job(jobs.at("shots"))).bundle.empty());
}

TEST_P(LibraryJob, WritesAFolderThatCanBeRunAgain) {
    cdcluster::RunOptions options;
    options.out = folder_ / "out";
    const auto results = cdcluster::run(job(GetParam().second), options);
    EXPECT_EQ(results.digest, cdcluster::run(job(GetParam().second)).digest);
    const auto again = cdcluster::Job::from_folder(folder_ / "out");
    EXPECT_EQ(cdcluster::run(again).digest, results.digest);
    // The folder is complete, so that the second run only reads it.
    EXPECT_EQ(cdcluster::run(job(GetParam().second), options).digest, results.digest);
    EXPECT_EQ(run({program("cdctl"), "verify", folder_ / "out"}).exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind,
                         LibraryJob,
                         testing::ValuesIn(jobs.begin(), jobs.end()),
                         [](const auto& each) { return each.param.first; });

TEST_F(LibraryJob, NamesBodiesAndStepsOfAScene) {
    const auto results = cdcluster::run(job(jobs.at("scene")));
    EXPECT_EQ(results.body_names, (std::vector<std::string>{"car.0", "car.1", "car.2", "wall"}));
    ASSERT_EQ(results.step.size(), results.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
        EXPECT_LT(results.body_a[i], results.body_b[i]);
        EXPECT_LT(results.step[i], 6u);
    }
}

TEST_F(LibraryJob, RefusesWrongJobsWithLineAndKey) {
    const auto error_of = [&](const std::string& text) -> std::string {
        try {
            static_cast<void>(cdcluster::run(job(text)));
        } catch (const cdcluster::Error& error) {
            EXPECT_NE(error.code(), cdcluster::ErrorCode::Interrupted);
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(error_of(two + "[pose]\n"), HasSubstr("job.toml:5"));
    EXPECT_THAT(error_of("[a]\nmesh = \"none.obj\"\n[b]\nmesh = \"b.obj\"\n" + grid),
                HasSubstr("none.obj"));
    EXPECT_THAT(error_of(jobs.at("scene") + "maps = true\n"), HasSubstr("maps count"));
    EXPECT_THROW(static_cast<void>(cdcluster::open(folder_ / "nothing")), cdcluster::Error);
}

TEST_F(LibraryJob, StopsAndResumesAFolder) {
    const std::string large =
        two + "[poses]\ngrid = { x = [-1.5, 1.5, 101], y = [-1, 1, 101], yaw_deg = [0, 90, 61] }\n"
              "[query]\nlevel = \"count\"\n";
    cdcluster::RunOptions options;
    options.out = folder_ / "out";
    std::uint64_t stopped_at = 0;
    options.progress = [&](const cdcluster::Progress& progress) {
        stopped_at = progress.done;
        return progress.done == 0;
    };
    EXPECT_THROW(static_cast<void>(cdcluster::run(job(large), options)), cdcluster::Error);
    EXPECT_GT(stopped_at, 0u);
    std::uint64_t first_told = 0;
    options.progress = [&](const cdcluster::Progress& progress) {
        first_told = first_told == 0 ? progress.done : first_told;
        return true;
    };
    const auto results = cdcluster::run(job(large), options);
    EXPECT_GE(first_told, stopped_at);
    EXPECT_EQ(results.size(), 101u * 101 * 61);
    EXPECT_EQ(results.digest, cdcluster::run(job(large)).digest);
}

} // namespace cd::tests
