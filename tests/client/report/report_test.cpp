// Proves that a run's output reports what happened: sizes, progress, classes, coverage, digest.
#include "client/report/report.hpp"

#include "client/export/result_sink.hpp"
#include "client/report/progress.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

constexpr SummaryStyle with_statistics{false, true};

Summary example_summary() {
    Summary summary;
    summary.total = 100'000;
    summary.separate = 87'302;
    summary.touch = 41;
    summary.cross = 12'557;
    summary.inside = 100;
    summary.pairs = 1'204'883;
    return summary;
}

BodyLine body(const std::string& name, const Vec3& size) {
    BodyLine line;
    line.name = name;
    line.unit = "m";
    line.triangles = 48'212;
    line.size = size;
    line.parts = 12;
    line.closed = true;
    return line;
}

/// Returns all that a printer of this style writes.
template <class Print>
std::string printed(ProgressPrinter::Style style, const Print& print) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    {
        ProgressPrinter printer(style, stream);
        print(printer);
    }
    std::fclose(stream);
    std::string copy(text, size);
    std::free(text);
    return copy;
}

ProgressState at(double seconds) {
    ProgressState state{"j-1", {}, seconds};
    state.summary.total = 100;
    state.summary.separate = static_cast<std::uint64_t>(seconds);
    return state;
}

} // namespace

TEST(Report, TheHeaderGivesSizes) {
    BodyLine small = body("bollard.glb", {0.22, 0.22, 1.05});
    small.parts = 1;
    small.triangles = 6'340;
    small.closed = false;
    EXPECT_EQ(header_text(body("van.glb", {4.91, 2.02, 2.31}), small, 100'000, "grid"),
              "  A  van.glb          48 212 triangles   4.91 x 2.02 x 2.31 m   closed   12 parts\n"
              "  B  bollard.glb       6 340 triangles   0.22 x 0.22 x 1.05 m   open     1 part\n"
              "  poses              100 000  grid\n");
}

TEST(Report, ASizeRatioOfAUnitIsWarnedAbout) {
    const BodyLine meters = body("a.obj", {4.0, 1, 1});
    EXPECT_THAT(unit_warning(meters, body("b.stl", {4010, 1000, 1000})).value_or(""),
                HasSubstr("b.stl is 1002.2 times as large as a.obj"));
    EXPECT_TRUE(unit_warning(body("b", {4.0 * 25.5, 25.4, 25.4}), meters));
    EXPECT_FALSE(unit_warning(meters, body("b", {4.0 * 26, 26, 26})));
    EXPECT_FALSE(unit_warning(meters, body("b", {3, 1, 1})));
    // One body, turned: its longest edge differs, its diagonal does not.
    EXPECT_TRUE(unit_warning(body("a", {3, 4, 0}), body("b", {5000, 0, 0})));
    EXPECT_FALSE(unit_warning(meters, body("point", {0, 0, 0})));
}

TEST(Report, TheSummaryCoversEveryScenario) {
    RunReport report;
    report.summary = example_summary();
    report.digest = sha256({});
    report.execution.seconds = 1.718;
    report.execution.where = "2 workers";
    report.findings.most_touched = {{"front_bumper", 6'100}};
    EXPECT_EQ(
        summary_text(report),
        "done in 1.72 s      58 207 scenarios/s, 2 workers\n"
        "  separate  87 302    touch 41    cross 12 557 (1 204 883 pairs)    inside 100    failed 0"
        "    tested 100 000 of 100 000\n"
        "  most touched  front_bumper 6.1 %\n"
        "  digest        " +
            to_short_hex(sha256({})) + "\n");
}

TEST(Report, TheSummaryCountsNearScenariosOfAClearance) {
    RunReport report;
    report.summary = example_summary();
    EXPECT_THAT(summary_text(report), Not(HasSubstr("near")));
    report.query.clearance = 0.005;
    EXPECT_THAT(summary_text(report), HasSubstr("inside 100    near 0    failed 0"));
    report.summary.near = 12;
    report.summary.near_pairs = 3'400;
    EXPECT_THAT(summary_text(report), HasSubstr("inside 100    near 12 (3 400 pairs)    failed 0"));
    EXPECT_THAT(summary_text(report, {true, false}), HasSubstr("\x1b[33mnear 12\x1b[0m"));
}

TEST(Report, TheSummaryNamesTheScenarioOfLeastDistance) {
    RunReport report;
    report.summary = example_summary();
    EXPECT_THAT(summary_text(report), Not(HasSubstr("apart")));
    report.findings.least = LeastDistance{0.00123456, 4'711, "m"};
    EXPECT_THAT(summary_text(report), HasSubstr("\n  least apart   0.00123 m in scenario 4 711\n"));
}

TEST(Report, TheSummaryNamesTheFirstEventOfMotions) {
    RunReport report;
    report.summary = example_summary();
    EXPECT_THAT(summary_text(report), Not(HasSubstr("  first ")));
    report.findings.first_event = FirstEvent{FirstEvent::Kind::Contact, 4'711, 2.5, 5};
    EXPECT_THAT(summary_text(report),
                HasSubstr("\n  first contact between t 2.5 and 5 in scenario 4 711\n"));
    report.findings.first_event = FirstEvent{FirstEvent::Kind::Near, 3, 5, 5};
    EXPECT_THAT(summary_text(report), HasSubstr("\n  first near    at t 5 in scenario 3\n"));
    report.findings.first_event = FirstEvent{FirstEvent::Kind::Free, 3, 2.5, 5};
    EXPECT_THAT(summary_text(report), HasSubstr("\n  first free    from t 5 on in scenario 3\n"));
}

TEST(Report, TheFirstEventIsTheOneProvenFirst) {
    std::optional<FirstEvent> first;
    keep_first(std::nullopt, first);
    EXPECT_FALSE(first);
    keep_first(FirstEvent{FirstEvent::Kind::Contact, 7, 2, 4}, first);
    keep_first(FirstEvent{FirstEvent::Kind::Contact, 8, 3, 4}, first);
    EXPECT_EQ(first->scenario, 7u);
    keep_first(FirstEvent{FirstEvent::Kind::Contact, 9, 2.5, 3.5}, first);
    keep_first(std::nullopt, first);
    EXPECT_EQ(first->scenario, 9u);
}

TEST(Report, UndecidedSaysWhatStaysOpen) {
    RunReport report;
    report.summary = example_summary();
    report.summary.undecided = 3;
    EXPECT_THAT(summary_text(report),
                HasSubstr("undecided     in 3 scenarios: an earlier version left small boxes"));
    report.query.question = Question::Motion;
    report.query.motion = MotionQuery{0.01};
    EXPECT_THAT(summary_text(report),
                HasSubstr("undecided     in 3 scenarios: parts of the time stay open"));
}

TEST(Report, WhatWasNotTestedIsNotCalledDone) {
    RunReport report;
    report.summary = example_summary();
    report.summary.separate -= 10;
    report.summary.surfaces_only = 3;
    report.summary.insides_skipped = 4;
    report.summary.cut = 2;
    const std::string text = summary_text(report);
    EXPECT_THAT(text, HasSubstr("ended after"));
    EXPECT_THAT(text, HasSubstr("tested 99 990 of 100 000"));
    EXPECT_THAT(text, HasSubstr("surfaces only  in 3 scenarios"));
    EXPECT_THAT(text, HasSubstr("containment not tested  in 4 scenarios: parts are ignored"));
    EXPECT_THAT(text, HasSubstr("limit_pairs was reached"));
    EXPECT_THAT(text, Not(HasSubstr("digest")));
}

TEST(Report, AQuietRunWarnsAllTheSame) {
    RunReport report;
    report.summary = example_summary();
    const auto told = [&](bool quiet) {
        testing::internal::CaptureStderr();
        EXPECT_TRUE(print_summary(report, true, quiet, false));
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_EQ(told(true), "");
    report.folder.inputs_are_too_large = true;
    report.map_withdrawn = "workers differ";
    EXPECT_EQ(told(true),
              "  map           withdrawn: workers differ; run the job again\n"
              "  inputs        not kept, since they are too large: opening the folder again needs "
              "their files\n");
    EXPECT_THAT(told(false), HasSubstr(told(true)));
}

TEST(Report, TheSummaryTellsOfPreparationResumptionAndItsFile) {
    RunReport report;
    report.summary = example_summary();
    report.execution.seconds = 0.04;
    report.execution.prepare_seconds = 1.14;
    report.execution.resumed_at = 99'000;
    report.folder.summary_file = "out/summary.json";
    const std::string text = summary_text(report);
    EXPECT_THAT(text, testing::StartsWith("done in 0.04 s (1.1 s to read and build)      25 000 "));
    EXPECT_THAT(text, testing::EndsWith("  open it: cdctl view out\n"));
    report.folder.summary_file = "my out/summary.json";
    EXPECT_THAT(summary_text(report), testing::EndsWith("  open it: cdctl view 'my out'\n"));
}

TEST(Report, CutListsGiveNoShareOfTriangles) {
    RunReport report;
    report.summary = example_summary();
    report.query.limit_pairs = 3;
    report.findings.most_touched = {{"front_bumper", 6'100}, {"door", 7}};
    report.map.emplace();
    report.map->bodies[0].push_back({5, 2});
    std::string text = summary_text(report);
    EXPECT_THAT(
        text,
        HasSubstr("most touched  front_bumper 6 100, door 7, of the first 3 pairs a scenario"));
    EXPECT_THAT(text,
                HasSubstr("1 triangle of A and 0 of B were in contact, of the first 3 pairs a "
                          "scenario; digest "));
    report.query.maps = true; // Counts by part stay limited.
    text = summary_text(report);
    EXPECT_THAT(text, HasSubstr("1 triangle of A and 0 of B were in contact; digest "));
    report.query.clearance = 0.01;
    EXPECT_THAT(summary_text(report), HasSubstr("0 of B were in contact or near; digest "));
    EXPECT_THAT(text, HasSubstr("door 7, of the first 3 pairs a scenario"));
}

TEST(Report, LevelAnyKnowsContactAndInside) {
    RunReport report;
    report.query.level = Level::Any;
    report.summary.total = 4;
    report.summary.separate = 1;
    report.summary.contact = 2;
    report.summary.inside = 1;
    EXPECT_THAT(summary_text(report),
                HasSubstr("separate  1    contact 2    inside 1    failed 0"));
}

TEST(Report, LinesAreSeparateOrInContactWithHits) {
    RunReport report;
    report.query.question = Question::Shots;
    report.summary.total = 4;
    report.summary.separate = 4;
    EXPECT_THAT(summary_text(report),
                HasSubstr("separate  4    contact 0 (0 hits)    failed 0    tested 4 of 4"));
    report.summary.separate = 3;
    report.summary.contact = 1;
    report.summary.pairs = 5;
    EXPECT_THAT(summary_text(report), HasSubstr("separate  3    contact 1 (5 hits)    failed 0"));
}

TEST(Report, TheLeastDistanceIsOfTheFirstScenarioThatHasIt) {
    std::optional<LeastDistance> least;
    ScenarioResult result;
    note_least(result, "m", least);
    EXPECT_FALSE(least) << "the result has no distance";
    for (const double distance : {0.5, 0.25, 0.25, 1.0}) {
        result.nearest = NearestWitness{distance, 0, 0};
        note_least(result, "m", least);
        ++result.index;
    }
    ASSERT_TRUE(least);
    EXPECT_EQ(least->distance, 0.25);
    EXPECT_EQ(least->scenario, 1u);
    EXPECT_EQ(least->unit, "m");
}

TEST(Report, StatisticsSayWhatWasVisitedAndAtWhatPrecision) {
    RunReport report;
    report.summary.total = 10;
    report.summary.separate = 10;
    report.execution.statistics.search.box_tests = 135'170;
    report.execution.statistics.search.triangle_tests = 100'000;
    report.execution.statistics.search.decisions[PairStage::Float] = 99'999;
    report.execution.statistics.search.decisions[PairStage::WideInteger] = 1;
    report.execution.statistics.inside = {4, 0.25, {}};
    EXPECT_THAT(summary_text(report), Not(HasSubstr("visited"))) << "unless it is asked for";
    const std::string text = summary_text(report, with_statistics);
    EXPECT_THAT(text,
                HasSubstr("  visited       13 517 box pairs, 10 000 candidates a scenario; settled "
                          "in float > 99.99 %, wide integer < 0.01 %\n"));
    EXPECT_THAT(text, HasSubstr("  inside        looked at in 4 scenarios, 0.250 s of one thread"));
    EXPECT_THAT(text, Not(HasSubstr("  cost")));
}

TEST(Report, TheCostIsThePapersSumOfTheMeanScenario) {
    RunReport report;
    report.summary.total = 10;
    report.summary.separate = 10;
    report.execution.statistics.search.box_tests = 135'170;
    report.execution.statistics.search.triangle_tests = 100'000;
    report.execution.cost = SearchCost{2, 10};
    EXPECT_THAT(
        summary_text(report, with_statistics),
        HasSubstr("  cost          N_b C_b + N_p C_p = 13 517 x 2.00 ns + 10 000 x 10.00 ns "
                  "= 127.0 us a scenario\n"));
}

TEST(Report, TrafficAndDepthsAreToldOfAClusterAlone) {
    RunReport report;
    report.summary = example_summary();
    EXPECT_THAT(summary_text(report, with_statistics), Not(HasSubstr("geometry")));
    report.execution.traffic = JobTraffic{{990, 10, 0, 3, 2u << 20, 1u << 20}, 4096};
    const std::string text = summary_text(report, with_statistics);
    EXPECT_THAT(text, HasSubstr("  geometry      2.0 MiB from the master, 1.0 MiB from other"));
    EXPECT_THAT(text,
                HasSubstr("held what was needed 990 times, asked for it 10 times (99.00 %), 3 "
                          "evicted\n"));
    EXPECT_THAT(text, HasSubstr("  sent back     4.0 KiB of results\n"));
    EXPECT_THAT(text, Not(HasSubstr("depths")));
    report.execution.traffic->blocks.hinted = 7;
    report.execution.depths = {6, 4};
    EXPECT_THAT(summary_text(report, with_statistics),
                HasSubstr("(99.00 %), 7 asked for ahead, 3 evicted\n"));
    EXPECT_THAT(summary_text(report, with_statistics),
                HasSubstr("  depths        A cut at 6, B at 4\n"));
}

TEST(Report, UndecidedScenariosAreToldWithTheReason) {
    RunReport report;
    report.summary.total = 3;
    report.summary.undecided = 3;
    EXPECT_THAT(summary_text(report), HasSubstr("undecided 3"));
    EXPECT_THAT(summary_text(report),
                HasSubstr("in 3 scenarios: an earlier version left small boxes"));
}

TEST(Report, ColoursComeOnlyWhenAskedFor) {
    RunReport report;
    report.summary = example_summary();
    EXPECT_THAT(summary_text(report), Not(HasSubstr("\x1b")));
    EXPECT_THAT(summary_text(report, {true, false}), HasSubstr("\x1b[31mcross 12 557\x1b[0m"));
}

TEST(Progress, ABarShowsShareRateAndTimeLeft) {
    ProgressState state{"j-4f2a", example_summary(), 1.0};
    state.summary.separate = 50'000 - 12'698;
    EXPECT_EQ(
        progress_text(state, true),
        "j-4f2a  [#############-------------]  50%  50 000/100 000   50.0 k/s   contact 12 698   "
        "ETA 0:01");
}

TEST(Progress, WhatWasDoneBeforeIsNoPartOfTheRate) {
    ProgressState state = at(1);
    state.summary.separate = 60;
    state.resumed = 50;
    EXPECT_EQ(progress_text(state, false), "j-1  60%  60/100   10/s   contact 0   ETA 0:04");
    state.summary.near = 12;
    state.summary.separate -= 12;
    EXPECT_EQ(progress_text(state, false),
              "j-1  60%  60/100   10/s   contact 0   near 12   ETA 0:04");
}

TEST(Progress, AJobThatStandsStillShowsNoTimeLeft) {
    ProgressState state = at(50);
    state.note = {"lost: w-1; others do the work"};
    EXPECT_THAT(progress_text(state, false), HasSubstr("ETA 0:50"));
    state.note = {"no worker is connected", true};
    EXPECT_THAT(progress_text(state, false), Not(HasSubstr("ETA")));
}

TEST(Progress, NotesComeAloneWhereNoProgressIsWanted) {
    const std::string text = printed(ProgressPrinter::Style::Notes, [](ProgressPrinter& printer) {
        printer.update(at(20));
        ProgressState state = at(40);
        state.note = {"no worker is connected", true};
        printer.update(state);
        printer.update(state);
        printer.finish(at(60));
    });
    EXPECT_EQ(text, "j-1  no worker is connected\n");
}

TEST(Progress, WithoutATerminalALineComesEachTenSeconds) {
    const std::string text = printed(ProgressPrinter::Style::Lines, [](ProgressPrinter& printer) {
        for (const double seconds : {0.0, 5.0, 9.9, 10.0, 15.0, 19.9, 20.5, 21.0}) {
            printer.update(at(seconds));
        }
        printer.finish(at(21));
    });
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
    EXPECT_THAT(text, HasSubstr("j-1  10%  10/100"));
    EXPECT_THAT(text, HasSubstr("j-1  20%  20/100"));
}

TEST(Progress, ABarIsRedrawnOnItsLine) {
    const std::string text = printed(ProgressPrinter::Style::Bar, [](ProgressPrinter& printer) {
        printer.update(at(0));
        printer.update(at(0.05));
        printer.update(at(1));
    });
    EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
    EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, ANoteStandsUnderTheBar) {
    const std::string text = printed(ProgressPrinter::Style::Bar, [](ProgressPrinter& printer) {
        ProgressState state = at(1);
        state.note = {"no worker is connected", true};
        printer.update(state);
        printer.update(state);
        printer.update(at(1.01));
    });
    EXPECT_THAT(text, HasSubstr("\x1b[K\nno worker is connected\x1b[K\x1b[A\r"));
    EXPECT_THAT(text, HasSubstr("\x1b[K\n\x1b[K\x1b[A\r")) << "taken away when it is over";
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << "and not drawn without need";
}

TEST(Progress, WithoutATerminalEachNoteIsPrintedOnce) {
    const std::string text = printed(ProgressPrinter::Style::Lines, [](ProgressPrinter& printer) {
        ProgressState state = at(1);
        state.note = {"no worker is connected", true};
        printer.update(state);
        printer.update(state);
        state.note = {"paused: disk full", true};
        printer.update(state);
    });
    EXPECT_EQ(text, "j-1  no worker is connected\nj-1  paused: disk full\n");
}

TEST(Progress, OnANarrowTerminalALineIsCut) {
    int screen = -1;
    int terminal = -1;
    const winsize size{24, 20, 0, 0};
    ASSERT_EQ(::openpty(&screen, &terminal, nullptr, nullptr, &size), 0);
    std::FILE* stream = ::fdopen(terminal, "w");
    {
        ProgressPrinter printer(ProgressPrinter::Style::Bar, stream);
        ProgressState state = at(1);
        state.name = "caf\xc3\xa9-caf\xc3\xa9-caf\xc3\xa9-x"; // Its 19th byte is inside a
                                                              // character.
        state.note = {"no worker is connected: start cdworker", true};
        printer.update(state);
    }
    std::string text; // A terminal splits written text at will.
    const std::string note = "\nno worker is connec\x1b[K";
    pollfd ready{screen, POLLIN, 0};
    while (text.find(note) == std::string::npos && ::poll(&ready, 1, 10'000) == 1) {
        std::array<char, 1024> bytes{};
        const ssize_t count = ::read(screen, bytes.data(), bytes.size());
        if (count <= 0) {
            break;
        }
        text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    std::fclose(stream);
    ::close(screen);
    EXPECT_THAT(text, testing::StartsWith("\rcaf\xc3\xa9-caf\xc3\xa9-caf\xc3\xa9-x\x1b[K"));
    EXPECT_THAT(text, HasSubstr(note));
}

TEST(Progress, QuietIsSilent) {
    EXPECT_EQ(printed(ProgressPrinter::Style::Silent,
                      [](ProgressPrinter& printer) {
                          printer.update(at(100));
                          printer.finish(at(100));
                      }),
              "");
}

} // namespace cd::tests
