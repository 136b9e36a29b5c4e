#include "client/import/foreign/xml_frames.hpp"

#include "client/formats/zip_file.hpp"
#include "client/import/text/text_reader.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

namespace cd {

namespace {

struct NamedUnit {
    std::string_view name;
    double metres;
};

/// Units of AMF (ISO/ASTM 52915) and of the 3MF core specification.
constexpr std::array<NamedUnit, 7> additive_units{{{"micron", 1e-6},
                                                   {"millimeter", 1e-3},
                                                   {"centimeter", 1e-2},
                                                   {"inch", 0.0254},
                                                   {"foot", 0.3048},
                                                   {"feet", 0.3048},
                                                   {"meter", 1}}};

/// Parses the document up to its first error.
pugi::xml_document parse(std::string_view text) {
    pugi::xml_document document;
    static_cast<void>(document.load_buffer(text.data(), text.size()));
    return document;
}

/// Reads an entry's first 64 KiB, which hold a model's root element; empty on error.
std::string beginning_of(const ZipFile& archive, const std::string& name) {
    auto entry = archive.entry(name);
    std::string text(1u << 16, '\0');
    const auto size =
        entry ? entry.value().read(std::as_writable_bytes(std::span(text.data(), text.size())))
              : entry.error();
    text.resize(size ? size.value() : 0);
    return text;
}

} // namespace

DeclaredFrame collada_frame(std::string_view text) {
    const pugi::xml_document document = parse(text);
    const pugi::xml_node asset = document.child("COLLADA").child("asset");
    DeclaredFrame frame{"metre", 1, "Y"};
    if (const pugi::xml_node unit = asset.child("unit")) {
        const auto metres = to_number(unit.attribute("meter").as_string("1"));
        frame.metres = metres && std::isfinite(*metres) && *metres > 0 ? *metres : 1;
        const std::string named = unit.attribute("name").value();
        frame.unit = !named.empty()      ? named
                     : frame.metres == 1 ? "metre"
                                         : std::string(unit.attribute("meter").value()) + " m";
    }
    const std::string_view up = TextReader(asset.child_value("up_axis")).word();
    if (up == "X_UP" || up == "Z_UP") {
        frame.up = up.substr(0, 1);
    }
    return frame;
}

std::optional<DeclaredFrame> additive_frame(std::string_view text) {
    const pugi::xml_document document = parse(text);
    if (!document.document_element()) {
        return std::nullopt;
    }
    const std::string unit = document.document_element().attribute("unit").as_string("millimeter");
    const auto* const found = std::ranges::find(additive_units, unit, &NamedUnit::name);
    if (found == additive_units.end()) {
        return std::nullopt;
    }
    return DeclaredFrame{unit, found->metres, ""};
}

std::optional<DeclaredFrame> three_mf_frame(const std::filesystem::path& path) {
    const auto archive = ZipFile::open(path);
    if (!archive) {
        return std::nullopt;
    }
    const pugi::xml_document document = parse(beginning_of(archive.value(), "_rels/.rels"));
    for (const pugi::xml_node& relation : document.document_element().children()) {
        const std::string_view type = relation.attribute("Type").value();
        const std::string_view target = relation.attribute("Target").value();
        if (type.ends_with("/3dmodel")) {
            const std::string name(target.substr(target.starts_with('/') ? 1 : 0));
            return additive_frame(beginning_of(archive.value(), name));
        }
    }
    return std::nullopt;
}

} // namespace cd
