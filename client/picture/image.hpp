// An image in memory, and its PNG file.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cd {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    friend bool operator==(const Colour&, const Colour&) = default;
};

/// An image, whose pixels are in rows from top to bottom, each from left to right.
struct Image {
    unsigned width = 0;
    unsigned height = 0;
    std::vector<Colour> pixels;
};

/// Returns the image with each pixel as a square of `times` pixels a side.
[[nodiscard]] Image enlarged(const Image& image, unsigned times);

/// Returns the bytes of a PNG file with 8 bits per channel. Errors: Io.
[[nodiscard]] Result<std::string> png_bytes(const Image& image);

/// Writes a PNG file with 8 bits per channel, whole or not at all. Errors: Io naming the file.
[[nodiscard]] Status write_png(const Image& image, const std::filesystem::path& path);

} // namespace cd
