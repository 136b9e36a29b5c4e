#include "client/spec/shots_spec.hpp"

#include "common/core/limits/client.hpp"
#include "common/core/words.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cd {

namespace {

constexpr std::array<std::string_view, 2> line_forms{"ends", "rays"};

/// Refuses the tables whose place [shots] takes, unless the job has [bodies].
void refuse_bodies(const TomlFields& job) {
    if (job.has("bodies")) {
        return;
    }
    for (const std::string_view key : {"b", "poses"}) {
        if (job.has(key)) {
            job.refuse(key,
                       "[shots] takes the place of [b] and [poses]: its lines are body B; leave "
                       "out [" +
                           std::string(key) + "], or leave out [shots]");
        }
    }
}

GridAxis read_angles(const TomlFields& shots, std::string_view key) {
    const auto numbers = shots.numbers(key, 3, "[first, last, count]");
    if (!numbers) {
        return {};
    }
    const double count = (*numbers)[2];
    if (count < 1 || count != std::floor(count) ||
        count > static_cast<double>(limits::bundle_poses_max)) {
        shots.refuse(key,
                     std::string(key) + ": the count has to be a whole number from 1 to " +
                         grouped(limits::bundle_poses_max));
    }
    const GridAxis axis{(*numbers)[0], (*numbers)[1], static_cast<std::uint64_t>(count)};
    if (axis.count > 1 && axis.first == axis.last) {
        shots.refuse(key, std::string(key) + ": the first and the last angle are equal");
    }
    return axis;
}

void read_spacing(const TomlFields& shots, LineGrid& grid) {
    const auto spacing = shots.number("spacing");
    if (!spacing) {
        shots.refuse("spacing",
                     "spacing, the distance of lines in the job's unit, is missing; or write a "
                     "file of lines");
    }
    if (!(*spacing > 0)) {
        shots.refuse("spacing", "spacing has to be above 0");
    }
    grid.spacing = *spacing;
    grid.tile = static_cast<std::uint32_t>(
        shots.integer("tile", 1, limits::bundle_side_max).value_or(grid.tile));
    if (!std::isfinite(grid.width())) {
        shots.refuse("spacing", "spacing is too large for numbers of 64 bits");
    }
}

void read_places(const TomlFields& shots, LineGrid& grid) {
    if (const auto offset = shots.numbers("offset", 2, "[y, z], each from 0 to 1")) {
        grid.offset = {(*offset)[0], (*offset)[1]};
        for (const double share : grid.offset) {
            if (!(share >= 0 && share <= 1)) {
                shots.refuse("offset", "offset has shares of a cell, each from 0 to 1");
            }
        }
    }
    const toml::table* jitter = shots.table("jitter");
    if (jitter == nullptr) {
        return;
    }
    if (shots.has("offset")) {
        shots.refuse("offset", "offset does not count with jitter; leave out one of them");
    }
    const TomlFields fields(jitter, shots, "[shots] jitter", {"seed"});
    grid.jitter_seed =
        fields.integer("seed", 0, std::numeric_limits<std::int64_t>::max()).value_or(1);
}

void read_grid(const TomlFields& shots, ShotsSpec& spec) {
    if (shots.has("form")) {
        shots.refuse("form", "form belongs to lines from a file");
    }
    read_spacing(shots, spec.grid);
    read_places(shots, spec.grid);
    spec.azimuth_deg = read_angles(shots, "azimuth_deg");
    spec.elevation_deg = read_angles(shots, "elevation_deg");
    for (const double angle : {spec.elevation_deg.first, spec.elevation_deg.last}) {
        if (std::abs(angle) > 90) {
            shots.refuse("elevation_deg", "elevation_deg has to be between -90 and 90");
        }
    }
    if (spec.azimuth_deg.count > limits::bundle_poses_max / spec.elevation_deg.count) {
        shots.refuse("azimuth_deg",
                     "more than " + grouped(limits::bundle_poses_max) +
                         " directions; write smaller counts");
    }
}

void read_file(const TomlFields& shots,
               const std::string& name,
               const std::filesystem::path& job,
               ShotsSpec& spec) {
    if (name.empty()) {
        shots.refuse("file", "file is empty; give the name of an NPY file of lines");
    }
    for (const std::string_view key :
         {"spacing", "tile", "offset", "jitter", "azimuth_deg", "elevation_deg"}) {
        if (shots.has(key)) {
            shots.refuse(key,
                         std::string(key) + " belongs to a grid of lines; leave it out, or leave "
                                            "out file");
        }
    }
    spec.file = job.parent_path() / name;
    spec.form = shots.word("form", line_forms) == line_forms[1] ? LineForm::Rays : LineForm::Ends;
}

/// Reads the box that lines of a scene cover.
void read_box(const TomlFields& job, const TomlFields& shots, ShotsSpec& spec) {
    const auto numbers = shots.numbers("box", 6, "[x, y, z of the low corner, then of the high]");
    if (!numbers) {
        return;
    }
    if (!job.has("bodies")) {
        shots.refuse("box", "box is for a job with [bodies]; lines of two bodies cover A");
    }
    const std::vector<double>& n = *numbers;
    spec.box = Aabb{Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5])};
    if ((spec.box->min.array() > spec.box->max.array()).any()) {
        shots.refuse("box",
                     "box has the low corner first, and each number of the high one is not less");
    }
}

} // namespace

ShotsSpec read_shots(const TomlFields& job, const std::filesystem::path& file, Query& query) {
    refuse_bodies(job);
    const toml::table* table = job.table("shots");
    const TomlFields fields(table,
                            job,
                            "[shots]",
                            {"spacing",
                             "tile",
                             "offset",
                             "jitter",
                             "azimuth_deg",
                             "elevation_deg",
                             "file",
                             "form",
                             "first",
                             "box"});
    ShotsSpec spec;
    spec.place = file.string() + ":" + std::to_string(table->source().begin.line) + ": [shots]: ";
    if (const auto name = fields.text("file")) {
        read_file(fields, *name, file, spec);
    } else {
        read_grid(fields, spec);
    }
    read_box(job, fields, spec);
    query.question = Question::Shots;
    query.first_hits = fields.boolean("first").value_or(false);
    return spec;
}

} // namespace cd
