#include "client/export/shots/shot_job.hpp"

#include <map>
#include <utility>

namespace cd {

ShotJob::ShotJob(const ExportContext& context)
    : lines_(context.bodies.back().mesh),
      views_(context.bodies.back().views ? *context.bodies.back().views : ShotViews()),
      steps_(context.steps),
      poses_(context.steps ? context.bodies.back().poses : nullptr),
      takes_first_(context.listed.first_hits) {
    std::map<const Mesh*, std::shared_ptr<const PassageFinder>> known;
    for (std::size_t i = 0; i + 1 < context.bodies.size(); ++i) {
        const ExportBody& body = context.bodies[i];
        std::shared_ptr<const PassageFinder>& finder = known[body.mesh.get()];
        if (finder == nullptr) {
            finder = make_finder(*body.mesh, lines_, views_);
        }
        targets_.push_back({steps_ ? body.name : std::string(), body.mesh, finder});
    }
}

bool ShotJob::knows_ends() const {
    return steps_ == nullptr || views_.cell_area() > 0 || poses_ != nullptr;
}

} // namespace cd
