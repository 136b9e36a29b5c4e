// Markup of a document that is HTML and well-formed XML alike.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// Well-formed markup. Foreign text enters only through `text` and attributes, which escape it.
class Html {
  public:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;

    Html() = default;
    /// Makes markup of a text. Characters that a reader may not show, or that would turn the
    /// direction of writing, become U+FFFD.
    [[nodiscard]] static Html text(std::string_view text);
    /// Makes an element with this content. `name` and the names of attributes are plain words.
    [[nodiscard]] static Html
    element(std::string_view name, const Html& content, const Attributes& attributes = {});
    /// Makes an element with a text as its content.
    [[nodiscard]] static Html
    element(std::string_view name, std::string_view text, const Attributes& attributes = {}) {
        return element(name, Html::text(text), attributes);
    }
    /// Makes a complete document. `style` is a style sheet without angle brackets. With a script (a
    /// module's text, without line breaks other than LF), the document has a policy that allows
    /// this script and this style alone, and pictures in the document; it is then HTML, but not
    /// XML.
    [[nodiscard]] static std::string document(std::string_view title,
                                              std::string_view style,
                                              const Html& body,
                                              std::string_view script = {});

    Html& operator+=(const Html& more) {
        markup_ += more.markup_;
        return *this;
    }
    [[nodiscard]] const std::string& markup() const { return markup_; }
    [[nodiscard]] bool is_empty() const { return markup_.empty(); }

  private:
    std::string markup_;
};

/// Returns the beginning of a foreign name that is shown, at most 80 bytes and an ellipsis.
[[nodiscard]] std::string short_name(std::string_view name);

[[nodiscard]] Html paragraph(std::string_view text, const char* kind = nullptr);
[[nodiscard]] Html html_section(const char* title, const Html& content);
[[nodiscard]] Html html_list(const std::vector<std::string>& items);
/// Makes cells of texts.
[[nodiscard]] std::vector<Html> html_texts(const std::vector<std::string>& cells);

/// Makes a table: rows of cells, of which the first row is the head.
[[nodiscard]] Html html_table(const std::vector<std::vector<Html>>& rows, std::string_view kind);

/// Makes a figure of a PNG file, or of a note where there is no room for the picture (`png` is
/// empty).
[[nodiscard]] Html
html_figure(const std::string& png, const Html& caption, const std::string& alternative);

/// Encodes bytes as Base64 (RFC 4648, section 4).
[[nodiscard]] std::string base64(std::span<const std::byte> bytes);

/// Returns the bytes as a `data:` address with this media type, encoded as Base64.
[[nodiscard]] std::string data_address(std::string_view media_type, std::string_view bytes);

} // namespace cd
