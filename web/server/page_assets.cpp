#include "web/server/page_assets.hpp"

#include "common/core/files/hash.hpp"

#include <array>

// The build defines the folders.
#ifndef CD_ASSETS
#define CD_ASSETS "web/assets"
#define CD_ASSETS_GZ "web/assets"
#endif

// The assembler copies a file of web/assets into the program, and its compressed form, which the
// build makes. GCC and Clang pass this text on unchanged.
#define CD_ASSET(name, file)                                                                       \
    __asm__(".pushsection .rodata\n"                                                               \
            ".global cd_asset_" #name "\n.global cd_asset_" #name "_end\n"                         \
            ".global cd_asset_" #name "_gz\n.global cd_asset_" #name "_gz_end\n"                   \
            "cd_asset_" #name ": .incbin \"" CD_ASSETS "/" file "\"\n"                             \
            "cd_asset_" #name "_end:\n"                                                            \
            "cd_asset_" #name "_gz: .incbin \"" CD_ASSETS_GZ "/" file ".gz\"\n"                    \
            "cd_asset_" #name "_gz_end:\n"                                                         \
            ".popsection\n");                                                                      \
    extern "C" const std::byte cd_asset_##name[], cd_asset_##name##_end[];                         \
    extern "C" const std::byte cd_asset_##name##_gz[], cd_asset_##name##_gz_end[]

CD_ASSET(index, "index.html");
CD_ASSET(script, "app.js");
CD_ASSET(style, "app.css");
CD_ASSET(icon, "icon.svg");
CD_ASSET(licences, "LICENSES.txt");

namespace cd {

namespace {

PageAsset asset(std::string_view path,
                std::string_view content_type,
                std::span<const std::byte> bytes,
                std::span<const std::byte> gzip) {
    return {path, content_type, bytes, gzip, '"' + to_short_hex(sha256(bytes)) + '"'};
}

} // namespace

std::span<const PageAsset> page_assets() {
    static const std::array<PageAsset, 5> assets{
        {asset("/",
               "text/html; charset=utf-8",
               {cd_asset_index, cd_asset_index_end},
               {cd_asset_index_gz, cd_asset_index_gz_end}),
         asset("/app.js",
               "text/javascript; charset=utf-8",
               {cd_asset_script, cd_asset_script_end},
               {cd_asset_script_gz, cd_asset_script_gz_end}),
         asset("/app.css",
               "text/css; charset=utf-8",
               {cd_asset_style, cd_asset_style_end},
               {cd_asset_style_gz, cd_asset_style_gz_end}),
         asset("/icon.svg",
               "image/svg+xml",
               {cd_asset_icon, cd_asset_icon_end},
               {cd_asset_icon_gz, cd_asset_icon_gz_end}),
         asset("/LICENSES.txt",
               "text/plain; charset=utf-8",
               {cd_asset_licences, cd_asset_licences_end},
               {cd_asset_licences_gz, cd_asset_licences_gz_end})}};
    return assets;
}

} // namespace cd
