// The encoded members of each message, in order (PROTOCOL.md). Only the codec includes this.
#pragma once

#include "proto/codec/message.hpp"
#include "proto/codec/wire_archive.hpp"

namespace cd {

template <class Archive, class Tag>
void serialize(Archive& archive, Id<Tag>& id) {
    archive(id.value);
}

template <class Archive>
void serialize(Archive& archive, MotionQuery& motion) {
    archive(motion.resolution);
    enumeration(archive, motion.until, Until::Contact, Until::End);
}

template <class Archive>
void serialize(Archive& archive, Query& query) {
    enumeration(archive, query.level, Level::Any, Level::Contacts);
    archive(query.limit_pairs, query.ignored, query.maps, query.clearance);
    enumeration(archive, query.question, Question::Contacts, Question::Shots);
    archive(query.up_to, query.first_hits, query.motion);
}

template <class Archive>
void serialize(Archive& archive, SearchEffort& e) {
    archive(e.cells, e.leaves, e.roots_named, e.roots_used);
}

template <class Archive>
void serialize(Archive& archive, QueryStatistics& s) {
    archive(s.box_tests, s.triangle_tests, s.decisions.settled, s.effort);
}

template <class Archive>
void serialize(Archive& archive, JobStatistics& s) {
    archive(s.search, s.inside.scenarios, s.inside.seconds);
}

template <class Archive>
void serialize(Archive& archive, Summary& s) {
    archive(s.total, s.separate, s.touch, s.cross, s.inside, s.contact, s.undecided, s.failed);
    archive(s.near, s.pairs, s.near_pairs, s.surfaces_only, s.insides_skipped, s.cut);
}

template <class Archive>
void serialize(Archive& archive, Hello& m) {
    archive(m.version);
    enumeration(archive, m.role, Role::Worker, Role::Joiner);
    archive(m.name);
    if constexpr (Archive::is_input) {
        if (m.version != protocol_version) {
            archive.skip_rest();
            return;
        }
    }
    archive(m.build, m.threads, m.cache_bytes, m.peer_port, m.weight);
    archive(m.instance, m.resumed.id, m.resumed.epoch, m.user, m.boot_id);
}

template <class Archive>
void serialize(Archive& archive, Welcome& m) {
    archive(m.version, m.id, m.build, m.peer_key, m.cluster);
    archive(m.epoch, m.is_resumed, m.heartbeat_ms, m.lost_after_ms, m.owner, m.boot_id);
}

template <class Archive>
void serialize(Archive& archive, Failure& m) {
    enumeration(archive, m.code, ErrorCode::BadInput, ErrorCode::Interrupted);
    archive(m.detail);
}

template <class Archive>
void serialize(Archive& archive, BlockTraffic& t) {
    archive(t.hits, t.misses, t.hinted, t.evictions, t.master_bytes, t.peer_bytes);
}

template <class Archive>
void serialize(Archive& archive, CacheTraffic& t) {
    archive(t.blocks, t.uploaded_bytes);
}

template <class Archive>
void serialize(Archive& archive, JobTraffic& t) {
    archive(t.blocks, t.result_bytes);
}

template <class Archive>
void serialize(Archive& archive, RunningScenario& s) {
    archive(s.job, s.scenario, s.seconds);
}

template <class Archive>
void serialize(Archive& archive, Heartbeat& m) {
    archive(m.sequence, m.cached_bytes, m.waiting, m.traffic, m.longest);
}

template <class Archive>
void serialize(Archive& archive, AddTree& m) {
    archive(m.tree);
    enumeration(archive, m.form, SubtreeForm::Binary, SubtreeForm::Wide);
    archive(m.cut, m.top, m.roots, m.triangles);
}

template <class Archive>
void serialize(Archive& archive, RemoveTree& m) {
    archive(m.tree);
}

template <class Archive>
void serialize(Archive& archive, SubtreeBlock& block) {
    archive(block.root, block.hash, block.compressed);
}

template <class Archive>
void serialize(Archive& archive, Subtrees& m) {
    archive(m.tree, m.blocks);
}

template <class Archive>
void serialize(Archive& archive, WorkUnit& m) {
    archive(
        m.task, m.job, m.first, m.count, m.scenarios, m.pair_offsets, m.pairs, m.results_wait_ms);
}

template <class Archive>
void serialize(Archive& archive, AddJob& m) {
    archive(m.job, m.trees, m.query, m.grid, m.parts, m.radii);
}

template <class Archive>
void serialize(Archive& archive, RemoveJob& m) {
    archive(m.job);
}

template <class Archive>
void serialize(Archive& archive, DropScenario& m) {
    archive(m.job, m.scenario, m.task);
}

template <class Archive>
void serialize(Archive& archive, Recall& m) {
    archive(m.task, m.scenarios, m.kept);
}

template <class Archive>
void serialize(Archive& archive, Recalled& m) {
    archive(m.task, m.scenarios, m.kept);
}

template <class Archive>
void serialize(Archive& archive, Hint& m) {
    archive(m.job, m.tree, m.roots);
}

template <class Archive>
void serialize(Archive& archive, Terminate& m) {
    archive(m.reason);
}

template <class Archive>
void serialize(Archive& archive, WantSubtrees& m) {
    archive(m.tree, m.roots);
}

template <class Archive>
void serialize(Archive& archive, Results& m) {
    archive(m.task, m.job, m.count, m.records, m.are_packed, m.statistics, m.compute_seconds);
    archive(m.sequence, m.traffic, m.map);
}

template <class Archive>
void serialize(Archive& archive, ResultsKept& m) {
    archive(m.sequences);
}

template <class Archive>
void serialize(Archive& archive, Holding& m) {
    archive(m.cuts);
}

template <class Archive>
void serialize(Archive& archive, InventoryTree& t) {
    archive(t.tree, t.held);
}

template <class Archive>
void serialize(Archive& archive, Inventory& m) {
    archive(m.trees, m.jobs, m.tasks);
}

template <class Archive>
void serialize(Archive& archive, EndOfTask& m) {
    archive(m.task);
}

template <class Archive>
void serialize(Archive& archive, Evicted& m) {
    archive(m.tree, m.roots);
}

template <class Archive>
void serialize(Archive& archive, PeerSource& s) {
    archive(s.worker, s.host, s.port, s.ticket, s.proof);
}

template <class Archive>
void serialize(Archive& archive, FetchFromPeers& m) {
    archive(m.tree, m.roots, m.hashes, m.sources);
}

template <class Archive>
void serialize(Archive& archive, Held& m) {
    archive(m.tree, m.roots);
}

template <class Archive>
void serialize(Archive& archive, FetchFailed& m) {
    archive(m.tree, m.roots, m.source);
    enumeration(archive, m.outcome, PeerOutcome::Busy, PeerOutcome::Refused);
}

template <class Archive>
void serialize(Archive& archive, PeerFetch& m) {
    archive(m.tree, m.roots, m.ticket, m.proof);
}

template <class Archive>
void serialize(Archive& archive, PeerFetched& m) {
    archive(m.tree, m.missing);
    enumeration(archive, m.outcome, PeerOutcome::Given, PeerOutcome::Refused);
}

template <class Archive>
void serialize(Archive& archive, MeshesQuery& m) {
    archive(m.meshes);
}

template <class Archive>
void serialize(Archive& archive, MeshesMissing& m) {
    archive(m.meshes);
}

template <class Archive>
void serialize(Archive& archive, MeshPart& m) {
    archive(m.mesh, m.name, m.bytes_total, m.offset, m.bytes);
}

template <class Archive>
void serialize(Archive& archive, MeshStored& m) {
    archive(m.mesh);
}

template <class Archive>
void serialize(Archive& archive, ClusterOptions& o) {
    archive(o.strategy, o.depths, o.q, o.v_kb, o.claim, o.seed);
    enumeration(archive, o.analysis, AnalysisMode::Auto, AnalysisMode::Never);
    archive(o.hints);
}

template <class Archive>
void serialize(Archive& archive, JobBody& b) {
    archive(b.mesh, b.name, b.file, b.unit, b.is_unit_given, b.up, b.rounds_to_float, b.is_fixed);
    archive(b.origin);
}

template <class Archive>
void serialize(Archive& archive, RandomPoses& r) {
    archive(r.count, r.seed, r.penetration_min, r.penetration_max);
}

template <class Archive>
void serialize(Archive& archive, LabelColumns& c) {
    enumeration(archive, c.ids, IdKind::None, IdKind::Text);
    archive(c.has_times, c.has_end_times);
}

template <class Archive>
void serialize(Archive& archive, PoseLabels& l) {
    archive(l.integers, l.texts, l.times, l.end_times);
}

template <class Archive>
void serialize(Archive& archive, GridAxis& a) {
    archive(a.first, a.last, a.count);
}

template <class Archive>
void serialize(Archive& archive, ShotsOrigin& o) {
    archive(o.spacing, o.tile, o.offset, o.jitter_seed, o.are_rays);
}

template <class Archive>
void serialize(Archive& archive, SceneOrigin& s) {
    archive(s.head, s.job, s.steps);
}

template <class Archive>
void serialize(Archive& archive, PathOrigin& o) {
    archive(o.max_step, o.chord, o.clearance);
}

template <class Archive>
void serialize(Archive& archive, PosesOrigin& o) {
    enumeration(archive, o.kind, PosesKind::Grid, PosesKind::Curve);
    archive(o.random, o.file, o.quat_order, o.of_both_bodies, o.rigid_tolerance, o.labels);
    archive(o.unit, o.axes, o.shots, o.scene, o.path);
}

template <class Archive>
void serialize(Archive& archive, IgnoreLine& l) {
    archive(l.a, l.b);
}

template <class Archive>
void serialize(Archive& archive, Submit& m) {
    archive(m.name, m.unit, m.owner, m.priority, m.bodies, m.query, m.cluster, m.poses);
    archive(m.scenarios, m.grid, m.retention_seconds, m.ignore);
}

template <class Archive>
void serialize(Archive& archive, PosesPart& m) {
    archive(m.scenarios, m.labels);
}

template <class Archive>
void serialize(Archive& archive, JobQuery& m) {
    archive(m.job);
}

template <class Archive>
void serialize(Archive& archive, JobDescription& m) {
    archive(m.job, m.began, m.submit);
}

template <class Archive>
void serialize(Archive& archive, MeshQuery& m) {
    archive(m.mesh, m.offset);
}

template <class Archive>
void serialize(Archive& archive, MeshBytes& m) {
    archive(m.mesh, m.bytes_total, m.offset, m.bytes);
}

template <class Archive>
void serialize(Archive& archive, PosesQuery& m) {
    archive(m.job, m.first, m.count, m.sample);
}

template <class Archive>
void serialize(Archive& archive, JobPoses& m) {
    archive(m.job, m.first, m.count, m.scenarios, m.labels);
}

template <class Archive>
void serialize(Archive& archive, Remove& m) {
    archive(m.job, m.cancel);
}

template <class Archive>
void serialize(Archive& archive, RemoveMesh& m) {
    archive(m.mesh);
}

template <class Archive>
void serialize(Archive& archive, Removed& m) {
    archive(m.bytes);
}

template <class Archive>
void serialize(Archive& archive, DrainWorkers& m) {
    archive(m.workers, m.now);
}

template <class Archive>
void serialize(Archive& archive, Draining& m) {
    archive(m.workers);
}

template <class Archive>
void serialize(Archive& archive, Accepted& m) {
    archive(m.job);
}

template <class Archive>
void serialize(Archive& archive, LongScenario& s) {
    archive(s.scenario, s.worker, s.name, s.seconds);
}

template <class Archive>
void serialize(Archive& archive, JobTurn& t) {
    archive(t.owner, t.priority, t.share);
}

template <class Archive>
void serialize(Archive& archive, JobStatus& m) {
    archive(m.job, m.name);
    enumeration(archive, m.state, JobState::Running, JobState::Failed);
    archive(m.summary, m.digest, m.seconds, m.scenarios_per_second, m.failure, m.bodies);
    archive(m.answered_by_master, m.statistics, m.compute_seconds, m.paused);
    archive(m.long_scenarios, m.withdrawn, m.recalled, m.copies, m.copies_won);
    archive(m.traffic, m.depths, m.turn, m.began);
}

template <class Archive>
void serialize(Archive& archive, Watch& m) {
    archive(m.job);
}

template <class Archive>
void serialize(Archive& archive, WorkerStatus& s) {
    archive(s.worker, s.name, s.threads, s.cache_bytes, s.cached_bytes, s.claimed, s.draining);
    archive(s.buffered, s.working, s.tasks, s.scenarios, s.scenarios_per_second);
    archive(s.bytes_sent, s.bytes_received, s.subtrees_sent, s.subtree_bytes_sent, s.cache);
    archive(s.quarantined);
    enumeration(archive, s.state, WorkerState::Alive, WorkerState::Lost);
    archive(s.silent_seconds, s.longest);
}

template <class Archive>
void serialize(Archive& archive, MeshStatus& s) {
    archive(s.mesh, s.name, s.triangles, s.bytes, s.build_seconds, s.is_needed);
}

template <class Archive>
void serialize(Archive& archive, StateSizes& s) {
    archive(s.results, s.poses, s.meshes, s.trees, s.journal, s.free);
}

template <class Archive>
void serialize(Archive& archive, GrowthPoint& p) {
    archive(p.workers, p.seconds);
}

template <class Archive>
void serialize(Archive& archive, Growth& g) {
    archive(g.seconds, g.more, g.worth);
}

template <class Archive>
void serialize(Archive& archive, LossCounts& c) {
    archive(c.workers_lost, c.sessions_resumed, c.scenarios_given_back);
}

template <class Archive>
void serialize(Archive& archive, ClusterStatus& m) {
    archive(m.build, m.uptime_seconds, m.cpu_seconds, m.workers, m.jobs, m.meshes);
    archive(m.alarms, m.alarm_count, m.losses, m.sizes, m.growth);
}

template <class Archive>
void serialize(Archive& archive, ResultsQuery& m) {
    archive(m.job, m.first, m.count, m.sample);
}

template <class Archive>
void serialize(Archive& archive, ScenarioInterval& r) {
    archive(r.first, r.count);
}

template <class Archive>
void serialize(Archive& archive, ResultsPart& m) {
    archive(m.job, m.first, m.next, m.held, m.count, m.records, m.are_packed);
}

template <class Archive>
void serialize(Archive& archive, ContactMapQuery& m) {
    archive(m.job, m.only_parts);
}

template <class Archive>
void serialize(Archive& archive, ContactMapAnswer& m) {
    archive(m.job, m.is_asked, m.withdrawn, m.map);
}

template <class Archive>
void serialize(Archive& archive, Cancel& m) {
    archive(m.job, m.scenario);
}

template <class Archive>
void serialize(Archive& archive, SetPriority& m) {
    archive(m.job, m.priority);
}

template <class Archive>
void serialize(Archive& archive, Explain& m) {
    archive(m.job, m.scenario);
}

template <class Archive>
void serialize(Archive& archive, WorkerScore& s) {
    archive(s.worker, s.name, s.may_take, s.is_chosen, s.scenarios, s.load);
    archive(s.held_triangles, s.missing_triangles);
    archive(s.backlog, s.coming, s.transfer, s.blocks, s.eviction, s.work);
}

template <class Archive>
void serialize(Archive& archive, Explained& m) {
    archive(m.job, m.scenario, m.strategy, m.is_by_time);
    archive(m.where, m.why, m.note, m.roots_a, m.roots_b, m.workers, m.effort);
}

template <class Archive>
void serialize(Archive& archive, Join& m) {
    archive(m.token, m.proof, m.name, m.request);
}

template <class Archive>
void serialize(Archive& archive, Renew& m) {
    archive(m.request);
}

template <class Archive>
void serialize(Archive& archive, Certified& m) {
    archive(m.certificate, m.authority);
}

template <class Archive>
void serialize(Archive& archive, TokenCreate& m) {
    enumeration(archive, m.role, CertifiedRole::Worker, CertifiedRole::Metrics);
    archive(m.seconds, m.uses);
}

template <class Archive>
void serialize(Archive& archive, TokenCreated& m) {
    archive(m.token);
}

} // namespace cd
