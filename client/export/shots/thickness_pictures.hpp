// Pictures of how thick a body is along the lines of each direction.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/shots/passages.hpp"
#include "client/picture/image.hpp"

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
/// pixels. A pixel shows the largest thickness of all passages of one of its lines together.
class ThicknessPictures {
  public:
    ThicknessPictures(std::shared_ptr<const PassageFinder> finder,
                      std::shared_ptr<const ShotViews> views,
                      const ThicknessBounds& bounds = {});

    /// Adds a result of Question::Shots at level pairs.
    void add(const ScenarioResult& result);

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

    /// Enters what one line has met.
    void mark(std::uint64_t scenario, std::uint32_t line, double thickness);

    std::shared_ptr<const PassageFinder> finder_;
    std::shared_ptr<const ShotViews> views_;
    std::vector<Raster> rasters_;
};

} // namespace cd
