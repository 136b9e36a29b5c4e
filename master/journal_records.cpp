#include "master/journal_records.hpp"

#include "common/core/disk_file.hpp"
#include "master/row_bytes.hpp"

namespace cd {

namespace {

void put_query(ByteWriter& out, const Query& query) {
    put_enumeration(out, query.level);
    out.put(query.tolerance);
    out.put(query.limit_pairs);
    out.put(std::uint64_t{query.ignored.size()});
    for (const IgnoredRange& range : query.ignored) {
        for (const std::uint32_t value : {range.a_begin, range.a_end, range.b_begin, range.b_end}) {
            out.put(value);
        }
    }
    out.put(query.maps);
}

bool get_query(ByteReader& in, Query& query) {
    const bool is_level = get_enumeration(in, query.level, Level::Contacts);
    query.tolerance = in.get<double>();
    query.limit_pairs = in.get<std::uint64_t>();
    const auto count = in.get<std::uint64_t>();
    if (!is_level || !may_hold(in, count, 4 * sizeof(std::uint32_t))) {
        return false;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        IgnoredRange range;
        for (std::uint32_t* value : {&range.a_begin, &range.a_end, &range.b_begin, &range.b_end}) {
            *value = in.get<std::uint32_t>();
        }
        query.ignored.push_back(range);
    }
    query.maps = in.get<std::uint8_t>() != 0;
    return true;
}

void put_depth(ByteWriter& out, const std::optional<std::uint32_t>& depth) {
    out.put(depth.has_value());
    out.put(depth.value_or(0));
}

std::optional<std::uint32_t> get_depth(ByteReader& in) {
    const bool is_there = in.get<std::uint8_t>() != 0;
    const auto depth = in.get<std::uint32_t>();
    return is_there ? std::optional(depth) : std::nullopt;
}

void put_cluster(ByteWriter& out, const ClusterOptions& cluster) {
    put_enumeration(out, cluster.strategy);
    put_depth(out, cluster.depth_a);
    put_depth(out, cluster.depth_b);
    out.put(cluster.q);
    out.put(cluster.v_kb);
    out.put(cluster.claim);
    out.put(cluster.seed);
    put_enumeration(out, cluster.analysis);
    out.put(cluster.hints);
}

bool get_cluster(ByteReader& in, ClusterOptions& cluster) {
    const bool is_strategy = get_enumeration(in, cluster.strategy, Strategy::EarliestFinish);
    cluster.depth_a = get_depth(in);
    cluster.depth_b = get_depth(in);
    cluster.q = in.get<std::uint32_t>();
    cluster.v_kb = in.get<std::uint32_t>();
    cluster.claim = in.get<std::uint8_t>() != 0;
    cluster.seed = in.get<std::uint64_t>();
    const bool is_mode = get_enumeration(in, cluster.analysis, AnalysisMode::Never);
    cluster.hints = in.get<std::uint8_t>() != 0;
    return is_strategy && is_mode;
}

void put_statistics(ByteWriter& out, const JobStatistics& statistics) {
    out.put(statistics.search.box_tests);
    out.put(statistics.search.triangle_tests);
    for (const std::uint64_t settled : statistics.search.decisions.settled) {
        out.put(settled);
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

} // namespace

Bytes encode_job(const JobRecord& job) {
    const Submit& submit = job.submit;
    ByteWriter out;
    out.put(job.id.value);
    out.put_text(submit.name);
    out.put(std::uint64_t{submit.bodies.size()});
    for (const Sha256& body : submit.bodies) {
        put_hash(out, body);
    }
    put_query(out, submit.query);
    put_cluster(out, submit.cluster);
    out.put(submit.scenarios);
    out.put(submit.grid.has_value());
    if (submit.grid) {
        out.put(std::uint64_t{submit.grid->size()});
        put_bytes(out, *submit.grid);
    }
    return out.take();
}

Result<JobRecord> decode_job(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    JobRecord job;
    job.id = JobId{in.get<std::uint64_t>()};
    job.submit.name = in.get_text();
    const auto bodies = in.get<std::uint64_t>();
    if (!may_hold(in, bodies, sizeof(Sha256))) {
        return damaged_row("a job");
    }
    for (std::uint64_t i = 0; i < bodies; ++i) {
        job.submit.bodies.push_back(get_hash(in));
    }
    if (!get_query(in, job.submit.query) || !get_cluster(in, job.submit.cluster)) {
        return damaged_row("a job");
    }
    job.submit.scenarios = in.get<std::uint64_t>();
    if (in.get<std::uint8_t>() != 0) {
        const auto grid = in.get_bytes(in.get<std::uint64_t>());
        job.submit.grid.emplace(grid.begin(), grid.end());
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
    put_depth(out, progress.depth_a);
    put_depth(out, progress.depth_b);
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
    progress.depth_a = get_depth(in);
    progress.depth_b = get_depth(in);
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
    if (!is_state || !in.complete()) {
        return damaged_row("the end of a job");
    }
    return end;
}

} // namespace cd
