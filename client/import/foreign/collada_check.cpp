#include "client/import/foreign/collada_check.hpp"

#include "client/import/foreign/collada_instances.hpp"
#include "client/import/foreign/xml_text.hpp"
#include "client/import/text/mesh_words.hpp"
#include "common/core/limits/client.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

namespace {

/// An XML element whose text consists of numbers.
struct NumberElement {
    std::string_view name;
    std::uint64_t count; ///< Number of values; 0: any.
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

/// The number of array elements that an accessor reads. Its attributes fit into ints, so nothing
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

class ColladaCheck {
  public:
    explicit ColladaCheck(const XmlText& xml) : xml_(xml) {}

    Status run() {
        // No recursion, since the file decides the depth.
        pugi::xml_node node = xml_.root();
        std::size_t depth = 1;
        while (node) {
            if (Status status = check(node, depth); !status) {
                return status;
            }
            pugi::xml_node next = is_passed_over(node) ? pugi::xml_node() : node.first_child();
            depth += next ? 1 : 0;
            while (!next && node && node != xml_.root()) {
                next = node.next_sibling();
                if (!next) {
                    node = node.parent();
                    --depth;
                }
            }
            node = next;
        }
        return check_accessors();
    }

  private:
    /// True for elements that the importer ignores, or does not use for meshes.
    static bool is_passed_over(const pugi::xml_node& node) {
        const std::string_view name = node.name();
        return name == "extra" || name == "technique";
    }

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
        if (Status attributes = check_attributes(node); !attributes) {
            return attributes;
        }
        const auto* const found =
            std::ranges::find(number_elements, name, [](const auto& e) { return e.name; });
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
            if (Status words = check_words(piece, element, place); !words) {
                return words;
            }
        }
        return Done{};
    }

    [[nodiscard]] Status check_words(const pugi::xml_node& piece,
                                     const NumberElement& element,
                                     const std::string& place) const {
        Words words(piece.value());
        std::uint64_t count = 0;
        std::string_view last = piece.value();
        for (auto word = words.next(); !word.empty(); word = words.next()) {
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

    /// Refuses accessors beyond the end of their array: the importer does not check that.
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

} // namespace

bool is_collada(const std::string& text) {
    return text.find("<COLLADA") != std::string::npos;
}

Status check_collada(const std::filesystem::path& path, const std::string& text) {
    const auto xml = XmlText::parse(path, text);
    if (!xml) {
        return xml.error();
    }
    Status numbers = ColladaCheck(xml.value()).run();
    return numbers ? check_collada_instances(xml.value()) : numbers;
}

} // namespace cd
