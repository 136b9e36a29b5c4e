// A run of two hundred scenarios, viewed in tests.
#pragma once

#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/run_at_hand.hpp"
#include "client/view/viewed_run.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace cd::tests {

class Viewed : public testing::Test {
  protected:
    static constexpr std::uint64_t scenarios = 200; ///< Number of scenarios of the run.

    static StopCheck never() {
        return [] { return false; };
    }

    /// Runs a grid of poses along x: B passes through the two parts of A, or through the two pieces
    /// of its only part.
    std::unique_ptr<ViewedRun> view(const std::string& query, bool has_pieces = false) {
        const Mesh part = make_sphere(1);
        write_text(folder_ / "a.obj",
                   part_text("left", part, 0, 1) +
                       part_text(has_pieces ? "" : "right", part, 4, 1 + part.vertices().size()));
        write_text(folder_ / "b.obj", part_text("ball", make_torus(0.5, 0.2, 12, 8), 0, 1));
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\n"
                   "grid = { x = [-2, 6, 100], yaw_deg = [0, 40, 2] }\n[query]\n" +
                       query);
        return run_job();
    }

    /// Runs lines through two spheres, from the front and from the left.
    std::unique_ptr<ViewedRun> view_lines(const std::string& query) {
        const Mesh part = make_sphere(1);
        write_text(folder_ / "a.obj",
                   part_text("left", part, 0, 1) +
                       part_text("right", part, 4, 1 + part.vertices().size()));
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[shots]\nspacing = 0.25\ntile = 8\n"
                   "azimuth_deg = [0, 90, 2]\n[query]\n" +
                       query);
        return run_job();
    }

    /// Runs two motions of a ball: beside a sphere, and into it.
    std::unique_ptr<ViewedRun> view_motions(const std::string& query) {
        write_text(folder_ / "a.obj", part_text("left", make_sphere(1), 0, 1));
        write_text(folder_ / "b.obj", part_text("ball", make_torus(0.5, 0.2, 12, 8), 0, 1));
        write_text(folder_ / "keys.csv", "x\n6\n4\n0\n");
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nfile = \"keys.csv\"\n"
                   "[motion]\nresolution = 0.01\nuntil = \"end\"\n[query]\n" +
                       query);
        return run_job();
    }

    /// Runs a scene of two balls, `ball.0` and `ball.1`, with these rows of poses, and of a body
    /// `fixed` at the origin, which is such a ball unless another mesh is given. `more` is put
    /// behind the poses.
    std::unique_ptr<ViewedRun> view_scene(const std::string& poses,
                                          const Mesh& fixed = make_sphere(1),
                                          const std::string& more = "") {
        write_text(folder_ / "ball.obj", part_text("ball", make_sphere(1), 0, 1));
        write_text(folder_ / "fixed.obj", part_text("ball", fixed, 0, 1));
        write_text(folder_ / "poses.csv", poses);
        write_text(folder_ / "job.toml",
                   "[bodies]\nball = { mesh = \"ball.obj\", count = 2 }\n"
                   "fixed = { mesh = \"fixed.obj\", pose = [0, 0, 0, 0, 0, 0, 1],"
                   " quat_order = \"xyzw\" }\n[poses]\nfile = \"poses.csv\"\n" +
                       more);
        return run_job();
    }

    /// Opens the run again; what was opened before is no longer valid.
    [[nodiscard]] std::unique_ptr<ViewedRun> open() {
        const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
        auto found = open_run_at_hand(
            folder_ / "out", {}, "off", {.trees = Trees::Always, .map = true}, pool_);
        EXPECT_TRUE(found) << found.error().detail;
        at_hand_.emplace(std::move(found.value()));
        auto viewed = ViewedRun::open(at_hand_->run, at_hand_->job, at_hand_->map, pool_);
        EXPECT_TRUE(viewed) << viewed.error().detail;
        return std::move(viewed.value());
    }

    const TemporaryFolder folder_;
    ThreadPool pool_{2};

  private:
    /// Runs the job file, and opens the run.
    std::unique_ptr<ViewedRun> run_job() {
        RunCommand run;
        run.job.file = folder_ / "job.toml";
        run.job.output.dir = folder_ / "out";
        run.job.output.formats = {"csv"};
        run.folder.overwrite = true;
        run.quiet = true;
        EXPECT_TRUE(perform(run));
        return open();
    }

    /// Returns a mesh, moved along x, as a part of an OBJ file, or as more of the part before if it
    /// has no name; `first` is its first vertex's number.
    static std::string
    part_text(const std::string& name, const Mesh& mesh, double x, std::size_t first) {
        std::string text = name.empty() ? "" : "o " + name + "\n";
        for (const Vec3& v : mesh.vertices()) {
            text += "v " + std::to_string(v.x() + x) + " " + std::to_string(v.y()) + " " +
                    std::to_string(v.z()) + "\n";
        }
        for (const Triangle& t : mesh.triangles()) {
            text += "f " + std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
                    std::to_string(t[2] + first) + "\n";
        }
        return text;
    }

    std::optional<RunAtHand> at_hand_;
};

} // namespace cd::tests
