#include "client/document/html.hpp"

#include "common/core/check.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/printable.hpp"

#include <cstdint>

namespace cd {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd"; ///< U+FFFD

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f;
}

/// True for U+202A to U+202E and U+2066 to U+2069, which turn the direction of writing, and for
/// U+FFFE and U+FFFF, which XML forbids. All have three bytes.
bool is_refused(std::string_view three) {
    return (three >= "\xe2\x80\xaa" && three <= "\xe2\x80\xae") ||
           (three >= "\xe2\x81\xa6" && three <= "\xe2\x81\xa9") || three == "\xef\xbf\xbe" ||
           three == "\xef\xbf\xbf";
}

std::string escaped_markup(std::string_view text) {
    const std::string valid = valid_utf8(text);
    std::string markup;
    for (std::size_t i = 0; i < valid.size(); ++i) {
        switch (const char c = valid[i]) {
        case '&':
            markup += "&amp;";
            break;
        case '<':
            markup += "&lt;";
            break;
        case '>':
            markup += "&gt;";
            break;
        case '"':
            markup += "&quot;";
            break;
        default:
            if (is_control(c)) {
                markup += replacement;
            } else if (is_refused(std::string_view(valid).substr(i, 3))) {
                markup += replacement;
                i += 2;
            } else {
                markup += c;
            }
        }
    }
    return markup;
}

/// Returns a text's hash as a source of a policy (W3C, Content Security Policy 3, section 2.3.1).
std::string policy_hash(std::string_view text) {
    return "'sha256-" + base64(sha256(std::as_bytes(std::span(text))).bytes) + "'";
}

/// Returns the element that lets a document run `script`, use `style`, and load nothing.
Html policy(std::string_view style, std::string_view script) {
    return Html::element(
        "meta",
        Html(),
        {{"http-equiv", "Content-Security-Policy"},
         {"content",
          "default-src 'none'; script-src " + policy_hash(script) + "; style-src " +
              policy_hash(style) + "; img-src data:; base-uri 'none'; form-action 'none'"}});
}

/// Returns the element of a module. Its text is not escaped, so that nothing in it may end it.
std::string script_element(std::string_view script) {
    for (const char* const end : {"</script", "<script", "<!--", "\r"}) {
        CD_CHECK(script.find(end) == script.npos);
    }
    return "<script type=\"module\">" + std::string(script) + "</script>";
}

} // namespace

Html Html::text(std::string_view text) {
    Html html;
    html.markup_ = escaped_markup(text);
    return html;
}

Html Html::element(std::string_view name, const Html& content, const Attributes& attributes) {
    Html html;
    html.markup_ = "<" + std::string(name);
    for (const auto& [key, value] : attributes) {
        html.markup_ += " " + std::string(key) + "=\"" + escaped_markup(value) + "\"";
    }
    const bool is_void = name == "img" || name == "rect" || name == "br" || name == "meta";
    html.markup_ += is_void ? "/>" : ">" + content.markup_ + "</" + std::string(name) + ">";
    return html;
}

std::string Html::document(std::string_view title,
                           std::string_view style,
                           const Html& body,
                           std::string_view script) {
    const bool has_script = !script.empty();
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>" +
           (has_script ? policy(style, script) : Html()).markup_ + "<title>" +
           escaped_markup(title) + "</title><style>" + std::string(style) +
           "</style></head>\n<body>" + body.markup_ + (has_script ? script_element(script) : "") +
           "</body></html>\n";
}

std::string short_name(std::string_view name) {
    constexpr std::size_t bytes_max = 80;
    return name.size() <= bytes_max ? std::string(name)
                                    : std::string(utf8_prefix(name, bytes_max)) + "\u2026";
}

Html html_table(const std::vector<std::vector<Html>>& rows, std::string_view kind) {
    Html lines;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Html cells;
        for (const Html& cell : rows[i]) {
            cells += Html::element(i == 0 ? "th" : "td", cell);
        }
        const Html line = Html::element("tr", cells);
        lines += i == 0 ? Html::element("thead", line) : line;
    }
    return Html::element("table", lines, {{"class", std::string(kind)}});
}

Html html_figure(const std::string& png, const Html& caption, const std::string& alternative) {
    Html content =
        png.empty()
            ? paragraph("The picture is left out, to keep the report small.")
            : Html::element(
                  "img", Html(), {{"src", data_address("image/png", png)}, {"alt", alternative}});
    content += Html::element("figcaption", caption);
    return Html::element("figure", content);
}

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 |
                    (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

std::string data_address(std::string_view media_type, std::string_view bytes) {
    return "data:" + std::string(media_type) + ";base64," + base64(std::as_bytes(std::span(bytes)));
}

Html paragraph(std::string_view text, const char* kind) {
    return kind == nullptr ? Html::element("p", text) : Html::element("p", text, {{"class", kind}});
}

Html html_section(const char* title, const Html& content) {
    return Html::element("section", Html::element("h2", title) += content);
}

std::vector<Html> html_texts(const std::vector<std::string>& cells) {
    std::vector<Html> row;
    for (const std::string& cell : cells) {
        row.push_back(Html::text(cell));
    }
    return row;
}

Html html_list(const std::vector<std::string>& items) {
    Html lines;
    for (const std::string& item : items) {
        lines += Html::element("li", item);
    }
    return Html::element("ul", lines);
}

} // namespace cd
