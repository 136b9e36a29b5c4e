#include "client/import/foreign/foreign_format.hpp"

#include <algorithm>
#include <array>

namespace cd {

namespace {

struct Format {
    std::string_view extension;
    std::string_view name;
};

constexpr std::array<Format, 22> cad_formats{{
    {".step", "STEP"},
    {".stp", "STEP"},
    {".p21", "STEP"},
    {".igs", "IGES"},
    {".iges", "IGES"},
    {".brep", "Open CASCADE"},
    {".brp", "Open CASCADE"},
    {".sldprt", "SolidWorks"},
    {".sldasm", "SolidWorks"},
    {".catpart", "CATIA"},
    {".catproduct", "CATIA"},
    {".ipt", "Inventor"},
    {".iam", "Inventor"},
    {".prt", "NX or Creo"},
    {".asm", "NX or Creo"},
    {".x_t", "Parasolid"},
    {".x_b", "Parasolid"},
    {".sat", "ACIS"},
    {".jt", "JT"},
    {".3dm", "Rhino"},
    {".dwg", "AutoCAD"},
    {".fcstd", "FreeCAD"},
}};

constexpr std::array<Format, 10> archives{{
    {".zip", "zip"},
    {".7z", "7-zip"},
    {".rar", "rar"},
    {".gz", "gzip"},
    {".tgz", "tar"},
    {".tar", "tar"},
    {".bz2", "bzip2"},
    {".xz", "xz"},
    {".zst", "zstd"},
    {".lz4", "lz4"},
}};

template <std::size_t Size>
std::optional<std::string> name_in(const std::array<Format, Size>& formats,
                                   std::string_view extension) {
    const auto found = std::ranges::find(formats, extension, &Format::extension);
    return found == formats.end() ? std::nullopt : std::optional(std::string(found->name));
}

} // namespace

std::optional<std::string> foreign_format(std::string_view extension,
                                          std::string_view first_bytes) {
    auto cad = name_in(cad_formats, extension);
    if (!cad && first_bytes.starts_with("ISO-10303-21")) {
        cad = "STEP";
    }
    if (cad) {
        return "is a CAD model (" + *cad +
               "), which holds curved surfaces and no triangles; export STL, OBJ or glTF from the "
               "CAD "
               "program, or convert it with FreeCAD or gmsh";
    }
    if (const auto archive = name_in(archives, extension)) {
        return "is an archive (" + *archive + "); unpack it and give the mesh file in it";
    }
    return std::nullopt;
}

} // namespace cd
