// Proves that reports are well-formed markup whatever texts they hold.
#include "client/document/html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include <algorithm>
#include <random>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::Not;

/// Returns the text of the element `p` of a document, or why the document is not well-formed.
std::string text_in_document(const std::string& text) {
    const std::string page =
        Html::document("t", "p{}", Html::element("p", text, {{"title", text}}));
    pugi::xml_document document;
    const auto parsed =
        document.load_buffer(page.data(), page.size(), pugi::parse_default | pugi::parse_doctype);
    if (!parsed) {
        return std::string("not well-formed: ") + parsed.description();
    }
    const pugi::xml_node node = document.child("html").child("body").child("p");
    const std::string found = node.text().get();
    // Readers of XML turn line breaks and tabs in attributes into blanks.
    std::string in_attribute = found;
    std::ranges::replace_if(
        in_attribute, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    EXPECT_EQ(node.attribute("title").value(), in_attribute);
    return found;
}

} // namespace

TEST(Html, TextsAreEscaped) {
    EXPECT_EQ(Html::text("<b>&\"").markup(), "&lt;b&gt;&amp;&quot;");
    EXPECT_EQ(text_in_document("<script>alert(1)</script> & ]]> \""),
              "<script>alert(1)</script> & ]]> \"");
}

TEST(Html, WhatTurnsTheDirectionOfWritingIsReplaced) {
    EXPECT_EQ(Html::text("a\u202eb\u2066c").markup(), "a\ufffdb\ufffdc");
    EXPECT_EQ(Html::text(std::string_view("a\0b\x1b\x7f", 5)).markup(), "a\ufffdb\ufffd\ufffd");
    EXPECT_EQ(Html::text("\xff").markup(), "\ufffd");
}

TEST(Html, RandomBytesStayWellFormed) {
    std::mt19937_64 random(3);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes;
        for (std::uint64_t k = random() % 40; k > 0; --k) {
            bytes +=
                static_cast<char>(random() % 2 == 0 ? random() % 256 : "<>&\"']-!"[random() % 8]);
        }
        EXPECT_THAT(text_in_document(bytes), Not(HasSubstr("not well-formed"))) << "round " << i;
    }
}

TEST(Html, LongNamesAreCutBetweenCharacters) {
    EXPECT_EQ(short_name("wheel"), "wheel");
    const std::string cut = short_name(std::string(79, 'x') + "\u00e4\u00e4");
    EXPECT_EQ(cut, std::string(79, 'x') + "\u2026");
}

TEST(Html, DataAddressesAreBase64) {
    // RFC 4648, section 10.
    EXPECT_EQ(data_address("image/png", "f"), "data:image/png;base64,Zg==");
    EXPECT_EQ(data_address("image/png", "fo"), "data:image/png;base64,Zm8=");
    EXPECT_EQ(data_address("image/png", "foo"), "data:image/png;base64,Zm9v");
    EXPECT_EQ(data_address("image/png", "foob"), "data:image/png;base64,Zm9vYg==");
    EXPECT_EQ(data_address("image/png", "fooba"), "data:image/png;base64,Zm9vYmE=");
    EXPECT_EQ(data_address("image/png", "foobar"), "data:image/png;base64,Zm9vYmFy");
    EXPECT_EQ(data_address("image/png", "\xff\xfe"), "data:image/png;base64,//4=");
}

TEST(Html, AScriptComesWithAPolicyThatAllowsNothingElse) {
    const std::string page = Html::document("t", "p{}", paragraph("x"), "alert('Hello, world.');");
    // The hash of this script is known from the documentation of the policy at MDN.
    EXPECT_THAT(
        page,
        HasSubstr("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                  "script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; "
                  "style-src 'sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y='; "
                  "img-src data:; base-uri 'none'; form-action 'none'\"/>"));
    EXPECT_THAT(
        page, HasSubstr("<p>x</p><script type=\"module\">alert('Hello, world.');</script></body>"));
    EXPECT_THAT(Html::document("t", "p{}", paragraph("x")), Not(HasSubstr("Security-Policy")));
}

TEST(Html, TablesHaveAHead) {
    EXPECT_EQ(html_table({html_texts({"a"}), html_texts({"1"})}, "k").markup(),
              "<table class=\"k\"><thead><tr><th>a</th></tr></thead><tr><td>1</td></tr></table>");
}

} // namespace cd::tests
