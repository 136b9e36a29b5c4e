#include "client/groups/body_parts.hpp"

#include "common/core/limits/client.hpp"
#include "common/geometry/topology.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

constexpr const char* others = "others";

/// Returns the first triangle of each component, those with most triangles first.
std::vector<std::uint32_t> largest_first(const std::vector<std::uint32_t>& first_of) {
    std::vector<std::uint32_t> size(first_of.size(), 0);
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t i = 0; i < first_of.size(); ++i) {
        ++size[first_of[i]];
        if (first_of[i] == i) {
            firsts.push_back(i);
        }
    }
    std::ranges::stable_sort(
        firsts, [&](std::uint32_t left, std::uint32_t right) { return size[left] > size[right]; });
    return firsts;
}

/// Returns whether a mesh is a bundle of lines, each of which would be a piece.
bool is_of_lines(const Mesh& mesh) {
    return std::ranges::all_of(mesh.triangles(),
                               [](const Triangle& triangle) { return triangle[1] == triangle[2]; });
}

} // namespace

BodyParts::BodyParts(const Mesh& mesh, PartKind kind) {
    if (kind == PartKind::Named || mesh.parts().size() > 1 || is_of_lines(mesh)) {
        assign_named_parts(mesh);
    } else {
        assign_pieces(mesh);
    }
}

void BodyParts::assign_named_parts(const Mesh& mesh) {
    NamedParts parts = named_parts(mesh);
    names_ = std::move(parts.names);
    PartCursor cursor(parts.runs);
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
        part_of_.push_back(cursor.part_of(i));
    }
}

void BodyParts::assign_pieces(const Mesh& mesh) {
    part_of_ = first_of_own_component(mesh, {});
    const std::vector<std::uint32_t> firsts = largest_first(part_of_);
    if (firsts.size() == 1) {
        names_.push_back(mesh.parts().empty() ? "whole" : mesh.parts().front().name);
    }
    has_lasting_names_ = firsts.size() == 1;
    std::vector<std::uint32_t> number_of(part_of_.size());
    for (std::size_t i = 0; i < firsts.size(); ++i) {
        const std::size_t number = std::min(i, limits::pieces_max);
        number_of[firsts[i]] = static_cast<std::uint32_t>(number);
        if (number == names_.size()) {
            names_.push_back(number == limits::pieces_max ? others
                                                          : "piece " + std::to_string(number + 1));
        }
    }
    for (std::uint32_t& part : part_of_) {
        part = number_of[part];
    }
}

NamedParts BodyParts::by_runs() const {
    std::vector<PartRun> runs;
    for (std::uint32_t i = 0; i < part_of_.size(); ++i) {
        if (i == 0 || part_of_[i] != part_of_[i - 1]) {
            runs.push_back({i, part_of_[i]});
        }
    }
    return {runs.empty() ? PartRuns() : PartRuns::create(std::move(runs)).value(), names_};
}

} // namespace cd
