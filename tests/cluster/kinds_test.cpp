// Proves, with cdctl and real processes over TCP, that a job file of every kind (clearance,
// distance, motion, curves, lines, scenes, traffic) has the digest of one process on a cluster of
// three workers, whoever analyses.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <regex>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// A job of two tori, or of many; the files that it names are those of `Kinds`.
struct KindOfJob {
    const char* name;
    const char* text;
    const char* summary; ///< Words of the summary that only an answer to this question has.
};

constexpr const char* two_tori = "[a]\nmesh = \"large.obj\"\n[b]\nmesh = \"small.obj\"\n[poses]\n";
constexpr const char* lines = "[a]\nmesh = \"large.obj\"\n[shots]\n";
/// Two rings that move, with rows that say how, a fixed one, and one in two parts.
constexpr const char* scene =
    "[bodies]\nring = { mesh = \"small.obj\", count = 2, group = \"rings\" }\n"
    "gate = { mesh = \"large.obj\", pose = [0, 0, 0, 0, 0, 0, 1], quat_order = \"xyzw\" }\n"
    "bars = { mesh = \"bars.obj\", split = \"parts\" }\n"
    "[rules]\norder = [{ ignore = [\"bars.*\", \"group:rings\"] }, "
    "{ test = [\"bars.left\", \"ring.0\"] }]\n[poses]\n";

const std::vector<KindOfJob>& kinds() {
    static const std::vector<KindOfJob> all{
        {"near",
         "grid = { x = [-2, 2, 9], yaw_deg = [0, 60, 2] }\n[query]\nclearance = 0.05\n",
         " near "},
        {"distance",
         "grid = { x = [-4, 4, 17] }\n[query]\nlevel = \"distance\"\nup_to = 2\n",
         "least"},
        {"motion", "file = \"keys.csv\"\n[motion]\nresolution = 0.01\n", "first contact"},
        {"way out",
         "file = \"out.csv\"\n[motion]\nresolution = 0.01\nuntil = \"free\"\n",
         "first free"},
        {"time line",
         "file = \"keys.csv\"\n[motion]\nresolution = 0.01\nuntil = \"end\"\n[query]\nlevel = "
         "\"any\"\nclearance = 0.1\n",
         "first near"},
        {"curve",
         "screw = { axis = [0, 0, 1], degrees = [0, 720], pitch = 0.5 }\n[motion]\nresolution = "
         "0.02\nchord = 0.01\n",
         "first"},
        {"velocities",
         "file = \"rates.csv\"\n[motion]\nresolution = 0.02\nchord = 0.01\n",
         "first"},
        {"inserted", "file = \"keys.csv\"\nmax_step = 0.25\n[query]\nlevel = \"count\"\n", "cross"},
        {"lines",
         "spacing = 0.125\ntile = 8\nazimuth_deg = [0, 90, 3]\nelevation_deg = [0, 90, 2]\n",
         "hits"},
        {"first hits",
         "spacing = 0.25\ntile = 8\nfirst = true\njitter = { seed = 7 }\n[query]\nmaps = true\n",
         "hits"},
        {"scene",
         "file = \"steps.csv\"\nabsent = \"nan\"\n[query]\nlevel = \"contacts\"\n",
         "coverage"},
        {"scene of distances",
         "file = \"steps.csv\"\nabsent = \"nan\"\n[query]\nlevel = \"distance\"\nup_to = 3\n",
         "coverage"},
        {"scene of motions",
         "file = \"steps.csv\"\nabsent = \"nan\"\n[motion]\nresolution = 0.02\n[query]\nclearance "
         "= 0.05\n",
         "coverage"},
        {"scene of curves",
         "file = \"thrown.csv\"\n[motion]\nresolution = 0.05\nchord = 0.02\n",
         "coverage"},
        {"traffic", "fcd = { file = \"fcd.xml\", types = { car = \"ring\" } }\n", "coverage"},
    };
    return all;
}

std::string text_of(const KindOfJob& kind) {
    const std::string name = kind.name;
    const std::string text = kind.text;
    if (name.find("hits") != std::string::npos || name == "lines") {
        return lines + text;
    }
    if (name == "traffic") {
        return "[bodies]\nring = { mesh = \"small.obj\", origin = [0.6, 0, 0] }\n[poses]\n" + text;
    }
    return (name.starts_with("scene") ? scene : two_tori) + text;
}

class Kinds : public Cluster {
  protected:
    Kinds() {
        write_obj(folder_ / "large.obj", make_torus(1, 0.4, 48, 24));
        write_obj(folder_ / "small.obj", make_torus(0.5, 0.1, 32, 16));
        write_text(folder_ / "bars.obj",
                   "v 0 -2 0\nv 0.2 -2 0\nv 0 2 0\nv 0 -2 0.2\nv 5 -2 0\nv 5.2 -2 0\nv 5 2 0\n"
                   "v 5 -2 0.2\ng left\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\ng right\n"
                   "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
        write_text(folder_ / "keys.csv",
                   "t,x,y,yaw_deg\n0,-3,0,0\n1,3,0.2,90\n2,-3,0,0\n4,-3,4,10\n");
        write_text(folder_ / "out.csv", "x,y\n1,0\n5,0\n5,3\n1,0\n");
        write_text(folder_ / "rates.csv",
                   "t,x,z,vx,vy,vz,ax,ay,az\n0,-3,0,3,0,2,0,0,-2\n2,3,0,-3,0,0,0,0,0\n4,-3,0,0,0,0,"
                   "0,0,0\n");
        write_text(folder_ / "steps.csv",
                   "step,body,x,y,pitch_deg\n0,ring.0,-3,0,0\n0,ring.1,1,0,0\n1,ring.0,1,0,45\n"
                   "1,ring.1,1.2,0,10\n2,ring.0,4,0,60\n2,ring.1,nan,nan,nan\n3,ring.0,6,0,70\n"
                   "3,ring.1,6,0.2,10\n");
        write_text(folder_ / "thrown.csv",
                   "step,body,t,x,z,vx,vy,vz,ax,ay,az,wx_deg,wy_deg,wz_deg\n"
                   "0,ring.0,0,-3,0,3,0,2,0,0,-2,0,0,0\n0,ring.1,0,1,0,0,0,0,0,0,0,0,0,0\n"
                   "1,ring.0,2,3,0,0,0,0,0,0,0,0,0,0\n1,ring.1,2,1,0,0,0,0,0,0,0,0,0,0\n");
        write_text(folder_ / "fcd.xml",
                   "<fcd-export>\n<timestep time=\"0\">\n"
                   "<vehicle id=\"v\" type=\"car\" x=\"0\" y=\"0\" angle=\"90\"/>\n"
                   "<vehicle id=\"w\" type=\"car\" x=\"0.9\" y=\"0\" angle=\"45\" slope=\"3\"/>\n"
                   "</timestep>\n<timestep time=\"1\">\n"
                   "<vehicle id=\"v\" type=\"car\" x=\"4\" y=\"0\" angle=\"90\"/>\n"
                   "<vehicle id=\"u\" type=\"car\" x=\"3.2\" y=\"0.4\" angle=\"180\"/>\n"
                   "</timestep>\n</fcd-export>\n");
    }

    /// Writes the job file of a kind, with more text behind it.
    void write_job(const std::string& name, const std::string& more) const {
        const auto kind = std::ranges::find(kinds(), name, &KindOfJob::name);
        ASSERT_NE(kind, kinds().end());
        write_text(folder_ / "job.toml", text_of(*kind) + more);
    }

    /// Runs a job file here, or on the cluster with this mode of analysis.
    [[nodiscard]] Ran run(const std::string& analysis = {}) const {
        std::vector<std::string> command{cdctl(), "run", folder_ / "job.toml", "--quiet"};
        if (!analysis.empty()) {
            command.insert(command.end(), {"--master", master_->address(), "--analysis", analysis});
        }
        return tests::run(command);
    }
};

} // namespace

TEST_F(Kinds, EachHasTheDigestOfOneProcessOnThreeWorkers) {
    for (int i = 0; i < 3; ++i) {
        start_worker(1);
    }
    for (const KindOfJob& kind : kinds()) {
        SCOPED_TRACE(kind.name);
        write_text(folder_ / "job.toml", text_of(kind));
        const Ran here = run();
        EXPECT_EQ(here.exit_code, 0) << here.errors;
        EXPECT_THAT(here.output, HasSubstr(kind.summary));
        EXPECT_EQ(digest_of(here).size(), 16u) << digest_of(here);
        for (const char* analysis : {"always", "never"}) {
            const Ran there = run(analysis);
            EXPECT_EQ(there.exit_code, 0) << there.errors;
            EXPECT_EQ(digest_of(there), digest_of(here)) << analysis;
        }
    }
}

TEST_F(Kinds, ListsOfJobsTellTheCellsOfMotionsAndTheRootsOfDistances) {
    start_worker(1); // The only one, so that no copies of scenarios run.
    const auto numbers_of = [](const std::string& text) {
        std::map<std::string, int> numbers;
        const std::regex number("\"(cells|leaves|roots_named|roots_used)\": *([0-9]+)");
        for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) {
            numbers[(*i)[1]] = std::stoi((*i)[2]);
        }
        return numbers;
    };
    const auto listed = [&](const std::string& analysis) {
        const Ran ran = run(analysis);
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        const std::string at = master_->address();
        const Ran jobs = tests::run({cdctl(), "get", "jobs", "-o", "json", "--master", at});
        EXPECT_EQ(jobs.exit_code, 0) << jobs.errors;
        const Ran removed = tests::run({cdctl(), "rm", "last", "--yes", "--master", at});
        EXPECT_EQ(removed.exit_code, 0) << removed.errors;
        return numbers_of(jobs.output);
    };
    write_job("motion", "[cluster]\ndepth = { a = 6, b = 4 }\n");
    const Ran alone =
        tests::run({cdctl(), "run", folder_ / "job.toml", "--quiet", "--out", folder_ / "out"});
    ASSERT_EQ(alone.exit_code, 0) << alone.errors;
    const auto here = numbers_of(read_text(folder_ / "out" / "summary.json"));
    EXPECT_GT(here.at("leaves"), 3);
    EXPECT_GT(here.at("cells"), here.at("leaves"));
    EXPECT_EQ(listed("always"), here);
    EXPECT_EQ(listed("never"), here);
    for (const char* analysis : {"always", "never"}) {
        // Blocks that the worker does not have yet, so that it looks twice.
        const char* const depth = analysis == std::string("always") ? "5" : "7";
        write_job("distance", std::string("[cluster]\ndepth = { a = ") + depth + ", b = 3 }\n");
        const auto roots = listed(analysis);
        EXPECT_GT(roots.at("roots_used"), 10) << analysis;
        EXPECT_LT(roots.at("roots_used"), roots.at("roots_named")) << analysis;
        EXPECT_EQ(roots.at("cells"), 0) << analysis;
    }
}

TEST_F(Kinds, ExplainTellsTheCellsOfAMotionAndTheRootsOfADistance) {
    // Without a worker, both jobs run as long as the test asks.
    const auto explained = [&](const char* name, const char* scenario) {
        write_job(name, "[cluster]\ndepth = { a = 6, b = 4 }\n");
        const std::string at = master_->address();
        const Ran sent = tests::run({cdctl(), "submit", folder_ / "job.toml", "--master", at});
        EXPECT_EQ(sent.exit_code, 0) << sent.errors;
        Ran told;
        EXPECT_TRUE(comes_true([&] {
            told = tests::run({cdctl(), "explain", "last", scenario, "--master", at});
            return told.errors.find("being prepared") == std::string::npos;
        }));
        EXPECT_EQ(told.exit_code, 0) << told.errors;
        return told.output;
    };
    const std::string motion = explained("motion", "0");
    EXPECT_THAT(motion, testing::ContainsRegex("tests       [1-9][0-9]* cells of time, [1-9]"));
    const std::string distance = explained("distance", "3");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(
        distance, found, std::regex("needs +([0-9]+) of ([0-9]+) pairs of roots")))
        << distance;
    EXPECT_GT(std::stoi(found[1]), 0);
    EXPECT_LT(std::stoi(found[1]), std::stoi(found[2]));
}

} // namespace cd::tests
