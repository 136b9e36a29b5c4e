#include "client/import/foreign/xml_text.hpp"

#include "common/core/errors.hpp"

#include <algorithm>

namespace cd {

XmlText::XmlText(const std::filesystem::path& path, std::string_view text)
    : path_(&path), text_(text), document_(std::make_unique<pugi::xml_document>()) {}

Result<XmlText> XmlText::parse(const std::filesystem::path& path, std::string_view text) {
    XmlText xml(path, text);
    // Without entities and conversions, offsets in values equal offsets in the file.
    const pugi::xml_parse_result parsed = xml.document_->load_buffer(
        text.data(), text.size(), pugi::parse_cdata, pugi::encoding_utf8);
    if (!parsed) {
        return xml.refusal(parsed.offset,
                           "is not well-formed XML: " + std::string(parsed.description()));
    }
    return xml;
}

Error XmlText::refusal(std::ptrdiff_t offset, const std::string& detail) const {
    const auto end =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
    const auto line = 1 + std::ranges::count(text_.substr(0, end), '\n');
    return bad_input(path_->string() + ":" + std::to_string(line) + ": " + detail);
}

Error XmlText::refusal(const pugi::xml_node& node, const std::string& detail) const {
    return refusal(node.offset_debug(), detail);
}

Error XmlText::refusal(const pugi::xml_node& node,
                       std::string_view part,
                       const std::string& detail) const {
    return refusal(node.offset_debug() + (part.data() - node.value()), detail);
}

} // namespace cd
