#include "client/export/shots/thickness_pictures.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace cd {

namespace {

constexpr float nothing = -1;
constexpr Colour white{255, 255, 255};
constexpr Colour grey{200, 200, 200};
constexpr Colour light{198, 219, 239};
constexpr Colour dark{8, 48, 107};

std::uint8_t between(std::uint8_t low, std::uint8_t high, double share) {
    return static_cast<std::uint8_t>(std::lround(low + share * (high - low)));
}

Colour colour_of(float thickness, double largest) {
    if (thickness < 0) {
        return white;
    }
    if (thickness == 0) {
        return grey;
    }
    const double share = thickness / largest;
    return {between(light.red, dark.red, share),
            between(light.green, dark.green, share),
            between(light.blue, dark.blue, share)};
}

} // namespace

ThicknessPictures::ThicknessPictures(std::shared_ptr<const ShotJob> job,
                                     const ThicknessBounds& bounds)
    : job_(std::move(job)), gatherer_(job_) {
    const ShotViews& views = job_->views();
    if (views.cell_area() == 0) {
        return;
    }
    const std::size_t count = std::min(views.count(), bounds.views);
    for (std::uint32_t view = 0; view < count; ++view) {
        const LinePlace lines = views.size(view);
        const std::uint64_t most = std::max(lines.column, lines.row);
        const std::uint64_t lines_of_pixel = (most + bounds.side - 1) / bounds.side;
        Raster raster{lines,
                      (lines.column + lines_of_pixel - 1) / lines_of_pixel,
                      (lines.row + lines_of_pixel - 1) / lines_of_pixel,
                      {}};
        raster.thickness.assign(raster.width * raster.height, nothing);
        rasters_.push_back(std::move(raster));
    }
}

Status ThicknessPictures::add(const ScenarioResult& result) {
    if (const auto bundle = CD_TRY(gatherer_.add(result))) {
        add(*bundle);
    }
    return Done{};
}

void ThicknessPictures::finish() {
    if (const auto bundle = gatherer_.finish()) {
        add(*bundle);
    }
}

void ThicknessPictures::add(const BundlePassages& bundle) {
    if (job_->views().view_of(bundle.bundle) >= rasters_.size()) {
        return;
    }
    const std::vector<BodyPassage>& passages = bundle.passages;
    for (std::size_t i = 0; i < passages.size();) {
        const std::uint32_t line = passages[i].way.line;
        double thickness = 0;
        for (; i < passages.size() && passages[i].way.line == line; ++i) {
            thickness += passages[i].way.thickness().value_or(0);
        }
        mark(bundle.bundle, line, thickness);
    }
}

void ThicknessPictures::mark(std::uint64_t bundle, std::uint32_t line, double thickness) {
    Raster& raster = rasters_[job_->views().view_of(bundle)];
    const LinePlace place = job_->views().place_of(bundle, line);
    const std::uint64_t x = place.column * raster.width / raster.lines.column;
    const std::uint64_t y = place.row * raster.height / raster.lines.row;
    float& pixel = raster.thickness[y * raster.width + x];
    pixel = std::max(pixel, static_cast<float>(thickness));
}

double ThicknessPictures::largest(std::size_t view) const {
    const std::vector<float>& all = rasters_[view].thickness;
    return all.empty() ? 0 : std::max(0.0F, *std::ranges::max_element(all));
}

Image ThicknessPictures::image(std::size_t view) const {
    const Raster& raster = rasters_[view];
    const double most = largest(view);
    Image image{static_cast<unsigned>(raster.width), static_cast<unsigned>(raster.height), {}};
    for (std::uint64_t y = raster.height; y-- > 0;) {
        for (std::uint64_t x = 0; x < raster.width; ++x) {
            image.pixels.push_back(colour_of(raster.thickness[y * raster.width + x], most));
        }
    }
    return image;
}

} // namespace cd
