#include "client/import/foreign/collada_check.hpp"

#include "client/import/foreign/xml_text.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace cd {

namespace {

/// An XML element whose text consists of numbers.
struct NumberElement {
    std::string_view name;
    std::uint64_t count; ///< Number of values; 0: any number.
    bool is_whole;       ///< The numbers are indices or counts.
};

constexpr std::array<NumberElement, 9> number_elements{{
    {"float_array", 0, false},
    {"matrix", 16, false},
    {"translate", 3, false},
    {"rotate", 4, false},
    {"scale", 3, false},
    {"skew", 7, false},
    {"lookat", 9, false},
    {"p", 0, true},
    {"vcount", 0, true},
}};

/// True for an index that fits into an int, as the importer stores it.
bool is_index(std::string_view word) {
    const auto value = to_whole(word);
    return value && *value <= std::numeric_limits<int>::max();
}

std::uint64_t number_of(const pugi::xml_node& element, const char* name, std::uint64_t otherwise) {
    return to_whole(element.attribute(name).value()).value_or(otherwise);
}

/// Returns how many array elements an accessor spans. Its attributes fit into ints, so nothing
/// overflows.
std::uint64_t numbers_read(const pugi::xml_node& accessor) {
    const std::uint64_t count = number_of(accessor, "count", 0);
    const std::uint64_t stride = number_of(accessor, "stride", 1);
    const auto params = accessor.children("param");
    const auto width = static_cast<std::uint64_t>(std::distance(params.begin(), params.end()));
    return count == 0
               ? 0
               : number_of(accessor, "offset", 0) + (count - 1) * stride + std::max(stride, width);
}

/// True for elements that the importer ignores or does not use for meshes.
bool is_passed_over(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name == "extra" || name == "technique";
}

/// Calls `visit` for `top` and each node below it, in the order of the file, with its depth (1 for
/// `top`), until `visit` returns an error. Skips the content of elements for which `is_passed_over`
/// is true. It does not recurse, since the file decides the depth.
template <class Visit>
Status for_each_node(const pugi::xml_node& top, const Visit& visit) {
    pugi::xml_node node = top;
    std::size_t depth = 1;
    while (node) {
        CD_TRY(visit(node, depth));
        pugi::xml_node next = is_passed_over(node) ? pugi::xml_node() : node.first_child();
        depth += next ? 1 : 0;
        while (!next && node && node != top) {
            next = node.next_sibling();
            if (!next) {
                node = node.parent();
                --depth;
            }
        }
        node = next;
    }
    return Done{};
}

/// Checks the numbers in the text of elements and in attributes, and the bounds of arrays.
class NumberCheck {
  public:
    explicit NumberCheck(const XmlText& xml) : xml_(xml) {}

    Status run() {
        CD_TRY(for_each_node(xml_.root(), [&](const pugi::xml_node& node, std::size_t depth) {
            return check(node, depth);
        }));
        return check_accessors();
    }

  private:
    Status check(const pugi::xml_node& node, std::size_t depth) {
        if (node.type() != pugi::node_element) {
            return Done{};
        }
        if (depth > limits::mesh_file_depth_max) {
            return xml_.refusal(node,
                                "elements nested more than " +
                                    std::to_string(limits::mesh_file_depth_max) + " deep");
        }
        if (is_passed_over(node)) {
            return Done{};
        }
        const std::string_view name = node.name();
        if (name == "accessor") {
            accessors_.push_back(node);
        } else if (name == "float_array") {
            arrays_[node.attribute("id").value()] = number_of(node, "count", 0);
        }
        CD_TRY(check_attributes(node));
        const auto* const found = std::ranges::find(number_elements, name, &NumberElement::name);
        return found == number_elements.end() ? Done{} : check_numbers_of(node, *found);
    }

    [[nodiscard]] Status check_attributes(const pugi::xml_node& node) const {
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            const std::string_view name = attribute.name();
            const std::string_view value = attribute.value();
            const bool is_whole = name == "count" || name == "offset" || name == "stride";
            const bool is_meter = name == "meter" && std::string_view(node.name()) == "unit";
            if ((is_whole && !is_index(value)) || (is_meter && !to_number(value))) {
                return xml_.refusal(node,
                                    std::string(name) + " is '" + std::string(value) +
                                        "', which is not a " + (is_whole ? "whole " : "") +
                                        "number");
            }
        }
        return Done{};
    }

    [[nodiscard]] Status check_numbers_of(const pugi::xml_node& node, NumberElement element) const {
        const std::string place = "in <" + std::string(element.name) + ">, ";
        if (element.name == "float_array") {
            element.count = number_of(node, "count", 0);
        }
        bool has_text = false;
        for (const pugi::xml_node& piece : node.children()) {
            if (piece.type() == pugi::node_element) {
                return xml_.refusal(piece, place + "an element among its numbers");
            }
            if (has_text) {
                return xml_.refusal(piece, place + "the importer reads its text up to here only");
            }
            has_text = true;
            CD_TRY(check_words(piece, element, place));
        }
        return Done{};
    }

    [[nodiscard]] Status check_words(const pugi::xml_node& piece,
                                     const NumberElement& element,
                                     const std::string& place) const {
        TextReader words(piece.value());
        std::uint64_t count = 0;
        std::string_view last = piece.value();
        for (auto word = words.word(); !word.empty(); word = words.word()) {
            if (element.is_whole ? !is_index(word) : !to_number(word)) {
                return xml_.refusal(piece,
                                    word,
                                    place + "'" + std::string(word) + "' is not " +
                                        (element.is_whole ? "an index" : "a number"));
            }
            last = word;
            ++count;
        }
        if (element.count != 0 && count != 0 && count != element.count) {
            return xml_.refusal(piece,
                                last,
                                place + std::to_string(count) + " numbers in place of " +
                                    std::to_string(element.count));
        }
        return Done{};
    }

    /// Refuses accessors beyond the end of their array, which the importer would read.
    [[nodiscard]] Status check_accessors() const {
        for (const pugi::xml_node& accessor : accessors_) {
            const std::string_view source = accessor.attribute("source").value();
            const auto array = arrays_.find(source.substr(source.starts_with('#') ? 1 : 0));
            if (array != arrays_.end() && numbers_read(accessor) > array->second) {
                return xml_.refusal(accessor,
                                    "an accessor of " + std::to_string(numbers_read(accessor)) +
                                        " numbers to an array that counts " +
                                        std::to_string(array->second));
            }
        }
        return Done{};
    }

    const XmlText& xml_;
    std::map<std::string_view, std::uint64_t> arrays_; ///< The count of each array, by id.
    std::vector<pugi::xml_node> accessors_;
};

/// Checks that every instance in the scene refers to a rigid mesh of the file.
class InstanceCheck {
  public:
    explicit InstanceCheck(const XmlText& xml) : xml_(xml) {}

    Status run() {
        for (const pugi::xml_node& library : xml_.root().children("library_geometries")) {
            for (const pugi::xml_node& geometry : library.children("geometry")) {
                const char* const id = geometry.attribute("id").value();
                (geometry.child("mesh") ? meshes_ : shapeless_).insert(id);
            }
        }
        CD_TRY(for_each_in({"library_nodes", "library_visual_scenes"},
                           [&](const pugi::xml_node& node) { return note_id(node); }));
        return for_each_in({"library_nodes", "library_visual_scenes", "scene"},
                           [&](const pugi::xml_node& node) { return check(node); });
    }

  private:
    /// Calls `visit` for the root's children with one of these names and for each node below them.
    template <class Visit>
    Status for_each_in(std::initializer_list<std::string_view> names, const Visit& visit) const {
        for (const pugi::xml_node& library : xml_.root().children()) {
            if (std::ranges::find(names, library.name()) != names.end()) {
                CD_TRY(for_each_node(
                    library, [&](const pugi::xml_node& node, std::size_t) { return visit(node); }));
            }
        }
        return Done{};
    }

    Status note_id(const pugi::xml_node& node) {
        const std::string_view name = node.name();
        if (name == "node" || name == "visual_scene") {
            (name == "node" ? nodes_ : scenes_).insert(node.attribute("id").value());
        }
        return Done{};
    }

    [[nodiscard]] Status check(const pugi::xml_node& node) const {
        const std::string_view name = node.name();
        const std::string url = node.attribute("url").value();
        const std::string id = url.starts_with('#') ? url.substr(1) : std::string();
        const auto missing = [&] {
            return xml_.refusal(
                node, std::string(name) + " names '" + url + "', which is not in this file");
        };
        if (name == "instance_geometry") {
            if (shapeless_.contains(id)) {
                return xml_.refusal(node,
                                    "geometry '" + id +
                                        "' is no mesh (convex_mesh, spline or brep); export it as "
                                        "triangles");
            }
            return meshes_.contains(id) ? Status(Done{}) : missing();
        }
        if (name == "instance_controller") {
            return xml_.refusal(node,
                                "a mesh deformed by a skin or a morph ('" + url +
                                    "'), and only rigid meshes are read; apply it in the program "
                                    "that wrote the file");
        }
        if (name == "instance_node") {
            return nodes_.contains(id) ? Status(Done{}) : missing();
        }
        if (name == "instance_visual_scene") {
            return scenes_.contains(id) ? Status(Done{}) : missing();
        }
        return Done{};
    }

    const XmlText& xml_;
    std::set<std::string, std::less<>> meshes_;
    std::set<std::string, std::less<>> shapeless_; ///< Ids of geometries without a mesh.
    std::set<std::string, std::less<>> nodes_;
    std::set<std::string, std::less<>> scenes_;
};

} // namespace

bool is_collada(const std::string& text) {
    return text.find("<COLLADA") != std::string::npos;
}

Status check_collada(const std::filesystem::path& path, const std::string& text) {
    const auto xml = CD_TRY(XmlText::parse(path, text));
    CD_TRY(NumberCheck(xml).run());
    return InstanceCheck(xml).run();
}

} // namespace cd
