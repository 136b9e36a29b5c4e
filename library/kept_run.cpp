#include "library/kept_run.hpp"

#include "client/folder/folder_run.hpp"
#include "client/local/done_scenario.hpp"
#include "client/local/local_report.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/geometry/simd_target.hpp"
#include "library/errors.hpp"
#include "library/mesh_state.hpp"

#include <array>
#include <utility>

namespace cdcluster {

namespace {

std::string quat_order_of(PoseForm form) {
    switch (form) {
    case PoseForm::Xyzw:
        return "xyzw";
    case PoseForm::Wxyz:
        return "wxyz";
    case PoseForm::Matrix44:
    case PoseForm::Matrix34:
        break;
    }
    return "";
}

/// Adds the answers to a run. Returns what a local run of them would have returned.
cd::Result<cd::RunOutcome>
add_all(cd::FolderRun& run, const cd::PreparedJob& job, const KeptAnswers& answers) {
    cd::ResultMerger merger = cd::merger_of(job);
    cd::ByteReader in(answers.records);
    while (!merger.summary().is_complete()) {
        const auto record = in.get_bytes(in.get<std::uint32_t>());
        auto result = CD_TRY(cd::decode_result(record));
        const cd::DoneScenario done = cd::done_scenario(std::move(result), {});
        static_cast<void>(merger.add(done.result, done.digest));
        CD_TRY(run.add(done));
    }
    CD_CHECK(in.complete());
    return cd::RunOutcome{
        merger.summary(), merger.digest(), answers.seconds, answers.statistics, {}};
}

} // namespace

cd::PreparedJob pair_job(const Mesh& a,
                         const Mesh& b,
                         std::unique_ptr<cd::PoseSource> poses,
                         PoseForm form,
                         const Query& query,
                         const std::string& name) {
    const PoseSweep sweep(a, b, query);
    cd::PreparedJob job;
    job.query = sweep.query();
    const std::array<const Mesh*, 2> meshes{&a, &b};
    for (std::size_t body = 0; body < meshes.size(); ++body) {
        const Mesh::State& mesh = *meshes.at(body)->state();
        job.names.push_back(cd::export_name(job.spec, body));
        job.meshes.push_back(mesh.mesh);
        job.spec.bodies.at(body).path =
            mesh.file.empty() ? std::filesystem::path(job.names.back()) : mesh.file;
    }
    job.spec.name = name.empty() ? job.names[0] + "-" + job.names[1] : name;
    cd::PoseFileSpec file;
    file.path = "-"; // The poses have no file of their own.
    file.quat_order = quat_order_of(form);
    job.spec.poses = std::move(file);
    job.spec.query = job.query;
    job.spec.query.ignored.clear();
    for (const IgnoreRule& rule : query.ignore) {
        job.spec.ignore.push_back({rule.a, rule.b});
    }
    job.poses = std::move(poses);
    return job;
}

void save_answers(cd::PreparedJob& job, const KeptAnswers& answers, bool overwrite) {
    cd::FolderRunOptions options;
    options.folder = {overwrite, false, false};
    options.inputs_bytes_max = UINT64_MAX; // The inputs may be nowhere else.
    options.maps_from_master = true;       // The answers have the map already.
    options.where.threads = answers.threads;
    options.where.simd = cd::to_text(cd::simd_target());
    options.command = "library";
    auto run = value_of(cd::FolderRun::begin(job, std::move(options)));
    if (run.is_complete()) {
        return;
    }
    const auto fill = [&]() -> cd::Status {
        const auto outcome = CD_TRY(add_all(run, job, answers));
        cd::RunReport report = cd::report_of(outcome, job.query, answers.threads);
        return run.finish(report, "text", answers.map);
    };
    const cd::Status filled = fill();
    run.drop_unfinished();
    check(filled);
}

} // namespace cdcluster
