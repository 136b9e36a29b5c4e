// The keys of a scene's motions: the poses of its bodies, rounded once to one grid.
//
// One grid has all keys of a scene, since a body meets others at each step. Its numbers have the
// digits that the most halvings need. These follow from a bound over bodies, not over pairs: at
// each step the two bodies that move most, as if these met, each by its radius and its path alone
// (`movement_bound`). So the grid depends on the poses, the radii and the resolution, and not on
// rules or boxes. A motion that rides along with another may have a finer grid than this; no motion
// needs a coarser one. Where the bound asks for more halvings than any motion may have, the grid
// is that of the most halvings.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/motion/key_grid.hpp"
#include "common/scene/step_poses.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

/// The poses of another source as keys on one grid, such that for any two bodies `Motion::create`
/// has exact poses from each step to the next. Memory: the poses of a few steps.
class SceneKeys final : public StepPoses {
  public:
    /// Finds the grid, which reads all poses, twice as a rule. `resolution` is that of the motions,
    /// positive and finite. Errors, with the step and the body: BadInput for poses that are no keys
    /// (`unit_key`), and for a body that turns by 180 degrees from one step to the next; those of
    /// `StepPoses::read`; Interrupted.
    [[nodiscard]] static Result<std::unique_ptr<SceneKeys>> create(std::unique_ptr<StepPoses> given,
                                                                   std::vector<PlacedBody> bodies,
                                                                   double resolution,
                                                                   const StopCheck& stop = {});

    [[nodiscard]] std::uint64_t steps() const override { return given_->steps(); }
    [[nodiscard]] std::vector<double> times() const override { return given_->times(); }
    [[nodiscard]] Result<PosesOfStep> read(std::uint64_t step) override;

    [[nodiscard]] const KeyGrid& grid() const { return *grid_; }
    /// Returns how far rounding has moved a point of any body, at most, in the job's unit.
    [[nodiscard]] double moved() const { return moved_; }
    /// Returns how far that moves a point of any body at most, at any time of the motions.
    ///
    /// Rounding moves each component of a quaternion by at most 2^(bits-53), so q(tau) by at most
    /// 2^(bits-52). |q(tau)| is at least cos(45 degrees), so the body turns by less than
    /// 2^(bits-50.4) more or less. c(tau) moves by no more than its ends do, which `moved` covers.
    [[nodiscard]] double moved_between() const;

  private:
    /// What all keys need of a grid, and how far they are from the given poses at most.
    struct Needs {
        int exponent = KeyGrid::exponent_min;
        unsigned bits = 1;
        double moved = 0;
    };

    SceneKeys(std::unique_ptr<StepPoses> given, std::vector<PlacedBody> bodies, double resolution)
        : given_(std::move(given)), bodies_(std::move(bodies)), resolution_(resolution) {}

    [[nodiscard]] Status find_grid(const StopCheck& stop);
    [[nodiscard]] Result<Needs> find_needs(const StopCheck& stop);
    [[nodiscard]] Result<unsigned>
    bits_between(std::uint64_t step, const PosesOfStep& from, const PosesOfStep& to) const;
    [[nodiscard]] Result<PosesOfStep> keys_of(std::uint64_t step, const PosesOfStep& given) const;
    void add_needs(const PosesOfStep& given, const PosesOfStep& keys, Needs& needs) const;
    [[nodiscard]] Error error_at(std::uint64_t step, std::size_t body, const Error& error) const;

    std::unique_ptr<StepPoses> given_;
    std::vector<PlacedBody> bodies_;
    double resolution_;
    std::optional<KeyGrid> grid_; ///< Nothing until there is a guess.
    double moved_ = 0;
};

} // namespace cd
