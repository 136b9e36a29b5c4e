#include "client/view/held_steps.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/words.hpp"
#include "web/server/page_arrays.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

namespace {

const Sha256& hash_of(const ViewedRun& run, std::uint32_t body) {
    return run.manifest().bodies[body].mesh;
}

/// The scenarios of a step, as the page asks for them.
ScenarioChoice scenarios_of(const ViewedRun& run, std::span<const StepRow> rows) {
    const std::uint64_t end = rows.size() == 2 ? rows[1].first : run.count();
    return {rows[0].first, std::min(limits::page_scenarios_max, end - rows[0].first)};
}

std::string path_of(const std::string& job, std::string_view what, const ScenarioChoice& choice) {
    return "jobs/" + job + "/" + std::string(what) + "?first=" + std::to_string(choice.first) +
           "&count=" + std::to_string(choice.count);
}

/// Where the bodies are: of motions their keys, as the page draws them on their way.
Result<HeldAnswer>
read_poses(ViewedRun& run, const std::string& job, const ScenarioChoice& choice) {
    if (run.manifest().query.motion) {
        const auto keys = CD_TRY(run.keys(choice));
        return HeldAnswer{path_of(job, "keys", choice), keys_npy(keys)};
    }
    const auto poses = CD_TRY(run.poses(choice));
    return HeldAnswer{path_of(job, "poses", choice), poses_npy(poses)};
}

/// A step's answers, and the bodies that take part in it.
struct HeldStep {
    std::vector<HeldAnswer> answers;
    std::set<std::uint32_t> bodies;
};

Result<HeldStep>
read_step(ViewedRun& run, const std::string& job, std::uint64_t step, std::uint64_t steps) {
    const ScenarioChoice rows{step, std::min<std::uint64_t>(2, steps - step)};
    const auto read = CD_TRY(run.steps(rows));
    const ScenarioChoice choice = scenarios_of(run, read);
    const auto places = CD_TRY(run.places(choice));
    const auto classes = CD_TRY(run.classes(choice));
    HeldStep found;
    found.answers.push_back({path_of(job, "steps", rows), steps_npy(read)});
    found.answers.push_back({path_of(job, "bodies", choice), bodies_npy(places)});
    found.answers.push_back({path_of(job, "classes", choice), classes_npy(classes)});
    found.answers.push_back(CD_TRY(read_poses(run, job, choice)));
    for (const ScenePlace& place : places) {
        found.bodies.insert({place.body_a, place.body_b});
    }
    return found;
}

/// Returns the meshes of bodies, the smallest first. Meshes of `held` bodies are left out.
std::vector<std::shared_ptr<const Mesh>> meshes_of(const ViewedRun& run,
                                                   const std::set<std::uint32_t>& bodies,
                                                   const std::set<std::uint32_t>& held) {
    std::set<Sha256> known;
    for (const std::uint32_t body : held) {
        known.insert(hash_of(run, body));
    }
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const std::uint32_t body : bodies) {
        if (known.insert(hash_of(run, body)).second) {
            meshes.push_back(run.mesh(hash_of(run, body)));
        }
    }
    std::ranges::stable_sort(meshes, {}, [](const auto& mesh) { return mesh->triangles().size(); });
    return meshes;
}

} // namespace

std::string LeftOut::text() const {
    std::string text = steps == 0 ? "" : "the other bodies of " + counted(steps, "step");
    text += steps == 0 || meshes == 0 ? "" : ", and ";
    return text + (meshes == 0 ? ""
                               : grouped(meshes) + (meshes == 1 ? " mesh" : " meshes") +
                                     ", drawn as boxes");
}

Result<LeftOut> offer_steps(ViewedRun& run,
                            const std::string& job,
                            std::span<const std::uint64_t> scenarios,
                            const OfferAnswers& offer,
                            const StopCheck& stop) {
    LeftOut left_out;
    std::set<std::uint64_t> known;
    std::set<std::uint32_t> bodies;
    const std::uint64_t steps = run.step_count();
    for (const std::uint64_t scenario : steps == 0 ? std::span<const std::uint64_t>() : scenarios) {
        const auto places = CD_TRY(run.places({scenario, 1}));
        if (!known.insert(places.front().step).second) {
            continue;
        }
        const HeldStep step = CD_TRY(read_step(run, job, places.front().step, steps));
        if (stop && stop()) {
            return interrupted();
        }
        if (!offer(step.answers)) {
            ++left_out.steps;
        } else if (step.bodies.size() <= limits::page_other_bodies_max + 2) {
            bodies.insert(step.bodies.begin(), step.bodies.end());
        }
    }
    const auto held = CD_TRY(bodies_of(run, scenarios));
    for (const auto& mesh : meshes_of(run, bodies, held)) {
        const HeldAnswer answer{"meshes/" + to_hex(mesh->hash()), mesh->canonical_bytes()};
        left_out.meshes += offer(std::span(&answer, 1)) ? 0 : 1;
    }
    return left_out;
}

} // namespace cd
