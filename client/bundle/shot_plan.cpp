#include "client/bundle/shot_plan.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cd {

namespace {

/// Puts the place of [shots] before what is wrong.
template <class T>
Result<T> at_place(const ShotsSpec& spec, Result<T> result) {
    return result || spec.place.empty() ? std::move(result)
                                        : Result<T>(bad_input(spec.place + result.error().detail));
}

std::string bundle_id(const ShotView& view, std::int64_t column, std::int64_t row) {
    return fmt::format("az={} el={} tile={},{}",
                       exact_text(view.azimuth_deg),
                       exact_text(view.elevation_deg),
                       column,
                       row);
}

} // namespace

std::vector<ShotView> ShotsSpec::views() const {
    std::vector<ShotView> views;
    views.reserve(azimuth_deg.count * elevation_deg.count);
    for (std::uint64_t i = 0; i < elevation_deg.count; ++i) {
        for (std::uint64_t j = 0; j < azimuth_deg.count; ++j) {
            views.push_back({azimuth_deg.at(j), elevation_deg.at(i)});
        }
    }
    return views;
}

bool stand_alike(const ShotsSpec& one, const ShotsSpec& other) {
    if (!one.is_grid() || !other.is_grid()) {
        return one.is_grid() == other.is_grid();
    }
    const auto corners = [](const ShotsSpec& spec) {
        return std::pair(spec.box.value_or(Aabb()).min, spec.box.value_or(Aabb()).max);
    };
    return one.grid.width() == other.grid.width() && one.views() == other.views() &&
           corners(one) == corners(other);
}

std::string views_text(const ShotsSpec& spec) {
    return spec.is_grid() ? counted(spec.azimuth_deg.count, "azimuth") + ", " +
                                counted(spec.elevation_deg.count, "elevation")
                          : "lines of " + spec.file.filename().string();
}

Result<Mesh> shot_mesh(const ShotsSpec& spec, const Aabb& box) {
    if (spec.is_grid()) {
        return at_place(spec, make_bundle(spec.grid, bundle_reach(box)));
    }
    const std::vector<LineEnds> lines = CD_TRY(read_lines(spec.file, spec.form, box));
    return at_place(spec, line_mesh(lines));
}

Result<std::vector<BundlePose>> shot_poses(const ShotsSpec& spec, const Aabb& box) {
    if (!spec.is_grid()) {
        return std::vector<BundlePose>(1);
    }
    return at_place(spec, bundle_poses(spec.grid, spec.views(), box));
}

ShotViews::ShotViews(const ShotsSpec& spec, const Aabb& box) {
    if (!spec.is_grid()) {
        return;
    }
    views_ = spec.views();
    tile_ = spec.grid.tile;
    cell_area_ = spec.grid.spacing * spec.grid.spacing;
    std::uint64_t begin = 0;
    for (const ShotView& view : views_) {
        begins_.push_back(begin);
        tiles_.push_back(tiles_in_view(spec.grid, view, box));
        begin += tiles_.back()[0].count * tiles_.back()[1].count;
    }
    bundles_ = begin;
}

std::string ShotViews::id_of(std::uint64_t bundle) const {
    if (views_.empty()) {
        return {};
    }
    const std::uint32_t view = view_of(bundle);
    const auto& [columns, rows] = tiles_[view];
    const std::uint64_t tile = bundle - begins_[view];
    return bundle_id(views_[view],
                     columns.first + static_cast<std::int64_t>(tile % columns.count),
                     rows.first + static_cast<std::int64_t>(tile / columns.count));
}

LinePlace ShotViews::size(std::uint32_t view) const {
    return views_.empty() ? LinePlace{}
                          : LinePlace{tiles_[view][0].count * tile_, tiles_[view][1].count * tile_};
}

std::string ShotViews::direction_text(std::uint32_t view) const {
    return views_.empty() ? "lines of a file"
                          : fmt::format("azimuth {:.6g}, elevation {:.6g}",
                                        views_[view].azimuth_deg,
                                        views_[view].elevation_deg);
}

LinePlace ShotViews::place_of(std::uint64_t bundle, std::uint32_t line) const {
    const std::uint32_t view = view_of(bundle);
    const std::uint64_t tile = bundle - begins_[view];
    const std::uint64_t columns = tiles_[view][0].count;
    return {tile % columns * tile_ + line % tile_, tile / columns * tile_ + line / tile_};
}

std::uint32_t ShotViews::view_of(std::uint64_t bundle) const {
    const auto next = std::ranges::upper_bound(begins_, bundle);
    return next == begins_.begin() ? 0 : static_cast<std::uint32_t>(next - begins_.begin() - 1);
}

Mat3 ShotViews::rotation(std::uint32_t view) const {
    return views_.empty()
               ? Mat3(Mat3::Identity())
               : Pose::from_quaternion(view_rotation(views_[view]), Vec3::Zero()).rotation();
}

PoseLabels shot_labels(const ShotsSpec& spec, const std::vector<BundlePose>& poses) {
    PoseLabels labels;
    if (!spec.is_grid()) {
        return labels;
    }
    const std::vector<ShotView> views = spec.views();
    labels.texts.reserve(poses.size());
    for (const BundlePose& pose : poses) {
        labels.texts.push_back(bundle_id(views[pose.view], pose.column, pose.row));
    }
    return labels;
}

} // namespace cd
