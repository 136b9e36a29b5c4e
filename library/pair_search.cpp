#include "library/pair_search.hpp"

#include "common/tree/wide/wide_tree.hpp"

namespace cdcluster {

namespace {

bool points_of(const cd::ObbTree& tree) {
    return tree.wide() != nullptr && !tree.wide()->view().support.sets.empty();
}

bool is_same(const cd::Query& x, const cd::Query& y) {
    return x.level == y.level && x.limit_pairs == y.limit_pairs && x.ignored == y.ignored &&
           x.maps == y.maps && x.clearance == y.clearance && x.question == y.question &&
           x.up_to == y.up_to;
}

} // namespace

PairSearch::PairSearch(std::shared_ptr<const cd::ObbTree> a,
                       std::shared_ptr<const cd::ObbTree> b,
                       cd::Query query)
    : a_(std::move(a)),
      b_(std::move(b)),
      query_(std::move(query)),
      has_points_(points_of(*a_) && points_of(*b_)),
      trees_(*a_, *b_),
      runner_(trees_, query_, cd::PairStage::Float, [this] { return stop_ && stop_(); }),
      session_(runner_) {}

bool PairSearch::is_of(const cd::Mesh& a, const cd::Mesh& b, const cd::Query& query) const {
    return &a_->mesh() == &a && &b_->mesh() == &b && is_same(query_, query);
}

PairSearch::Use::Use(PairSearch& search, cd::StopCheck stop)
    : search_(search), lock_(search.mutex_, std::try_to_lock) {
    if (lock_) {
        search_.stop_ = std::move(stop);
        return;
    }
    own_runner_.emplace(search_.trees_, search_.query_, cd::PairStage::Float, std::move(stop));
    own_session_.emplace(*own_runner_);
}

PairSearch::Use::~Use() {
    if (lock_) {
        search_.stop_ = {};
    }
}

cd::ScenarioRun PairSearch::Use::run(const cd::Scenario& scenario) {
    return lock_ ? search_.session_.run(scenario) : own_session_->run(scenario);
}

} // namespace cdcluster
