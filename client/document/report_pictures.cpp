#include "client/document/report_pictures.hpp"

#include "client/picture/body_picture.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/limits/client.hpp"

#include <utility>

namespace cd {

namespace {

constexpr PictureSize small_size{480, 300};

} // namespace

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
    if (!folder_.empty()) {
        CD_TRY(make_directories(folder_));
    }
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        bodies_.push_back(CD_TRY(png_within_limit(draw_parts(*job.meshes[i], small_size))));
        if (!folder_.empty()) {
            const std::string name = i == 0 ? "a.png" : "b.png";
            CD_TRY(write_png(draw_parts(*job.meshes[i]), folder_ / name));
        }
    }
    for (const ScenarioResult& result : results) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto scenario = CD_TRY(job.poses->read(result.index, 1));
        const auto bodies = pictured(*job.meshes[result.body_a],
                                     *job.meshes[result.body_b],
                                     scenario.front().poses,
                                     result.pairs);
        scenarios_.push_back(CD_TRY(png_within_limit(draw_contacts(bodies, small_size))));
        if (!folder_.empty()) {
            CD_TRY(write_png(draw_contacts(bodies),
                             folder_ / (std::to_string(result.index) + ".png")));
        }
    }
    return Done{};
}

} // namespace cd
