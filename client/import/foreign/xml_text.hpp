// An XML document whose errors name lines.
#pragma once

#include "common/core/result.hpp"

#include <pugixml.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cd {

class XmlText {
  public:
    /// Parses a document. `path` and `text` have to outlive the result. Entities are not expanded.
    /// Errors: BadInput naming the line, for text that is not well-formed.
    [[nodiscard]] static Result<XmlText> parse(const std::filesystem::path& path,
                                               std::string_view text);

    [[nodiscard]] pugi::xml_node root() const { return document_->document_element(); }
    [[nodiscard]] const pugi::xml_document& document() const { return *document_; }

    /// Returns the error BadInput "PATH:LINE: DETAIL", with the line of the node.
    [[nodiscard]] Error refusal(const pugi::xml_node& node, const std::string& detail) const;
    /// Returns the error BadInput with the line of `part`, which lies in the node's value.
    [[nodiscard]] Error
    refusal(const pugi::xml_node& node, std::string_view part, const std::string& detail) const;

  private:
    XmlText(const std::filesystem::path& path, std::string_view text);
    [[nodiscard]] Error refusal(std::ptrdiff_t offset, const std::string& detail) const;

    const std::filesystem::path* path_;
    std::string_view text_;
    std::unique_ptr<pugi::xml_document> document_;
};

} // namespace cd
