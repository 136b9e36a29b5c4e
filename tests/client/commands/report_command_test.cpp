// Proves that `cdctl report` writes a whole report of a run: well-formed, without script or
// address, with everything that was found and what was not tested, whatever names the run has.
#include "client/base/exit_code.hpp"
#include "client/commands/commands.hpp"
#include "client/document/html.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/client.hpp"
#include "tests/support/process.hpp"
#include "tests/support/report_answers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace fs = std::filesystem;

/// Returns a tetrahedron with its corner at (x, 0, 0) as a group of an OBJ file; `first` is its
/// first vertex's number.
std::string tetrahedron(const std::string& name, double x, int first) {
    std::ostringstream text;
    text << "g " << name << "\n";
    for (const auto& [dx, dy, dz] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
        text << "v " << x + dx << " " << dy << " " << dz << "\n";
    }
    for (const auto& [i, j, k] : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        text << "f " << first + i << " " << first + j << " " << first + k << "\n";
    }
    return text.str();
}

class ReportFile : public testing::Test {
  protected:
    ReportFile() {
        report_.run = (folder_ / "out").string();
        report_.out = (folder_ / "r" / "report.html").string();
        report_.threads = 1;
    }

    /// Writes a job in which B (a post) is away from A, across its wheel, across its body, and
    /// touches its body at a corner; in that order.
    void write_job(const std::string& wheel, const std::string& body, const std::string& query) {
        write_text(folder_ / "a.obj", tetrahedron(wheel, 0, 1) + tetrahedron(body, 5, 5));
        write_text(folder_ / "b.obj", tetrahedron("post", 0, 1));
        write_text(folder_ / "poses.csv",
                   "id,t,x,y,z\nstart,0,0,9,0\nleft,0.5,0.25,0.1,0.1\nright,1,5.25,0.1,0.1\n"
                   "end,1.5,6,0,0\n");
        write_text(folder_ / "job.toml",
                   "name = \"" + name_ + "\"\n[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n" +
                       poses_ + "\n[query]\n" + query +
                       "\n[output]\ndir = \"out\"\nformats = [\"csv\"]\n");
    }

    void run_job() {
        RunCommand run;
        run.job.file = (folder_ / "job.toml").string();
        run.host.threads = 1;
        run.quiet = true;
        testing::internal::CaptureStdout();
        const int code = execute(run);
        const std::string told = testing::internal::GetCapturedStdout();
        ASSERT_EQ(code, exit_done) << told;
    }

    int report() {
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = execute(report_);
        stdout_ = testing::internal::GetCapturedStdout();
        stderr_ = testing::internal::GetCapturedStderr();
        return code;
    }

    [[nodiscard]] std::string html() const { return read_text(report_.out); }
    /// Checks what each report with a viewer promises, and returns the answers that it holds.
    [[nodiscard]] std::map<std::string, std::string> expect_a_viewer() const {
        const std::string page = html();
        const std::size_t script = page.find("<script type=\"module\">");
        const std::size_t begin = page.find('>', script) + 1;
        const std::size_t end = page.find("</script>", begin);
        EXPECT_NE(end, page.npos);
        EXPECT_EQ(page.find("<script", script + 1), page.npos) << "there is one script";
        EXPECT_THAT(page.substr(0, 1000), HasSubstr("default-src 'none'; script-src 'sha256-"));
        EXPECT_THAT(page, HasSubstr("'sha256-" + hash_of(page.substr(begin, end - begin)) + "'"));
        EXPECT_THAT(page.substr(end), StartsWith("</script></body></html>"));
        // All but the script is well-formed, so that no name ended an element.
        expect_well_formed(page.substr(0, begin) + page.substr(end));
        EXPECT_THAT(page,
                    HasSubstr("needs a browser of 2023 or later that runs this file's script"));
        EXPECT_LT(page.size(), limits::report_with_viewer_bytes_max);
        return answers_in(page);
    }

    static std::string hash_of(const std::string& text) {
        const Sha256 hash = sha256(std::as_bytes(std::span(text)));
        std::string base64 =
            data_address("", {reinterpret_cast<const char*>(hash.bytes.data()), 32});
        return base64.substr(base64.find(',') + 1);
    }

    static void expect_well_formed(const std::string& page) {
        pugi::xml_document document;
        const auto parsed = document.load_buffer(
            page.data(), page.size(), pugi::parse_default | pugi::parse_doctype);
        EXPECT_TRUE(parsed) << parsed.description() << " at "
                            << page.substr(static_cast<std::size_t>(parsed.offset), 80);
    }

    /// Returns the pictures in the report, each as Base64: the bodies', then the worst scenarios'.
    [[nodiscard]] std::vector<std::string> pictures() const {
        const std::string page = html();
        std::vector<std::string> found;
        const std::string begin = "data:image/png;base64,";
        for (std::size_t at = page.find(begin); at != page.npos; at = page.find(begin, at + 1)) {
            found.push_back(page.substr(at, page.find('"', at) - at));
        }
        return found;
    }

    [[nodiscard]] std::string groups() const { return read_text(folder_ / "r" / "groups.csv"); }

    /// Checks what each report promises.
    void expect_a_good_document() const {
        const std::string page = html();
        expect_well_formed(page);
        EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
        EXPECT_THAT(page, Not(HasSubstr("<script")));
        EXPECT_THAT(page, Not(HasSubstr("http")));
        EXPECT_THAT(page, Not(HasSubstr("url(")));
        EXPECT_LT(page.size(), 5'000'000u);
    }

    const TemporaryFolder folder_;
    std::string name_ = "posts";
    std::string poses_ = "[poses]\nfile = \"poses.csv\"";
    ReportCommand report_;
    std::string stdout_;
    std::string stderr_;
};

} // namespace

TEST_F(ReportFile, HasAllItsParts) {
    write_job("wheel_left", "body", "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    const std::string page = html();
    EXPECT_THAT(page,
                HasSubstr("The bodies are in contact in 3 of 4 scenarios (cross 2, touch 1)."));
    EXPECT_THAT(page, HasSubstr("<td>4 of 4</td>"));
    EXPECT_THAT(page, HasSubstr("Digest "));
    EXPECT_THAT(page, HasSubstr("Everything that was asked was tested."));
    for (const char* section :
         {"Bodies", "Worst scenarios", "Parts in contact", "Pose space", "Groups", "How it ran"}) {
        EXPECT_THAT(page, HasSubstr("<h2>" + std::string(section) + "</h2>"));
    }
    EXPECT_THAT(page, HasSubstr("#2, id right, t 1, cross"));
    EXPECT_THAT(page, HasSubstr("data:image/png;base64,"));
    EXPECT_THAT(page, HasSubstr("8 triangles, 2 parts, closed"));
    EXPECT_THAT(page, HasSubstr("mesh = ")) << "the job file";
    EXPECT_EQ(stdout_, report_.out + ", " + (folder_ / "r" / "groups.csv").string() + "\n");
    EXPECT_THAT(groups(), HasSubstr("\na,body,b,post,cross,2,0.5,"));
    EXPECT_THAT(groups(), HasSubstr("\na,wheel_left,b,post,cross,1,0.25,"));
    EXPECT_THAT(groups(), HasSubstr(",1,2,3,,\n")) << "one episode, from scenario 2 to 3";
}

TEST_F(ReportFile, NamesOfAnyKindAreText) {
    name_ = "<script>alert(1)</script>";
    write_job("<img/src=x/onerror=alert(1)>", "\"'&]]>\u202e" + std::string(10'000, 'x'), "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
    EXPECT_THAT(html(), Not(HasSubstr("\u202e")));
    EXPECT_THAT(html(), Not(HasSubstr("<img/")));
}

TEST_F(ReportFile, SaysThatInsidesAreInNoGroup) {
    write_job("wheel_left", "body", "");
    write_text(folder_ / "b.obj",
               "g post\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\n"
               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write_text(folder_ / "poses.csv", "x,y,z\n0.2,0.2,0.2\n9,9,9\n");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(html(), HasSubstr("1 scenario inside: no triangles meet"));
}

TEST_F(ReportFile, OfLevelAnySaysThatThereAreNoGroups) {
    write_job("wheel_left", "body", "level = \"any\"");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("lists no pairs of triangles (level any)"));
    EXPECT_THAT(html(), HasSubstr("The groups are unknown: groups need level pairs"));
    EXPECT_THAT(html(), Not(HasSubstr("<h2>Groups</h2>")));
    EXPECT_FALSE(fs::exists(folder_ / "r" / "groups.csv"));
    report_.fail_on.cross = true;
    EXPECT_EQ(report(), exit_usage);
}

TEST_F(ReportFile, OfARunWithMapsHasGroups) {
    write_job("wheel_left", "body", "level = \"count\"\nmaps = true");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("lists no pairs of triangles (level count)."));
    EXPECT_THAT(html(), HasSubstr("<h2>Groups</h2>"));
    EXPECT_THAT(html(), Not(HasSubstr("no groups")));
    EXPECT_THAT(html(), Not(HasSubstr("groups are unknown")));
}

TEST_F(ReportFile, PicturesMarkContactsAtEveryLevel) {
    write_job("wheel_left", "body", "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(html(), HasSubstr("Triangles in contact are red"));
    EXPECT_THAT(html(), Not(HasSubstr("run again")));
    const auto marked = pictures();
    ASSERT_EQ(marked.size(), 5u) << "two bodies, three scenarios";
    for (const char* const query : {"level = \"count\"", "level = \"count\"\nmaps = true"}) {
        fs::remove_all(folder_ / "out");
        write_job("wheel_left", "body", query);
        run_job();
        EXPECT_EQ(report(), exit_done) << stderr_;
        EXPECT_EQ(pictures(), marked) << query;
        EXPECT_THAT(html(), HasSubstr("Triangles in contact are red"));
        EXPECT_THAT(html(), HasSubstr("these scenarios were run again for their pictures"));
        EXPECT_THAT(html(), HasSubstr("; wheel_left x post ")) << "the parts in contact";
        EXPECT_THAT(html(), Not(HasSubstr("not marked")));
    }
    fs::remove_all(folder_ / "out");
    write_job("wheel_left", "body", "level = \"any\"");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_EQ(pictures().size(), marked.size());
    EXPECT_EQ(std::set(marked.begin(), marked.end()).count(pictures()[2]), 1u)
        << "the first scenario in contact";
}

TEST_F(ReportFile, StaysSmallWithTheLongestTexts) {
    const std::string name(80, '"'); // Six bytes for each byte in HTML.
    name_ = std::string(80, '\'');
    std::string a = "g " + name + "\nv -9 -9 0\nv 999 -9 0\nv -9 999 0\nf 1 2 3\n";
    std::string b;
    for (int i = 0; i < 16; ++i) {
        const std::string part = std::to_string(10 + i) + name.substr(2);
        a += tetrahedron(part, 0.01 * i, 4 + 4 * i);
        b += tetrahedron(part, -0.003 * i, 1 + 4 * i);
    }
    write_job("a", "b", "");
    write_text(folder_ / "a.obj", a);
    write_text(folder_ / "b.obj", b);
    // Neighbours in the chart have different classes, so that each cell is an element.
    std::string poses = "id,x,y,z\n";
    const std::string id = std::string(150, '"'); // A quote is doubled in CSV.
    for (int i = 0; i < 96 * 96; ++i) {
        const int x = i % 96;
        const int y = i / 96;
        poses += "\"" + std::to_string(i) + id + "\"," + std::to_string(x) + "," +
                 std::to_string(y) + (i == 0 || (x + y) % 2 == 0 ? ",-0.1\n" : ",3\n");
    }
    write_text(folder_ / "poses.csv", poses);
    write_text(folder_ / "job.toml",
               read_text(folder_ / "job.toml") + "#" + std::string(70'000, '"') + "\n");
    run_job();
    fs::copy(folder_ / "out", folder_ / "old", fs::copy_options::recursive);
    report_.judge.baseline = (folder_ / "old").string();
    report_.judge.statuses = (folder_ / "s.toml").string();
    std::string rules = "[[clash]]\na = \"*\"\nb = \"*\"\nstatus = \"approved\"\nnote = \"" +
                        std::string(80, '<') + "\"\n";
    for (int i = 0; i < 40'000; ++i) {
        rules += "[[clash]]\na = \"no " + std::to_string(i) +
                 "\"\nb = \"door\"\nstatus = \"reviewed\"\n";
    }
    write_text(report_.judge.statuses, rules);
    EXPECT_EQ(report(), exit_done);
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("And 39 980 more."));
    EXPECT_THAT(html(), HasSubstr("first 200 of")) << "the table of groups is full";
    std::size_t size = html().size();
    for (const std::string& picture : pictures()) {
        size -= picture.size();
    }
    EXPECT_LT(size + limits::report_pictures_bytes_max * 4 / 3, limits::report_bytes_max)
        << "with the largest pictures";
    EXPECT_GT(size, 1'000'000u) << "the texts of this test are long";
}

TEST_F(ReportFile, ItsMatrixKeepsPartsWithLongNamesApart) {
    const std::string common(80, 'x');
    write_job(common + "_wheel", common + "_body", "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    const std::string page = html();
    const std::string matrix =
        page.substr(page.find("<h2>Parts in contact</h2>"),
                    page.find("<h2>Pose space</h2>") - page.find("<h2>Parts in contact</h2>"));
    EXPECT_THAT(matrix, HasSubstr(">2</td>")) << "scenarios of the body";
    EXPECT_THAT(matrix, HasSubstr(">1</td>")) << "scenarios of the wheel";
    EXPECT_THAT(matrix, Not(HasSubstr(">3</td>")));
}

TEST_F(ReportFile, OfAGridHasAMap) {
    poses_ = "[poses]\ngrid = { x = [-1, 7, 9], yaw_deg = [0, 90, 2] }";
    write_job("wheel_left", "body", "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr(">x [m]</text>"));
    EXPECT_THAT(html(), HasSubstr(">yaw [deg]</text>"));
    EXPECT_THAT(html(), Not(HasSubstr("95 % interval")));
}

TEST_F(ReportFile, OfRandomPosesSaysThatTheyWerePushed) {
    poses_ = "[poses]\nrandom = { n = 5, seed = 1 }";
    write_job("wheel_left", "body", "");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("The poses were pushed to contact"));
    EXPECT_THAT(html(), Not(HasSubstr("95 % interval")));
}

TEST_F(ReportFile, SaysWhereBCoincidesWithA) {
    poses_ = "[poses]\ngrid = { x = [-9, 9, 3] }";
    write_job("wheel_left", "body", "");
    write_text(folder_ / "b.obj", read_text(folder_ / "a.obj"));
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(html(), HasSubstr("B coincides with A in 1 scenario: #1"));
}

TEST_F(ReportFile, SaysWhereBodiesOfOneMeshCoincideInAScene) {
    write_text(folder_ / "a.obj", tetrahedron("body", 5, 1));
    write_text(folder_ / "b.obj", tetrahedron("post", 0, 1));
    write_text(folder_ / "poses.csv",
               "step,body,x\n0,post.0,1\n0,post.1,1.5\n1,post.0,1\n1,post.1,1\n");
    write_text(folder_ / "job.toml",
               "[bodies]\nground = { mesh = \"a.obj\", pose = [0, 0, 0, 1, 0, 0, 0], "
               "quat_order = \"wxyz\" }\n"
               "post = { mesh = \"b.obj\", count = 2 }\n[poses]\nfile = \"poses.csv\"\n"
               "[output]\ndir = \"out\"\n");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(html(), HasSubstr("Two bodies of one mesh coincide in 1 scenario: #1"));
}

TEST_F(ReportFile, ShowsWhatPeopleDecided) {
    write_job("wheel_left", "body", "");
    run_job();
    report_.judge.statuses = (folder_ / "s.toml").string();
    write_text(
        report_.judge.statuses,
        "[[clash]]\na = \"wheel_*\"\nb = \"post\"\nstatus = \"approved\"\nnote = \"wanted\"\n"
        "[[clash]]\na = \"door\"\nb = \"post\"\nstatus = \"reviewed\"\n");
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_EQ(stderr_, report_.judge.statuses + ":6: clash \"door\", \"post\" matches no group\n");
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("<td>approved</td><td>wanted</td>"));
    EXPECT_THAT(html(), HasSubstr("matches no group"));
    EXPECT_THAT(groups(), HasSubstr(",approved,wanted\n"));
}

TEST_F(ReportFile, OfCutListsGivesNoShares) {
    write_job("wheel_left", "body", "limit_pairs = 1");
    run_job();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(html(), HasSubstr("ends at 1 pair"));
    EXPECT_THAT(groups(), HasSubstr(",cross,1,,1,"));
}

TEST_F(ReportFile, JudgesARunByItsBaseline) {
    write_job("wheel_left", "body", "");
    run_job();
    fs::rename(folder_ / "out", folder_ / "old");
    write_job("wheel_right", "body", "");
    run_job();
    report_.judge.baseline = (folder_ / "old").string();
    report_.fail_on.news = true;
    EXPECT_EQ(report(), exit_contacts) << stderr_;
    expect_a_good_document();
    EXPECT_THAT(html(), HasSubstr("<h2>Against the baseline</h2>"));
    EXPECT_THAT(html(), HasSubstr("<tr><td>1</td><td>1</td><td>1</td><td>0</td>"))
        << "one group is new, one active, one resolved";
    EXPECT_THAT(groups(), HasSubstr("\na,wheel_right,b,post,cross,1,0.25,"));
    EXPECT_THAT(groups(), HasSubstr("\na,wheel_left,b,post,cross,1,,"))
        << "a group that is gone has no share";
    EXPECT_THAT(html(), HasSubstr("#1 of the baseline"));
    EXPECT_THAT(groups(), HasSubstr(",resolved,\n"));

    report_.run = report_.judge.baseline;
    EXPECT_EQ(report(), exit_done) << "a run has no news against itself";
    EXPECT_THAT(groups(), Not(HasSubstr("new")));
}

TEST_F(ReportFile, AGroupIsNotComparableIfAScenarioOfItIsGone) {
    write_job("wheel_left", "body", "");
    run_job();
    fs::rename(folder_ / "out", folder_ / "old");
    write_text(folder_ / "poses.csv", "id,t,x,y,z\nstart,0,0,9,0\nright,1,5.25,0.1,0.1\n");
    run_job();
    report_.judge.baseline = (folder_ / "old").string();
    report_.fail_on.news = true;
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(groups(), HasSubstr(",not comparable,\n"));
}

TEST_F(ReportFile, ABaselineIsNeededForNews) {
    write_job("wheel_left", "body", "");
    run_job();
    report_.fail_on.news = true;
    EXPECT_EQ(report(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("--fail-on new compares with an earlier run: give --baseline"));
    report_.judge.baseline = (folder_ / "none").string();
    report_.master.address = "";
    EXPECT_EQ(report(), exit_usage);
    EXPECT_THAT(stderr_, HasSubstr("there is no folder"));
}

TEST_F(ReportFile, PiecesAreWarnedOf) {
    write_job("wheel_left", "wheel_left", "");
    write_text(folder_ / "a.obj",
               tetrahedron("", 0, 1).substr(2) + tetrahedron("", 5, 5).substr(2));
    run_job();
    report_.judge.baseline = (folder_ / "out").string();
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_THAT(stderr_, HasSubstr("body a has no named parts"));
    EXPECT_THAT(groups(), HasSubstr("\na,piece 2,b,"));
}

TEST_F(ReportFile, FailsOnWhatIsAsked) {
    write_job("wheel_left", "body", "");
    run_job();
    report_.fail_on.touch = true;
    EXPECT_EQ(report(), exit_contacts);
    EXPECT_TRUE(fs::exists(report_.out)) << "the report is written all the same";
    report_.fail_on = {.undecided = true};
    EXPECT_EQ(report(), exit_done);
}

TEST_F(ReportFile, WithAViewerHoldsMeshesAndTheWorstScenarios) {
    write_job("wheel_left", "body", "level = \"count\"\nmaps = true");
    run_job();
    report_.has_viewer = true;
    EXPECT_EQ(report(), exit_done) << stderr_;
    const auto answers = expect_a_viewer();
    const auto job = nlohmann::json::parse(answers.at("jobs/folder"));
    for (const auto& body : job.at("bodies")) {
        const std::string& mesh = answers.at("meshes/" + body.at("sha256").get<std::string>());
        EXPECT_EQ(to_hex(sha256(std::as_bytes(std::span(mesh)))), body.at("sha256"));
    }
    std::size_t scenarios = 0;
    for (const auto& [path, text] : answers) {
        scenarios += path.starts_with("jobs/folder/scenarios/") && path.ends_with("/pairs") ? 1 : 0;
    }
    EXPECT_EQ(scenarios, 3u) << "those in contact";
    const auto scenario = nlohmann::json::parse(answers.at("jobs/folder/scenarios/2"));
    EXPECT_EQ(scenario.at("class"), "cross");
    EXPECT_EQ(scenario.at("verified"), true);
    EXPECT_THAT(answers.at("jobs/folder/map/1"), HasSubstr("NUMPY"));
    EXPECT_THAT(answers.at("app.css"), HasSubstr(":host"));
    EXPECT_THAT(html(), HasSubstr("<h2>In 3D</h2>"));
    EXPECT_THAT(html(), HasSubstr("Permission is hereby granted")) << "the libraries' licences";
}

TEST_F(ReportFile, WithAViewerHoldsTheOtherBodiesOfAStepIfThereIsRoom) {
    write_text(folder_ / "a.obj", tetrahedron("a", 0, 1));
    write_text(folder_ / "b.obj", tetrahedron("b", 0, 1));
    write_text(folder_ / "poses.csv", "step,body,x\n0,left,0\n0,right,0.5\n");
    write_text(
        folder_ / "job.toml",
        "[bodies]\nleft = { mesh = \"a.obj\" }\nright = { mesh = \"a.obj\" }\n"
        "post = { mesh = \"b.obj\", pose = [0, 0, 0.1, 0, 0, 0, 1], quat_order = \"xyzw\" }\n"
        "[poses]\nfile = \"poses.csv\"\n[output]\ndir = \"out\"\n");
    run_job();
    report_.has_viewer = true;
    EXPECT_EQ(report(), exit_done) << stderr_;
    const auto answers = expect_a_viewer();
    for (const char* const path : {"steps?first=0&amp;count=1", "poses?first=0&amp;count=3"}) {
        EXPECT_TRUE(answers.contains("jobs/folder/" + std::string(path))) << path;
    }
    EXPECT_THAT(stderr_, Not(HasSubstr("no room")));
    report_.bytes_max = limits::report_bytes_max; // Enough for the viewer alone.
    EXPECT_EQ(report(), exit_done) << stderr_;
    EXPECT_FALSE(answers_in(html()).contains("jobs/folder/poses?first=0&amp;count=3"));
    EXPECT_THAT(stderr_,
                HasSubstr("the viewer has no room for the other bodies of 1 step; cdctl view "));
}

TEST_F(ReportFile, WithAViewerNamesOfAnyKindAreText) {
    name_ = "</template></script><script>alert(1)</script>";
    write_job("</template><script>alert(1)</script>", "<!--\"'&]]>\u202e", "");
    run_job();
    report_.has_viewer = true;
    EXPECT_EQ(report(), exit_done) << stderr_;
    const auto answers = expect_a_viewer();
    EXPECT_THAT(answers.at("jobs/folder"), HasSubstr("</script><script>alert(1)"))
        << "the page gets the names as they are";
}

TEST_F(ReportFile, ThatIsTooLargeIsRefusedBeforeAnythingIsWritten) {
    write_job("wheel_left", "body", "");
    run_job();
    report_.has_viewer = true;
    EXPECT_EQ(report(), exit_done) << stderr_;
    const std::uint64_t size = html().size();
    fs::remove_all(folder_ / "r");
    report_.pictures = (folder_ / "r" / "pictures").string();
    for (const std::uint64_t bytes_max : {std::uint64_t{100'000}, size - 1}) {
        report_.bytes_max = bytes_max;
        EXPECT_EQ(report(), exit_usage);
        EXPECT_THAT(stderr_, HasSubstr("with --3d the report takes 0."));
        EXPECT_THAT(
            stderr_,
            HasSubstr("leave out --3d, and see the run in 3D with: cdctl view " + report_.run));
        EXPECT_FALSE(fs::exists(folder_ / "r"));
    }
    report_.bytes_max = size;
    EXPECT_EQ(report(), exit_done) << stderr_;
    report_.has_viewer = false;
    report_.bytes_max = 0;
    EXPECT_EQ(report(), exit_done) << "the limit is for reports with a viewer";
    expect_a_good_document();
}

TEST_F(ReportFile, WithoutContactsHasNoViewer) {
    write_job("wheel_left", "body", "");
    write_text(folder_ / "poses.csv", "x,y,z\n9,9,9\n");
    run_job();
    report_.has_viewer = true;
    EXPECT_EQ(report(), exit_done);
    EXPECT_EQ(stderr_, "no scenario is in contact: there is nothing to show in 3D\n");
    expect_a_good_document();
}

TEST_F(ReportFile, DrawsLargePicturesIntoAFolder) {
    write_job("wheel_left", "body", "");
    run_job();
    report_.pictures = (folder_ / "pictures").string();
    EXPECT_EQ(report(), exit_done) << stderr_;
    for (const char* name : {"a.png", "b.png", "1.png", "2.png", "3.png"}) {
        EXPECT_TRUE(fs::exists(folder_ / "pictures" / name)) << name;
    }
}

} // namespace cd::tests
