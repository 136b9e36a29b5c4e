#include "client/document/report_pictures.hpp"

#include "client/picture/body_picture.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/limits/client.hpp"
#include "common/job/answer_poses.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace cd {

namespace {

constexpr PictureSize small_size{480, 300};

/// Calls `take` with each result and the bodies to be pictured.
template <class Take>
Status for_each_scenario(const PreparedJob& job,
                         const std::vector<ScenarioResult>& results,
                         const StopCheck& stop,
                         Take take) {
    for (const ScenarioResult& result : results) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto scenario = CD_TRY(job.poses->read(result.index, 1));
        CD_TRY(take(result,
                    pictured(*job.meshes[result.body_a],
                             *job.meshes[result.body_b],
                             poses_of_answer(scenario.front(), result),
                             result.pairs)));
    }
    return Done{};
}

} // namespace

std::vector<ShownBody> shown_bodies(const PreparedJob& job) {
    std::vector<ShownBody> shown;
    std::map<Sha256, std::size_t> places;
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        const auto [place, is_new] = places.try_emplace(job.meshes[i]->hash(), shown.size());
        if (is_new || !job.scene) {
            shown.push_back({i, 0});
        } else {
            ++shown[place->second].others;
        }
    }
    return shown;
}

Result<std::string> ReportPictures::png_within_limit(const Image& image) {
    std::string png = CD_TRY(png_bytes(image));
    if (bytes_ + png.size() > limits::report_pictures_bytes_max) {
        return std::string();
    }
    bytes_ += png.size();
    return png;
}

Status ReportPictures::draw(const PreparedJob& job,
                            const std::vector<ScenarioResult>& results,
                            const StopCheck& stop) {
    for (const ShownBody& each : shown_bodies(job)) {
        if (bodies_.size() == bodies_max) {
            break;
        }
        const Image image = draw_parts(*job.meshes[each.body], small_size);
        bodies_.push_back(CD_TRY(png_within_limit(image)));
    }
    return for_each_scenario(
        job, results, stop, [&](const ScenarioResult& result, const auto& bodies) -> Status {
            const Image image = draw_contacts(bodies, small_size, gap_lines(result));
            scenarios_.push_back(CD_TRY(png_within_limit(image)));
            return Done{};
        });
}

Status write_pictures(const std::filesystem::path& folder,
                      const PreparedJob& job,
                      const std::vector<ScenarioResult>& results,
                      const StopCheck& stop) {
    CD_TRY(make_directories(folder));
    for (const ShownBody& each : shown_bodies(job)) {
        const std::string name = job.scene        ? "body-" + std::to_string(each.body)
                                 : each.body == 0 ? "a"
                                                  : "b";
        CD_TRY(write_png(draw_parts(*job.meshes[each.body]), folder / (name + ".png")));
    }
    return for_each_scenario(
        job, results, stop, [&](const ScenarioResult& result, const auto& bodies) -> Status {
            return write_png(draw_contacts(bodies, {}, gap_lines(result)),
                             folder / (std::to_string(result.index) + ".png"));
        });
}

} // namespace cd
