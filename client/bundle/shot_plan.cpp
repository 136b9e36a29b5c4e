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
        begin += tiles_.back()[0] * tiles_.back()[1];
    }
}

LinePlace ShotViews::size(std::uint32_t view) const {
    return views_.empty() ? LinePlace{}
                          : LinePlace{tiles_[view][0] * tile_, tiles_[view][1] * tile_};
}

LinePlace ShotViews::place_of(std::uint64_t scenario, std::uint32_t line) const {
    const std::uint32_t view = view_of(scenario);
    const std::uint64_t bundle = scenario - begins_[view];
    const std::uint64_t columns = tiles_[view][0];
    return {bundle % columns * tile_ + line % tile_, bundle / columns * tile_ + line / tile_};
}

std::uint32_t ShotViews::view_of(std::uint64_t scenario) const {
    const auto next = std::ranges::upper_bound(begins_, scenario);
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
        const ShotView& view = views[pose.view];
        labels.texts.push_back(fmt::format("az={} el={} tile={},{}",
                                           exact_text(view.azimuth_deg),
                                           exact_text(view.elevation_deg),
                                           pose.column,
                                           pose.row));
    }
    return labels;
}

} // namespace cd
