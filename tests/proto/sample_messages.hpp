// One message of each type with every member set, so that a forgotten or swapped member shows.
#pragma once

#include "proto/codec/message.hpp"

#include <vector>

namespace cd::tests {

inline Bytes some_bytes(std::size_t count, unsigned first = 1) {
    Bytes bytes(count);
    for (std::size_t i = 0; i < count; ++i) {
        bytes[i] = static_cast<std::byte>(first + i);
    }
    return bytes;
}

inline Sha256 some_hash(unsigned first) {
    Sha256 hash;
    for (std::size_t i = 0; i < hash.bytes.size(); ++i) {
        hash.bytes[i] = static_cast<std::byte>(first + i);
    }
    return hash;
}

inline Query some_query() {
    Query query;
    query.level = Level::Contacts;
    query.limit_pairs = 77;
    query.ignored = {{1, 2, 3, 4}, {5, 6, 7, 8, 2, 3}};
    query.clearance = 0.005;
    return query;
}

inline Query some_distance_query() {
    Query query;
    query.level = Level::Any;
    query.ignored = {{1, 2, 3, 4}};
    query.question = Question::Distance;
    query.up_to = 2.5;
    return query;
}

inline Query some_shots_query() {
    Query query;
    query.level = Level::Count;
    query.maps = true;
    query.question = Question::Shots;
    query.first_hits = true;
    return query;
}

inline Query some_motion_query() {
    Query query;
    query.level = Level::Pairs;
    query.limit_pairs = 13;
    query.clearance = 0.5;
    query.question = Question::Motion;
    query.motion = MotionQuery{0.25, Until::End};
    return query;
}

inline QueryStatistics some_statistics() {
    QueryStatistics statistics;
    statistics.box_tests = 13;
    statistics.triangle_tests = 14;
    statistics.decisions.settled = {15, 16, 17, 18, 19, 20};
    statistics.effort = {49, 50, 51, 52};
    return statistics;
}

inline JobStatus some_job_status() {
    JobStatus status;
    status.job = JobId{9};
    status.name = "wheel in arch";
    status.state = JobState::Cancelled;
    status.summary = {{1, 2, 3, 4, 5, 6, 7, 8}, 11, 9, 10, 46, 47, 48};
    status.digest = some_hash(3);
    status.seconds = 1.5;
    status.scenarios_per_second = 2.5;
    status.failure = "none";
    status.bodies = {some_hash(4), some_hash(5)};
    status.answered_by_master = 12;
    status.statistics = {some_statistics(), {21, 4.5, {}}};
    status.compute_seconds = 3.5;
    status.paused = "no space";
    status.long_scenarios = {{26, WorkerId{1}, "node-1", 27.5}};
    status.withdrawn = 28;
    status.recalled = 42;
    status.copies = 43;
    status.copies_won = 44;
    status.traffic = {{33, 34, 35, 36, 37, 38}, 39};
    status.depths = {40, 41};
    status.turn = {"ilan", -4, 0.25};
    status.began = 45;
    return status;
}

inline WorkerStatus some_worker_status() {
    WorkerStatus status;
    status.worker = WorkerId{1};
    status.name = "node-1";
    status.threads = 8;
    status.cache_bytes = 9;
    status.cached_bytes = 10;
    status.claimed = true;
    status.buffered = 11;
    status.working = 12;
    status.tasks = 13;
    status.scenarios = 14;
    status.scenarios_per_second = 15.5;
    status.bytes_sent = 16;
    status.bytes_received = 17;
    status.subtrees_sent = 18;
    status.subtree_bytes_sent = 19;
    status.cache = {{20, 21, 22, 23, 24, 25}, 26};
    status.quarantined = true;
    status.state = WorkerState::Silent;
    status.silent_seconds = 29.5;
    status.longest = RunningScenario{JobId{30}, 31, 32.5};
    return status;
}

inline PoseLabels some_labels() {
    PoseLabels labels;
    labels.integers = {-1, 2};
    labels.texts = {"stop", "start"};
    labels.times = {0.25, 0.5};
    return labels;
}

inline WorkUnit some_batch() {
    WorkUnit batch;
    batch.task = TaskId{1};
    batch.job = JobId{2};
    batch.count = 3;
    batch.scenarios = some_bytes(50);
    batch.pair_offsets = {0, 2, 2, 3};
    batch.pairs = {{0, 5}, {1, 0}, {0, 5}};
    return batch;
}

inline Submit some_submit() {
    Submit submit;
    submit.name = "job";
    submit.unit = "mm";
    submit.owner = "ilan";
    submit.priority = -3;
    submit.bodies = {{some_hash(1), "a", "sedan.obj", "in", true, "y", true, false, {0.5, -1, 2}},
                     {some_hash(2), "b", "van.stl", "m"}};
    submit.query = some_query();
    submit.cluster = {
        "lowest", {10, std::nullopt, 5}, 21, 4097, true, 6, AnalysisMode::Never, false};
    submit.poses = {PosesKind::Random,
                    RandomPoses{7, 8, 0.25, 0.5},
                    "poses.csv",
                    "wxyz",
                    true,
                    0.125,
                    {IdKind::Text, true},
                    "mm",
                    {{-1, 2, 3}},
                    ShotsOrigin{0.5, 64, {0.25, 0.75}, 9, true},
                    std::nullopt,
                    PathOrigin{0.125, 0.5, std::nullopt}};
    submit.scenarios = 1000;
    submit.grid = some_bytes(9);
    submit.retention_seconds = 86400;
    submit.ignore = {{"wheel_*", "ground"}};
    return submit;
}

/// Returns them in order of message number.
inline std::vector<Message> sample_messages() {
    return {
        Hello{protocol_version,
              Role::Worker,
              "node-1",
              "0.1.0",
              8,
              1u << 30,
              4321,
              1.5,
              99,
              {7, 8},
              "ilan@node-1",
              77},
        Welcome{protocol_version,
                42,
                "0.1.0",
                some_hash(17),
                some_hash(18),
                8,
                true,
                2000,
                15000,
                "ilan",
                78},
        Failure{ErrorCode::NotFound, "no job 7"},
        Heartbeat{1, 2, 3, {{4, 5, 6, 7, 8, 9}, 10}, RunningScenario{JobId{10}, 11, 12.5}},
        AddTree{TreeId{1}, SubtreeForm::Wide, some_hash(6), some_hash(7), 32, 1600},
        RemoveTree{TreeId{5}},
        Subtrees{TreeId{6}, {{3, some_hash(9), some_bytes(40)}, {4, some_hash(8), {}}}},
        some_batch(),
        Drain{},
        Terminate{"the operator said so"},
        WantSubtrees{TreeId{2}, {1, 5, 9}},
        Results{TaskId{1},
                JobId{2},
                3,
                some_bytes(30),
                false,
                some_statistics(),
                0.25,
                17,
                {18, 19, 20, 21, 22, 23},
                some_bytes(11)},
        EndOfTask{TaskId{7}},
        Evicted{TreeId{2}, {0, 8}},
        MeshesQuery{{some_hash(1), some_hash(2)}},
        MeshesMissing{{some_hash(2)}},
        MeshPart{some_hash(1), "sedan.obj", 100, 40, some_bytes(60)},
        MeshStored{some_hash(1)},
        some_submit(),
        PosesPart{some_bytes(64), some_labels()},
        PosesEnd{},
        Accepted{JobId{3}},
        Watch{JobId{4}},
        some_job_status(),
        StatusQuery{},
        ClusterStatus{"0.1.0",
                      12.5,
                      3.25,
                      {some_worker_status()},
                      {some_job_status()},
                      {{some_hash(1), "sedan.obj", 5, 6, 0.5, true}},
                      {"results differ"},
                      1,
                      {2, 3, 4},
                      {5, 6, 7, 8, 9, 10},
                      Growth{60, {{1, 31.5}, {2, 22}}, {1, 31.5}}},
        ResultsQuery{JobId{1}, 2, 3, 4},
        ResultsPart{JobId{1}, 2, 9, {{3, 2}, {8, 1}}, 3, some_bytes(30), false},
        Cancel{JobId{8}, 9},
        FetchFromPeers{TreeId{2},
                       {1, 5},
                       {some_hash(1), some_hash(2)},
                       {{WorkerId{3}, "10.0.0.7", 4321, 6, some_hash(7)}}},
        Held{TreeId{2}, {1, 5}},
        FetchFailed{TreeId{2}, {1, 5}, WorkerId{3}, PeerOutcome::Damaged},
        PeerFetch{TreeId{2}, {1, 5}, 6, some_hash(7)},
        PeerFetched{TreeId{2}, {5}, PeerOutcome::Missing},
        Explain{JobId{9}, 10},
        Explained{JobId{9},
                  10,
                  "earliest-finish",
                  true,
                  "waits",
                  "it would be done first",
                  "as things stand now",
                  11,
                  12,
                  {{WorkerId{1}, "node-1", true, false, 13, 0.5, 14, 15, 1, 2, 3, 4, 5, 6}},
                  SearchEffort{41, 21, 12, 3}},
        AddJob{JobId{2},
               {TreeId{3}, TreeId{4}},
               some_motion_query(),
               some_bytes(9),
               {{{0, 1}, {7, 0}}, {{0, 0}}},
               {1.5, 2.5}},
        RemoveJob{JobId{2}},
        ResultsKept{{3, 5, 4}},
        Holding{{some_hash(1), some_hash(2)}},
        Join{3, some_hash(1), "blade-3", "a request"},
        Renew{"another"},
        Certified{"a certificate", "and its authority's"},
        TokenCreate{CertifiedRole::Submitter, 3600, 50},
        TokenCreated{"cdt1"},
        Inventory{{{TreeId{1}, {2, 3}}}, {JobId{4}}, {{TaskId{5}, {7, 9}, 0}, {TaskId{6}, {}, 40}}},
        DropScenario{JobId{8}, 9, TaskId{10}},
        Recall{TaskId{5}, {7, 9}, 3},
        Recalled{TaskId{6}, {7}, 40},
        Hint{JobId{8}, TreeId{2}, {1, 5}},
        ContactMapQuery{JobId{8}, true},
        ContactMapAnswer{JobId{8}, true, "a worker was wrong", some_bytes(12)},
        JobQuery{JobId{8}},
        JobDescription{JobId{8}, 9, some_submit()},
        MeshQuery{some_hash(1), 40},
        MeshBytes{some_hash(1), 100, 40, some_bytes(60)},
        PosesQuery{JobId{8}, 9, 10, 11},
        JobPoses{JobId{8}, 9, 3, some_bytes(20), some_labels()},
        Remove{JobId{8}, true},
        RemoveMesh{some_hash(1)},
        Removed{11},
        DrainWorkers{{WorkerId{1}, WorkerId{3}}, true},
        Draining{{WorkerId{1}, WorkerId{3}}},
        SetPriority{JobId{8}, -3},
    };
}

} // namespace cd::tests
