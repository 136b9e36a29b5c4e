#include "client/export/shots/shot_sums.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace cd {

ShotSums::ShotSums(std::shared_ptr<const ShotJob> job, std::string unit)
    : job_(std::move(job)), gatherer_(job_), unit_(std::move(unit)) {
    const ShotViews& views = job_->views();
    const std::uint64_t steps = job_->steps() ? job_->steps()->steps() : 1;
    area_of_line_ = views.cell_area() / static_cast<double>(views.count() * steps);
    for (std::size_t body = 0; body < job_->bodies(); ++body) {
        sums_.emplace_back(job_->finder(body).parts().count());
    }
}

Status ShotSums::add(const ScenarioResult& result) {
    if (const auto bundle = CD_TRY(gatherer_.add(result))) {
        add(*bundle);
    }
    return Done{};
}

void ShotSums::finish() {
    if (const auto bundle = gatherer_.finish()) {
        add(*bundle);
    }
}

void ShotSums::add(const BundlePassages& bundle) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> met; // Bodies and parts of the line at hand.
    std::uint32_t line = 0;
    for (const auto& [way, place] : bundle.passages) {
        if (way.line != line) {
            met.clear();
            line = way.line;
        }
        const std::uint32_t body = bundle.bodies[place].body;
        Sum& sum = sums_[body][way.part];
        sum.lines += met.emplace(body, way.part).second ? 1 : 0;
        sum.crossings += way.out ? 2 : 1;
        if (const auto thickness = way.thickness()) {
            ++sum.passages;
            sum.thickness += *thickness;
            sum.thickest = std::max(sum.thickest, *thickness);
        }
    }
}

std::vector<ShotPart> ShotSums::parts() const {
    std::vector<ShotPart> parts;
    for (std::size_t body = 0; body < sums_.size(); ++body) {
        const PassageFinder& finder = job_->finder(body);
        for (std::uint32_t i = 0; i < sums_[body].size(); ++i) {
            const Sum& sum = sums_[body][i];
            if (sum.lines == 0) {
                continue;
            }
            ShotPart part{(job_->steps() ? job_->name(body) + "/" : "") + finder.parts().name(i),
                          finder.is_closed(i),
                          sum.lines,
                          sum.crossings,
                          unit_};
            if (area_of_line_ > 0) {
                part.area = area_of_line_ * static_cast<double>(sum.lines);
            }
            if (sum.passages > 0) {
                part.thickness = {sum.thickness / static_cast<double>(sum.passages), sum.thickest};
            }
            parts.push_back(std::move(part));
        }
    }
    std::ranges::stable_sort(parts, std::ranges::greater(), &ShotPart::lines);
    return parts;
}

} // namespace cd
