#include "client/export/result_writer.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/result/drawn_witness.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

namespace cd {

namespace {

using Json = nlohmann::ordered_json; // Keys in the order in which they are written here.

Json points_of(const ScenarioResult& result, std::size_t pair) {
    Json points = Json::array();
    for_each_point(result, pair, [&](const Vec3& point) {
        points.push_back({point.x(), point.y(), point.z()});
    });
    return points;
}

/// Adds the distance, null if there is none, and the nearest points.
void add_nearest(const std::optional<NearestWitness>& nearest, Json& line) {
    line["distance"] = nearest ? Json(nearest->distance) : Json();
    if (!nearest) {
        return;
    }
    line["witness"] = {nearest->a, nearest->b};
    line["feature"] = nearest->feature;
    Json points = Json::array();
    for (const Vec3& point : witness_points(*nearest)) {
        points.push_back({point.x(), point.y(), point.z()});
    }
    line["witness_points"] = std::move(points);
}

/// Returns depth, flags and rank of each hit.
Json hits_json(const std::vector<PairHit>& hits) {
    Json json = Json::array();
    for (const PairHit& hit : hits) {
        json.push_back({hit.depth, hit.flags, hit.rank});
    }
    return json;
}

class JsonWriter final : public ResultWriter {
  public:
    JsonWriter(const ExportContext& context, OutputFile file)
        : context_(context), file_(std::move(file)) {}

    Status add(const ScenarioResult& result) override {
        Json line{{"index", result.index},
                  {"body_a", context_.bodies[result.body_a].name},
                  {"body_b", context_.bodies[result.body_b].name},
                  {"class", to_text(result.kind)}};
        if (context_.steps) {
            const std::uint64_t step = context_.steps->step_of(result.index);
            line["step"] = step;
            line["time"] = context_.steps->time_of(step);
            if (const auto bundle = context_.bundle_of(result)) {
                line["bundle"] = *bundle;
                line["bundle_id"] = context_.bodies.back().views->id_of(*bundle);
            }
        }
        if (result.level != Level::Any) {
            line["count"] = result.pair_count;
        }
        if (context_.clearance && result.level != Level::Any) {
            line["near_count"] = result.near_count;
        }
        if (context_.has_distance()) {
            add_nearest(result.nearest, line);
        }
        if (context_.has_motions()) {
            line["motion"] = motion_json(result);
        }
        line["surfaces_only"] = result.surfaces_only;
        line["insides_skipped"] = result.insides_skipped;
        if (result.kind == ScenarioClass::Undecided) {
            // An unknown distance is infinite, which JSON writes as null.
            line["distance_bound"] = result.distance_bound;
        }
        if (!result.failure.empty()) {
            line["failure"] = result.failure;
        }
        if (result.level >= Level::Pairs) {
            line["cut"] = result.is_cut();
            add_pairs(result, line);
        }
        return file_.write(json_text(line, -1));
    }

    Status finish() override { return file_.commit(); }

  private:
    /// Returns what is proven of a motion; null if it failed.
    [[nodiscard]] Json motion_json(const ScenarioResult& result) const {
        if (!result.motion) {
            return {};
        }
        const auto times = context_.times.bracket(result);
        Json runs = Json::array();
        for (const CellRun& run : result.motion->runs) {
            Json row{{"state", run.state == CellState::Free ? "free" : "open"},
                     {"from", context_.times.at(result, run.first)},
                     {"to", context_.times.at(result, run.end())}};
            if (run.has_event()) {
                row["event"] = {context_.times.at(result, run.event_first),
                                context_.times.at(result, run.event_last)};
            }
            runs.push_back(std::move(row));
        }
        return {{"end", to_text(result.motion->end)},
                {"t0", times ? Json(times->first) : Json()},
                {"t1", times ? Json(times->second) : Json()},
                {"runs", std::move(runs)}};
    }

    static void add_pairs(const ScenarioResult& result, Json& line) {
        Json pairs = Json::array();
        Json points = Json::array();
        for (std::size_t i = 0; i < result.pairs.size(); ++i) {
            const ContactPair& pair = result.pairs[i];
            pairs.push_back({pair.a, pair.b, pair_class_name(pair.kind)});
            points.push_back(points_of(result, i));
        }
        line["pairs"] = std::move(pairs);
        if (result.question == Question::Shots) {
            line["hits"] = hits_json(result.hits);
        }
        if (result.level == Level::Contacts) {
            line["points"] = std::move(points);
        }
        if (result.level == Level::Contacts && result.has_clearance) {
            line["distances"] = pair_distances(result);
        }
    }

    ExportContext context_;
    OutputFile file_;
};

/// Returns statistics of the searches: the paper's numbers N_b of box tests and N_p of triangle
/// tests, and the cost N_b C_b + N_p C_p if the times C_b and C_p of one test are known.
Json statistics_json(const RunReport& report) {
    const JobStatistics& statistics = report.execution.statistics;
    Json settled;
    for (std::size_t i = 0; i < pair_stage_count; ++i) {
        const auto stage = static_cast<PairStage>(i);
        settled[std::string(to_text(stage))] = statistics.search.decisions[stage];
    }
    const std::optional<SearchCost>& cost = report.execution.cost;
    const SearchEffort& effort = statistics.search.effort;
    return {{"box_tests", statistics.search.box_tests},
            {"candidates", statistics.search.triangle_tests},
            {"box_test_ns", cost ? Json(cost->box_test_ns) : Json()},
            {"candidate_ns", cost ? Json(cost->triangle_test_ns) : Json()},
            {"cost_seconds", cost ? Json(cost->seconds_of(statistics.search)) : Json()},
            {"settled", std::move(settled)},
            {"cells", effort.cells},
            {"leaves", effort.leaves},
            {"roots_named", effort.roots_named},
            {"roots_used", effort.roots_used},
            {"inside_scenarios", statistics.inside.scenarios},
            {"inside_seconds", statistics.inside.seconds}};
}

Json traffic_json(const JobTraffic& traffic) {
    const BlockTraffic& blocks = traffic.blocks;
    return {{"master_bytes", blocks.master_bytes},
            {"peer_bytes", blocks.peer_bytes},
            {"cache_hits", blocks.hits},
            {"cache_misses", blocks.misses},
            {"hinted", blocks.hinted},
            {"evictions", blocks.evictions},
            {"result_bytes", traffic.result_bytes}};
}

/// Adds the question, and the scenario of least distance, both null if there is none.
void add_least(const ExportContext& context, const RunReport& report, Json& json) {
    const std::optional<LeastDistance>& least = report.findings.least;
    json["question"] = "distance";
    json["up_to"] = context.up_to ? Json(*context.up_to) : Json();
    json["least_distance"] = least ? Json(least->distance) : Json();
    json["least_scenario"] = least ? Json(least->scenario) : Json();
}

/// Adds the question, and what lines tell of each part that they cross.
void add_shots(const RunReport& report, Json& json) {
    Json parts = Json::array();
    for (const ShotPart& part : report.findings.shots) {
        Json row{{"part", part.name},
                 {"closed", part.is_closed},
                 {"lines", part.lines},
                 {"crossings", part.crossings}};
        row["seen_area"] = part.area ? Json(*part.area) : Json();
        row["mean_thickness"] = part.thickness ? Json((*part.thickness)[0]) : Json();
        row["largest_thickness"] = part.thickness ? Json((*part.thickness)[1]) : Json();
        parts.push_back(std::move(row));
    }
    json["question"] = "shots";
    json["parts_hit"] = std::move(parts);
}

Json body_json(const ExportBody& body) {
    const Mesh& mesh = *body.mesh;
    const Vec3 size = bounding_box(mesh.vertices()).size();
    return {{"name", body.name},
            {"file", body.file},
            {"triangles", mesh.triangles().size()},
            {"parts", mesh.parts().size()},
            {"precision", mesh.precision() == Precision::Float ? "float" : "double"},
            {"rounded", body.is_rounded},
            {"size", {size.x(), size.y(), size.z()}},
            {"sha256", to_hex(mesh.hash())}};
}

} // namespace

std::unique_ptr<ResultWriter> make_json_writer(const ExportContext& context, OutputFile file) {
    return std::make_unique<JsonWriter>(context, std::move(file));
}

Status write_summary(const std::filesystem::path& dir,
                     const ExportContext& context,
                     const RunReport& report) {
    const Summary& summary = report.summary;
    Json bodies = Json::array();
    for (const ExportBody& body : context.bodies) {
        bodies.push_back(body_json(body));
    }
    Json json{{"job", context.job},
              {"unit", context.unit},
              {"level", to_text(context.level)},
              {"bodies", std::move(bodies)},
              {"total", summary.total},
              {"tested", summary.tested()},
              {"separate", summary.separate},
              {"touch", summary.touch},
              {"cross", summary.cross},
              {"inside", summary.inside},
              {"contact", summary.contact},
              {"undecided", summary.undecided},
              {"failed", summary.failed},
              {"not_tested", summary.total - summary.merged()},
              {"pairs", summary.pairs},
              {"surfaces_only", summary.surfaces_only},
              {"insides_skipped", summary.insides_skipped},
              {"cut", summary.cut},
              {"seconds", report.execution.seconds},
              {"where", report.execution.where}};
    if (context.clearance) {
        json["clearance"] = *context.clearance;
        json["near"] = summary.near;
        json["near_pairs"] = summary.near_pairs;
    }
    if (context.has_distance()) {
        add_least(context, report, json);
    }
    if (context.question == Question::Shots) {
        add_shots(report, json);
    }
    if (context.has_motions()) {
        json["question"] = "motion";
    }
    if (report.execution.reused != 0) {
        json["reused"] = report.execution.reused;
    }
    if (report.execution.resumed_at != 0) {
        json["resumed_at"] = report.execution.resumed_at;
    }
    json["statistics"] = statistics_json(report);
    if (report.execution.traffic) {
        json["depths"] = report.execution.depths;
        json["traffic"] = traffic_json(*report.execution.traffic);
    }
    json["digest"] = report.digest ? Json(to_hex(*report.digest)) : Json();
    if (report.query.limit_pairs != 0) {
        json["limit_pairs"] = report.query.limit_pairs;
    }
    if (report.map) {
        json["map_digest"] = to_hex(digest_of(*report.map));
        json["map_of_listed_pairs"] = report.query.limit_pairs != 0 && !report.query.maps;
    } else if (!report.map_withdrawn.empty()) {
        json["map_withdrawn"] = report.map_withdrawn;
    }
    Json touched = Json::array();
    for (const auto& part : report.findings.most_touched) {
        touched.push_back({{"part", part.part}, {"scenarios", part.scenarios}});
    }
    json["most_touched"] = std::move(touched);
    return write_file(dir / "summary.json", json_text(json));
}

} // namespace cd
