// Pictures of how thick a body is along the lines of each direction.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/shots/bundle_passages.hpp"
#include "client/export/shots/shot_job.hpp"
#include "client/picture/image.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// How many pictures there are, and how large.
struct ThicknessBounds {
    std::size_t views = 8;
    std::uint64_t side = 320; ///< Pixels along a side of a picture.
};

/// The bounds of pictures in files of their own.
inline constexpr ThicknessBounds large_thickness{64, 1024};

/// Paints for each of the first directions a pixel a line, or for some lines if there are more than
/// pixels. A pixel shows the largest thickness of all passages of one of its lines together, in a
/// scene through all bodies and at any step.
class ThicknessPictures {
  public:
    explicit ThicknessPictures(std::shared_ptr<const ShotJob> job,
                               const ThicknessBounds& bounds = {});

    /// Adds the next result of Question::Shots at level pairs, in submitted order. Errors: as
    /// `PassageGatherer::add`.
    [[nodiscard]] Status add(const ScenarioResult& result);
    /// Adds what is left of the last bundle.
    void finish();

    /// Returns the number of pictures; 0 for lines of a file.
    [[nodiscard]] std::size_t count() const { return rasters_.size(); }
    /// Returns the largest thickness in a picture; 0 without any.
    [[nodiscard]] double largest(std::size_t view) const;
    /// Paints a direction as lines that come from there see A: white where nothing is hit, grey
    /// where only surfaces without an inside are, else from light to dark blue with the thickness.
    [[nodiscard]] Image image(std::size_t view) const;

  private:
    /// The pixels of a direction, by rows from below.
    struct Raster {
        LinePlace lines; ///< Columns and rows of lines.
        std::uint64_t width = 0;
        std::uint64_t height = 0;
        std::vector<float> thickness; ///< Below 0: no line of the pixel hits anything.
    };

    void add(const BundlePassages& bundle);
    /// Enters what one line has met.
    void mark(std::uint64_t bundle, std::uint32_t line, double thickness);

    std::shared_ptr<const ShotJob> job_;
    PassageGatherer gatherer_;
    std::vector<Raster> rasters_;
};

} // namespace cd
