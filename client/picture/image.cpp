#include "client/picture/image.hpp"

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"

#include <png.h>

#include <cstddef>
#include <string>

namespace cd {

Image enlarged(const Image& image, unsigned times) {
    Image large{image.width * times, image.height * times, {}};
    large.pixels.reserve(static_cast<std::size_t>(large.width) * large.height);
    for (std::size_t y = 0; y < large.height; ++y) {
        for (std::size_t x = 0; x < large.width; ++x) {
            large.pixels.push_back(image.pixels[y / times * image.width + x / times]);
        }
    }
    return large;
}

Result<std::string> png_bytes(const Image& image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = image.width;
    header.height = image.height;
    header.format = PNG_FORMAT_RGB;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(
            &header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
        return Error{ErrorCode::Io, std::string("a picture: ") + header.message};
    }
    bytes.resize(size);
    return bytes;
}

Status write_png(const Image& image, const std::filesystem::path& path) {
    const std::string bytes = CD_TRY(png_bytes(image));
    return write_file(path, bytes);
}

} // namespace cd
