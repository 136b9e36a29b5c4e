#include "common/geometry/part_runs.hpp"

#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <functional>
#include <string_view>
#include <unordered_map>

namespace cd {

PartRuns::PartRuns(std::vector<PartRun> runs) : runs_(std::move(runs)) {
    for (const PartRun& run : runs_) {
        count_ = std::max(count_, run.part + 1);
    }
}

Result<PartRuns> PartRuns::create(std::vector<PartRun> runs) {
    const bool ascend = std::ranges::adjacent_find(
                            runs, std::ranges::greater_equal(), &PartRun::begin) == runs.end();
    if (runs.empty() || runs.front().begin != 0 || !ascend) {
        return Error{ErrorCode::BadInput, "runs of parts that do not ascend from triangle 0"};
    }
    if (std::ranges::any_of(runs,
                            [](const PartRun& run) { return run.part > limits::parts_max; })) {
        return Error{ErrorCode::BadInput, "more parts than a mesh may have"};
    }
    return PartRuns(std::move(runs));
}

std::size_t PartRuns::run_of(std::uint32_t triangle) const {
    const auto after =
        std::ranges::upper_bound(runs_, triangle, std::ranges::less(), &PartRun::begin);
    return static_cast<std::size_t>(after - runs_.begin()) - 1;
}

std::uint32_t PartRuns::end_of(std::size_t run) const {
    return run + 1 < runs_.size() ? runs_[run + 1].begin : UINT32_MAX;
}

void PartCursor::move_to(std::uint32_t triangle) {
    const std::size_t run = runs_.run_of(triangle);
    begin_ = runs_.runs()[run].begin;
    end_ = runs_.end_of(run);
    part_ = runs_.runs()[run].part;
}

namespace {

/// Collects runs in ascending order, and numbers parts by name.
class RunBuilder {
  public:
    std::uint32_t number_of(std::string_view name) {
        const auto [found, is_new] =
            numbers_.try_emplace(name, static_cast<std::uint32_t>(parts_.names.size()));
        if (is_new) {
            parts_.names.emplace_back(name);
        }
        return found->second;
    }
    void add(std::uint32_t begin, std::uint32_t end, std::string_view name) {
        if (begin == end) {
            return;
        }
        const std::uint32_t part = number_of(name);
        if (runs_.empty() || runs_.back().part != part) {
            runs_.push_back({begin, part});
        }
    }
    NamedParts take() {
        parts_.runs = PartRuns::create(std::move(runs_)).value();
        return std::move(parts_);
    }

  private:
    NamedParts parts_;
    std::vector<PartRun> runs_;
    std::unordered_map<std::string_view, std::uint32_t> numbers_; ///< Names are the mesh's.
};

} // namespace

NamedParts named_parts(const Mesh& mesh) {
    if (mesh.parts().size() <= 1) {
        return {{}, {mesh.parts().empty() ? "whole" : mesh.parts().front().name}};
    }
    constexpr std::string_view others = "others";
    RunBuilder builder;
    std::uint32_t end = 0;
    for (const Part& part : mesh.parts()) {
        builder.add(end, part.triangles_begin, others);
        builder.add(part.triangles_begin, part.triangles_end, part.name);
        end = part.triangles_end;
    }
    builder.add(end, static_cast<std::uint32_t>(mesh.triangles().size()), others);
    return builder.take();
}

std::shared_ptr<const BodyPartRuns> body_part_runs(const Mesh& a, const Mesh& b) {
    return std::make_shared<const BodyPartRuns>(
        BodyPartRuns{named_parts(a).runs, named_parts(b).runs});
}

} // namespace cd
