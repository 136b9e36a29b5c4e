#include "client/picture/image.hpp"

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"

#include <png.h>

#include <string>

namespace cd {

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
