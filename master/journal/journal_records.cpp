#include "master/journal/journal_records.hpp"

#include "common/core/files/disk_file.hpp"
#include "master/journal/row_bytes.hpp"

namespace cd {

namespace {

template <class T>
void put_optional(ByteWriter& out, const std::optional<T>& value) {
    out.put(value.has_value());
    if (value) {
        out.put(*value);
    }
}

template <class T>
std::optional<T> get_optional(ByteReader& in) {
    return in.get<std::uint8_t>() != 0 ? std::optional(in.get<T>()) : std::nullopt;
}

void put_query(ByteWriter& out, const Query& query) {
    put_enumeration(out, query.level);
    out.put(query.limit_pairs);
    out.put(std::uint64_t{query.ignored.size()});
    for (const IgnoredRange& range : query.ignored) {
        for (const std::uint32_t value :
             {range.a_begin, range.a_end, range.b_begin, range.b_end, range.body_a, range.body_b}) {
            out.put(value);
        }
    }
    out.put(query.maps);
    put_optional(out, query.clearance);
    put_enumeration(out, query.question);
    put_optional(out, query.up_to);
    out.put(query.first_hits);
    out.put(std::uint8_t{query.motion ? std::uint8_t{1} : std::uint8_t{0}});
    if (query.motion) {
        out.put(query.motion->resolution);
        put_enumeration(out, query.motion->until);
    }
}

bool get_query(ByteReader& in, Query& query) {
    const bool is_level = get_enumeration(in, query.level, Level::Contacts);
    query.limit_pairs = in.get<std::uint64_t>();
    const auto count = in.get<std::uint64_t>();
    if (!is_level || !may_hold(in, count, 6 * sizeof(std::uint32_t))) {
        return false;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        IgnoredRange range;
        for (std::uint32_t* value : {&range.a_begin,
                                     &range.a_end,
                                     &range.b_begin,
                                     &range.b_end,
                                     &range.body_a,
                                     &range.body_b}) {
            *value = in.get<std::uint32_t>();
        }
        query.ignored.push_back(range);
    }
    query.maps = in.get<std::uint8_t>() != 0;
    query.clearance = get_optional<double>(in);
    const bool is_question = get_enumeration(in, query.question, Question::Shots);
    query.up_to = get_optional<double>(in);
    query.first_hits = in.get<std::uint8_t>() != 0;
    bool is_motion = true;
    if (in.get<std::uint8_t>() != 0) {
        MotionQuery& motion = query.motion.emplace();
        motion.resolution = in.get<double>();
        is_motion = get_enumeration(in, motion.until, Until::End);
    }
    return is_question && is_motion && query_problem(query) == nullptr;
}

void put_cluster(ByteWriter& out, const ClusterOptions& cluster) {
    out.put_text(cluster.strategy);
    out.put(std::uint64_t{cluster.depths.size()});
    for (const auto& depth : cluster.depths) {
        put_optional(out, depth);
    }
    out.put(cluster.q);
    out.put(cluster.v_kb);
    out.put(cluster.claim);
    out.put(cluster.seed);
    put_enumeration(out, cluster.analysis);
    out.put(cluster.hints);
}

bool get_cluster(ByteReader& in, ClusterOptions& cluster) {
    cluster.strategy = in.get_text();
    const auto depths = in.get<std::uint64_t>();
    if (!is_strategy_name(cluster.strategy) || !may_hold(in, depths, 1)) {
        return false;
    }
    for (std::uint64_t body = 0; body < depths; ++body) {
        cluster.depths.push_back(get_optional<std::uint32_t>(in));
    }
    cluster.q = in.get<std::uint32_t>();
    cluster.v_kb = in.get<std::uint32_t>();
    cluster.claim = in.get<std::uint8_t>() != 0;
    cluster.seed = in.get<std::uint64_t>();
    const bool is_mode = get_enumeration(in, cluster.analysis, AnalysisMode::Never);
    cluster.hints = in.get<std::uint8_t>() != 0;
    return is_mode;
}

void put_statistics(ByteWriter& out, const JobStatistics& statistics) {
    out.put(statistics.search.box_tests);
    out.put(statistics.search.triangle_tests);
    for (const std::uint64_t settled : statistics.search.decisions.settled) {
        out.put(settled);
    }
    const SearchEffort& effort = statistics.search.effort;
    for (const std::uint64_t value :
         {effort.cells, effort.leaves, effort.roots_named, effort.roots_used}) {
        out.put(value);
    }
    out.put(statistics.inside.scenarios);
    out.put(statistics.inside.seconds);
}

JobStatistics get_statistics(ByteReader& in) {
    JobStatistics statistics;
    statistics.search.box_tests = in.get<std::uint64_t>();
    statistics.search.triangle_tests = in.get<std::uint64_t>();
    for (auto& settled : statistics.search.decisions.settled) {
        settled = in.get<std::uint64_t>();
    }
    SearchEffort& effort = statistics.search.effort;
    for (std::uint64_t* value :
         {&effort.cells, &effort.leaves, &effort.roots_named, &effort.roots_used}) {
        *value = in.get<std::uint64_t>();
    }
    statistics.inside.scenarios = in.get<std::uint64_t>();
    statistics.inside.seconds = in.get<double>();
    return statistics;
}

void put_traffic(ByteWriter& out, const JobTraffic& traffic) {
    const BlockTraffic& blocks = traffic.blocks;
    for (const std::uint64_t value : {blocks.hits,
                                      blocks.misses,
                                      blocks.hinted,
                                      blocks.evictions,
                                      blocks.master_bytes,
                                      blocks.peer_bytes,
                                      traffic.result_bytes}) {
        out.put(value);
    }
}

JobTraffic get_traffic(ByteReader& in) {
    JobTraffic traffic;
    BlockTraffic& blocks = traffic.blocks;
    for (std::uint64_t* value : {&blocks.hits,
                                 &blocks.misses,
                                 &blocks.hinted,
                                 &blocks.evictions,
                                 &blocks.master_bytes,
                                 &blocks.peer_bytes,
                                 &traffic.result_bytes}) {
        *value = in.get<std::uint64_t>();
    }
    return traffic;
}

void put_help(ByteWriter& out, const HelpAtEnd& help) {
    out.put(help.recalled);
    out.put(help.copies);
    out.put(help.copies_won);
}

HelpAtEnd get_help(ByteReader& in) {
    HelpAtEnd help;
    help.recalled = in.get<std::uint64_t>();
    help.copies = in.get<std::uint64_t>();
    help.copies_won = in.get<std::uint64_t>();
    return help;
}

void put_body(ByteWriter& out, const JobBody& body) {
    put_hash(out, body.mesh);
    out.put_text(body.name);
    out.put_text(body.file);
    out.put_text(body.unit);
    out.put(body.is_unit_given);
    out.put_text(body.up);
    out.put(body.rounds_to_float);
    out.put(body.is_fixed);
    for (const double coordinate : body.origin) {
        out.put(coordinate);
    }
}

JobBody get_body(ByteReader& in) {
    JobBody body;
    body.mesh = get_hash(in);
    body.name = in.get_text();
    body.file = in.get_text();
    body.unit = in.get_text();
    body.is_unit_given = in.get<std::uint8_t>() != 0;
    body.up = in.get_text();
    body.rounds_to_float = in.get<std::uint8_t>() != 0;
    body.is_fixed = in.get<std::uint8_t>() != 0;
    for (double& coordinate : body.origin) {
        coordinate = in.get<double>();
    }
    return body;
}

void put_scene(ByteWriter& out, const std::optional<SceneOrigin>& scene) {
    out.put(scene.has_value());
    if (scene) {
        put_hash(out, scene->head);
        out.put_text(scene->job);
        out.put(std::uint64_t{scene->steps.size()});
        put_bytes(out, scene->steps);
    }
}

std::optional<SceneOrigin> get_scene(ByteReader& in) {
    if (in.get<std::uint8_t>() == 0) {
        return std::nullopt;
    }
    SceneOrigin scene;
    scene.head = get_hash(in);
    scene.job = in.get_text();
    const auto steps = in.get_bytes(in.get<std::uint64_t>());
    scene.steps.assign(steps.begin(), steps.end());
    return scene;
}

void put_shots(ByteWriter& out, const ShotsOrigin& shots) {
    out.put(shots.spacing);
    out.put(shots.tile);
    out.put(shots.offset[0]);
    out.put(shots.offset[1]);
    put_optional(out, shots.jitter_seed);
    out.put(shots.are_rays);
}

ShotsOrigin get_shots(ByteReader& in) {
    ShotsOrigin shots;
    shots.spacing = in.get<double>();
    shots.tile = in.get<std::uint32_t>();
    shots.offset[0] = in.get<double>();
    shots.offset[1] = in.get<double>();
    shots.jitter_seed = get_optional<std::uint64_t>(in);
    shots.are_rays = in.get<std::uint8_t>() != 0;
    return shots;
}

void put_path(ByteWriter& out, const std::optional<PathOrigin>& given) {
    out.put(given.has_value());
    const PathOrigin path = given.value_or(PathOrigin{});
    put_optional(out, path.max_step);
    put_optional(out, path.chord);
    put_optional(out, path.clearance);
}

std::optional<PathOrigin> get_path(ByteReader& in) {
    const bool is_path = in.get<std::uint8_t>() != 0;
    PathOrigin path;
    path.max_step = get_optional<double>(in);
    path.chord = get_optional<double>(in);
    path.clearance = get_optional<double>(in);
    return is_path ? std::optional(path) : std::nullopt;
}

void put_origin(ByteWriter& out, const PosesOrigin& origin) {
    put_enumeration(out, origin.kind);
    out.put(origin.random.has_value());
    const RandomPoses random = origin.random.value_or(RandomPoses{});
    out.put(random.count);
    out.put(random.seed);
    out.put(random.penetration_min);
    out.put(random.penetration_max);
    out.put_text(origin.file);
    out.put_text(origin.quat_order);
    out.put(origin.of_both_bodies);
    put_optional(out, origin.rigid_tolerance);
    put_enumeration(out, origin.labels.ids);
    out.put(origin.labels.has_times);
    out.put(origin.labels.has_end_times);
    out.put_text(origin.unit);
    out.put(std::uint64_t{origin.axes.size()});
    for (const GridAxis& axis : origin.axes) {
        out.put(axis.first);
        out.put(axis.last);
        out.put(axis.count);
    }
    out.put(origin.shots.has_value());
    put_shots(out, origin.shots.value_or(ShotsOrigin{}));
    put_scene(out, origin.scene);
    put_path(out, origin.path);
}

bool get_origin(ByteReader& in, PosesOrigin& origin) {
    const bool is_kind = get_enumeration(in, origin.kind, PosesKind::Curve);
    const bool is_random = in.get<std::uint8_t>() != 0;
    RandomPoses random;
    random.count = in.get<std::uint64_t>();
    random.seed = in.get<std::uint64_t>();
    random.penetration_min = in.get<double>();
    random.penetration_max = in.get<double>();
    if (is_random) {
        origin.random = random;
    }
    origin.file = in.get_text();
    origin.quat_order = in.get_text();
    origin.of_both_bodies = in.get<std::uint8_t>() != 0;
    origin.rigid_tolerance = get_optional<double>(in);
    const bool are_ids = get_enumeration(in, origin.labels.ids, IdKind::Text);
    origin.labels.has_times = in.get<std::uint8_t>() != 0;
    origin.labels.has_end_times = in.get<std::uint8_t>() != 0;
    origin.unit = in.get_text();
    const auto axes = in.get<std::uint64_t>();
    if (!may_hold(in, axes, sizeof(GridAxis))) {
        return false;
    }
    for (std::uint64_t i = 0; i < axes; ++i) {
        GridAxis axis;
        axis.first = in.get<double>();
        axis.last = in.get<double>();
        axis.count = in.get<std::uint64_t>();
        origin.axes.push_back(axis);
    }
    const bool is_shots = in.get<std::uint8_t>() != 0;
    const ShotsOrigin shots = get_shots(in);
    if (is_shots) {
        origin.shots = shots;
    }
    origin.scene = get_scene(in);
    origin.path = get_path(in);
    return is_kind && are_ids;
}

} // namespace

Bytes encode_job(const JobRecord& job) {
    const Submit& submit = job.submit;
    ByteWriter out;
    out.put(job.id.value);
    out.put(job.began);
    out.put_text(submit.name);
    out.put_text(submit.unit);
    out.put_text(submit.owner);
    out.put(submit.priority);
    out.put(std::uint64_t{submit.bodies.size()});
    for (const JobBody& body : submit.bodies) {
        put_body(out, body);
    }
    put_query(out, submit.query);
    put_cluster(out, submit.cluster);
    put_origin(out, submit.poses);
    out.put(submit.scenarios);
    out.put(submit.retention_seconds);
    out.put(submit.grid.has_value());
    if (submit.grid) {
        out.put(std::uint64_t{submit.grid->size()});
        put_bytes(out, *submit.grid);
    }
    out.put(std::uint64_t{submit.ignore.size()});
    for (const IgnoreLine& line : submit.ignore) {
        out.put_text(line.a);
        out.put_text(line.b);
    }
    return out.take();
}

Result<JobRecord> decode_job(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    JobRecord job;
    job.id = JobId{in.get<std::uint64_t>()};
    job.began = in.get<std::uint64_t>();
    job.submit.name = in.get_text();
    job.submit.unit = in.get_text();
    job.submit.owner = in.get_text();
    job.submit.priority = in.get<std::int32_t>();
    const auto bodies = in.get<std::uint64_t>();
    if (!may_hold(in, bodies, sizeof(Sha256))) {
        return damaged_row("a job");
    }
    for (std::uint64_t i = 0; i < bodies; ++i) {
        job.submit.bodies.push_back(get_body(in));
    }
    if (!get_query(in, job.submit.query) || !get_cluster(in, job.submit.cluster) ||
        !get_origin(in, job.submit.poses)) {
        return damaged_row("a job");
    }
    job.submit.scenarios = in.get<std::uint64_t>();
    job.submit.retention_seconds = in.get<std::uint64_t>();
    if (in.get<std::uint8_t>() != 0) {
        const auto grid = in.get_bytes(in.get<std::uint64_t>());
        job.submit.grid.emplace(grid.begin(), grid.end());
    }
    const auto lines = in.get<std::uint64_t>();
    if (!may_hold(in, lines, 2)) {
        return damaged_row("a job");
    }
    for (std::uint64_t i = 0; i < lines; ++i) {
        std::string a = in.get_text();
        job.submit.ignore.push_back({std::move(a), in.get_text()});
    }
    if (!in.complete()) {
        return damaged_row("a job");
    }
    return job;
}

Bytes encode_progress(const JobProgress& progress) {
    ByteWriter out;
    out.put(progress.seconds);
    out.put(progress.answered_by_master);
    put_statistics(out, progress.statistics);
    out.put(progress.compute_seconds);
    put_traffic(out, progress.traffic);
    put_help(out, progress.help);
    out.put(std::uint64_t{progress.depths.size()});
    out.put_array(std::span<const std::uint32_t>(progress.depths));
    out.put_text(progress.map_withdrawn);
    return out.take();
}

Result<JobProgress> decode_progress(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    JobProgress progress;
    progress.seconds = in.get<double>();
    progress.answered_by_master = in.get<std::uint64_t>();
    progress.statistics = get_statistics(in);
    progress.compute_seconds = in.get<double>();
    progress.traffic = get_traffic(in);
    progress.help = get_help(in);
    const auto depths = in.get<std::uint64_t>();
    if (!may_hold(in, depths, sizeof(std::uint32_t))) {
        return damaged_row("a job's progress");
    }
    for (std::uint64_t body = 0; body < depths; ++body) {
        progress.depths.push_back(in.get<std::uint32_t>());
    }
    progress.map_withdrawn = in.get_text();
    if (!in.complete()) {
        return damaged_row("a job's progress");
    }
    return progress;
}

Bytes encode_end(const JobEnd& end) {
    ByteWriter out;
    put_enumeration(out, end.state);
    out.put_text(end.failure);
    out.put(end.digest.has_value());
    if (end.digest) {
        put_hash(out, *end.digest);
    }
    out.put(end.ended);
    return out.take();
}

Result<JobEnd> decode_end(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    JobEnd end;
    const bool is_state = get_enumeration(in, end.state, JobState::Failed);
    end.failure = in.get_text();
    if (in.get<std::uint8_t>() != 0) {
        end.digest = get_hash(in);
    }
    end.ended = in.get<std::uint64_t>();
    if (!is_state || !in.complete()) {
        return damaged_row("the end of a job");
    }
    return end;
}

} // namespace cd
