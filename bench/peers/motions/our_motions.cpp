#include "bench/peers/motions/motion_engine.hpp"
#include "bench/peers/ours.hpp"
#include "common/core/check.hpp"
#include "common/motion/tree_questions.hpp"

#include <cmath>

namespace cd::bench {

namespace {

/// The search that jobs of motions run until the first contact.
class OurMotionBodies final : public MotionBodies {
  public:
    void load(const MotionScene& scene) override {
        a_ = build_ours(scene.a, 1);
        b_ = build_ours(scene.b, 1);
        whole_ = {a_->view(), b_->view()};
        search_ = make_search(whole_.a, whole_.b, PosePair{}, {}, {.clearance = 0.0});
        radii_ = {body_radius(scene.a->vertices()), body_radius(scene.b->vertices())};
        resolution_ = scene.resolution;
    }

    Impact find(const KeyedPath& path) override {
        const auto motion = Motion::create(path.from, path.to, radii_, resolution_);
        CD_CHECK(motion.has_value());
        TreeQuestions questions(*search_, whole_, {});
        const MotionAnswer answer =
            search_cells(motion.value(), Until::Contact, 0, questions.for_cells());
        const double unit = std::exp2(-static_cast<double>(answer.depth));
        return {kind_of(answer), unit * answer.t0, unit * answer.t1};
    }

  private:
    static Impact::Kind kind_of(const MotionAnswer& answer) {
        if (answer.event()) {
            return Impact::Kind::Found;
        }
        return answer.end == MotionEnd::Limit || answer.has_open_run() ? Impact::Kind::Undecided
                                                                       : Impact::Kind::None;
    }

    std::shared_ptr<const ObbTree> a_;
    std::shared_ptr<const ObbTree> b_;
    SubtreePair whole_;
    std::unique_ptr<ContactSearch> search_; ///< Reused from path to path, as jobs do.
    BodyRadii radii_;
    double resolution_ = 0;
};

} // namespace

MotionEngine our_motions() {
    return {"cdcluster", true, [] { return std::make_unique<OurMotionBodies>(); }};
}

} // namespace cd::bench
