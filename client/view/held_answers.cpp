#include "client/view/held_answers.hpp"

#include "common/core/errors.hpp"
#include "web/server/page_arrays.hpp"
#include "web/server/page_json.hpp"

#include <cstddef>
#include <string_view>
#include <utility>

namespace cd {

namespace {

using TakeAnswer = std::function<Status(const HeldAnswer&)>;

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

JobView job_of(const ViewedRun& run, const PageOrigin& origin) {
    JobView job = run.view(origin.job);
    if (origin.kind != PageOrigin::Kind::Folder) {
        job.run.folder.clear();
    }
    return job;
}

using Bodies = std::set<std::uint32_t>;

Status take_meshes(const ViewedRun& run,
                   const JobView& job,
                   const Bodies& bodies,
                   const TakeAnswer& take) {
    std::set<Sha256> taken;
    for (const std::uint32_t body : bodies) {
        const Sha256& hash = job.bodies[body].body.mesh;
        if (taken.insert(hash).second) {
            CD_TRY(take({"meshes/" + to_hex(hash), run.mesh(hash)->canonical_bytes()}));
        }
    }
    return Done{};
}

Status take_maps(const ViewedRun& run, const JobView& job, const TakeAnswer& take) {
    for (std::size_t i = 0; job.map.exists && i < job.bodies.size(); ++i) {
        const auto map = CD_TRY(run.map(i));
        CD_TRY(take({"jobs/" + job.row.id + "/map/" + std::to_string(i), map_npy(map)}));
    }
    return Done{};
}

Status
take_parts(const ViewedRun& run, const JobView& job, const Bodies& bodies, const TakeAnswer& take) {
    for (const std::uint32_t body : bodies) {
        const auto parts = CD_TRY(run.parts(body));
        const std::string path = "jobs/" + job.row.id + "/parts/" + std::to_string(body);
        CD_TRY(take({path, parts_npy(parts->runs)}));
        CD_TRY(take({path + "/names", bytes_of(part_names_json(parts->names))}));
    }
    if (job.query.question != Question::Shots) {
        return Done{};
    }
    for (const std::uint32_t body : bodies) {
        if (body + 1 == job.bodies.size()) {
            continue; // The lines.
        }
        const std::string path = "jobs/" + job.row.id + "/parts/" + std::to_string(body);
        const auto are_closed = CD_TRY(run.closed_parts(body));
        CD_TRY(take({path + "/closed", closed_npy(are_closed)}));
    }
    return Done{};
}

Status take_scenario(const std::string& path,
                     std::uint64_t number,
                     const ScenarioView& scenario,
                     const TakeAnswer& take) {
    CD_TRY(take({path, bytes_of(scenario_json(number, scenario))}));
    const ScenarioResult none;
    const ScenarioResult& drawn = scenario.drawn != nullptr ? *scenario.drawn : none;
    BoundedArray pairs = pairs_npy(drawn);
    CD_TRY(take({path + "/pairs", std::move(pairs.npy), pairs.is_cut}));
    BoundedArray points = points_npy(drawn);
    CD_TRY(take({path + "/points", std::move(points.npy), points.is_cut}));
    if (drawn.question != Question::Shots) {
        return Done{};
    }
    BoundedArray hits = hits_npy(drawn);
    return take({path + "/hits", std::move(hits.npy), hits.is_cut});
}

} // namespace

Result<Bodies> bodies_of(ViewedRun& run, std::span<const std::uint64_t> scenarios) {
    if (run.step_count() == 0) {
        return Bodies{0, 1};
    }
    Bodies bodies;
    for (const std::uint64_t scenario : scenarios) {
        const auto places = CD_TRY(run.places({scenario, 1}));
        bodies.insert({places.front().body_a, places.front().body_b});
    }
    return bodies;
}

Status for_each_answer(ViewedRun& run,
                       const PageOrigin& origin,
                       std::span<const std::uint64_t> scenarios,
                       const TakeAnswer& take,
                       const StopCheck& stop) {
    const JobView job = job_of(run, origin);
    CD_TRY(take({"source", bytes_of(origin_json(origin))}));
    CD_TRY(take({"jobs/" + origin.job, bytes_of(job_view_json(job))}));
    const Bodies bodies = CD_TRY(bodies_of(run, scenarios));
    CD_TRY(take_meshes(run, job, bodies, take));
    CD_TRY(take_parts(run, job, bodies, take));
    CD_TRY(take_maps(run, job, take));
    for (const std::uint64_t number : scenarios) {
        const auto scenario = CD_TRY(run.scenario(number, stop));
        if (stop && stop()) {
            return interrupted();
        }
        const std::string path = "jobs/" + origin.job + "/scenarios/" + std::to_string(number);
        CD_TRY(take_scenario(path, number, *scenario, take));
    }
    return Done{};
}

} // namespace cd
