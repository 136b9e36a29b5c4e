#include "client/export/shots/shot_sums.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace cd {

ShotSums::ShotSums(std::shared_ptr<const PassageFinder> finder,
                   const ShotViews& views,
                   std::string unit)
    : finder_(std::move(finder)),
      unit_(std::move(unit)),
      area_of_line_(views.cell_area() / static_cast<double>(views.count())),
      sums_(finder_->parts().count()) {}

void ShotSums::add(const ScenarioResult& result) {
    std::set<std::uint32_t> met; // Parts of the line at hand.
    std::uint32_t line = 0;
    for (const Passage& passage : finder_->passages(result)) {
        if (passage.line != line) {
            met.clear();
            line = passage.line;
        }
        Sum& sum = sums_[passage.part];
        sum.lines += met.insert(passage.part).second ? 1 : 0;
        sum.crossings += passage.out ? 2 : 1;
        if (const auto thickness = passage.thickness()) {
            ++sum.passages;
            sum.thickness += *thickness;
            sum.thickest = std::max(sum.thickest, *thickness);
        }
    }
}

std::vector<ShotPart> ShotSums::parts() const {
    std::vector<ShotPart> parts;
    for (std::uint32_t i = 0; i < sums_.size(); ++i) {
        const Sum& sum = sums_[i];
        if (sum.lines == 0) {
            continue;
        }
        ShotPart part{
            finder_->parts().name(i), finder_->is_closed(i), sum.lines, sum.crossings, unit_};
        if (area_of_line_ > 0) {
            part.area = area_of_line_ * static_cast<double>(sum.lines);
        }
        if (sum.passages > 0) {
            part.thickness = {sum.thickness / static_cast<double>(sum.passages), sum.thickest};
        }
        parts.push_back(std::move(part));
    }
    std::ranges::stable_sort(parts, std::ranges::greater(), &ShotPart::lines);
    return parts;
}

} // namespace cd
