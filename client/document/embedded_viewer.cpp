#include "client/document/embedded_viewer.hpp"

#include "client/formats/gzip.hpp"
#include "common/core/check.hpp"
#include "web/server/page_assets.hpp"

#include <algorithm>

namespace cd {

namespace {

const PageAsset& asset(std::string_view path) {
    const auto assets = page_assets();
    const auto found = std::ranges::find(assets, path, &PageAsset::path);
    CD_CHECK(found != assets.end());
    return *found;
}

std::string_view text_of(const PageAsset& asset) {
    return {reinterpret_cast<const char*>(asset.bytes.data()), asset.bytes.size()};
}

/// Makes the element that holds an answer, which is packed already.
Html held(const std::string& path, std::span<const std::byte> gzip, bool is_cut) {
    Html::Attributes attributes{{"data-path", path}};
    if (is_cut) {
        attributes.emplace_back("data-cut", "true");
    }
    return Html::element("template", base64(gzip), attributes);
}

Html held(const HeldAnswer& answer) {
    return held(answer.path, gzip(answer.bytes), answer.is_cut);
}

} // namespace

EmbeddedViewer::EmbeddedViewer() : answers_(held("app.css", asset("/app.css").gzip, false)) {}

void EmbeddedViewer::add(const HeldAnswer& answer) {
    answers_ += held(answer);
}

bool EmbeddedViewer::add_if_room(std::span<const HeldAnswer> answers, std::uint64_t bytes_max) {
    Html more;
    for (const HeldAnswer& answer : answers) {
        more += held(answer);
    }
    const bool has_room = bytes() + more.markup().size() <= bytes_max;
    answers_ += has_room ? more : Html();
    return has_room;
}

Html EmbeddedViewer::section() {
    Html content = Html::element("h2", "In 3D");
    // The page's script takes the place of what is in this element.
    content += Html::element("div",
                             paragraph("The viewer of the worst scenarios needs a browser of 2023 "
                                       "or later that runs this file's script and draws WebGL 2. "
                                       "All else in this report can be read without it.",
                                       "warning"),
                             {{"id", "page"}});
    Html licences = Html::element("summary", "Licences of the viewer's libraries");
    licences += Html::element("pre", text_of(asset("/LICENSES.txt")));
    content += Html::element("details", licences);
    return Html::element("section", content, {{"class", "viewer"}});
}

std::string_view EmbeddedViewer::script() {
    return text_of(asset("/app.js"));
}

} // namespace cd
