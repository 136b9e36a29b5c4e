// The static files of the page, which are part of the program.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace cd {

struct PageAsset {
    std::string_view path; ///< "/app.js"
    std::string_view content_type;
    std::span<const std::byte> bytes;
    std::span<const std::byte> gzip; ///< The same, compressed.
    std::string etag;                ///< Quoted; made of the content's hash.
};

/// Returns all static files. "/" is index.html.
[[nodiscard]] std::span<const PageAsset> page_assets();

} // namespace cd
