// Makes small glTF files for tests.
#pragma once

#include "common/core/files/bytes.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <vector>

namespace cd::tests {

/// A glTF document and the bytes of its first buffer. It has one scene of one node with one mesh;
/// tests fill the mesh's first primitive.
class GltfText {
  public:
    using Json = nlohmann::json;

    Json json = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0}],"meshes":[{"primitives":[{}]}],
        "accessors":[],"bufferViews":[],"buffers":[]})");
    Bytes bytes;

    /// Adds a view of all the values; returns its number.
    template <class T>
    std::size_t add_view(const std::vector<T>& values) {
        const auto added = std::as_bytes(std::span(values));
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", added.size()}});
        bytes.insert(bytes.end(), added.begin(), added.end());
        return json["bufferViews"].size() - 1;
    }

    /// Adds an accessor of all the values; returns its number.
    template <class T>
    std::size_t add(const std::vector<T>& values,
                    int component_type,
                    const std::string& type,
                    bool normalized) {
        const std::size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
        Json accessor{{"bufferView", add_view(values)},
                      {"componentType", component_type},
                      {"count", values.size() / width},
                      {"type", type}};
        if (normalized) {
            accessor["normalized"] = true;
        }
        json["accessors"].push_back(accessor);
        return json["accessors"].size() - 1;
    }

    std::size_t add_positions(const std::vector<float>& values) {
        return add(values, 5126, "VEC3", false);
    }
    std::size_t add_indices(const std::vector<std::uint16_t>& values) {
        return add(values, 5123, "SCALAR", false);
    }

    [[nodiscard]] Json& primitive() { return json["meshes"][0]["primitives"][0]; }

    /// Makes a triangle in the plane z = 0, with indices.
    static GltfText triangle() {
        GltfText text;
        const auto positions = text.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
        text.primitive() = {{"attributes", {{"POSITION", positions}}},
                            {"indices", text.add_indices({0, 1, 2})}};
        return text;
    }

    /// Returns the file with its buffer as a data: URI.
    [[nodiscard]] std::string text() const {
        Json with_buffer = json;
        with_buffer["buffers"].push_back(
            {{"byteLength", bytes.size()},
             {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
        return with_buffer.dump();
    }

    /// Returns the file with its buffer as a binary chunk.
    [[nodiscard]] std::string glb() const {
        Json with_buffer = json;
        with_buffer["buffers"].push_back({{"byteLength", bytes.size()}});
        std::string text = with_buffer.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        ByteWriter out;
        const auto put_word = [&](const char* word) {
            out.put_array(std::span<const char>(word, 4));
        };
        put_word("glTF");
        out.put(std::uint32_t{2});
        out.put(static_cast<std::uint32_t>(28 + text.size() + bytes.size()));
        out.put(static_cast<std::uint32_t>(text.size()));
        put_word("JSON");
        out.put_array(std::span<const char>(text));
        out.put(static_cast<std::uint32_t>(bytes.size()));
        put_word("BIN");
        out.put_array(
            std::span<const std::byte>(bytes).size() == 0
                ? std::span<const std::uint8_t>()
                : std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
        const Bytes all = out.take();
        return {reinterpret_cast<const char*>(all.data()), all.size()};
    }

    static std::string base64(const Bytes& bytes) {
        constexpr const char* alphabet =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                bits = bits << 8 |
                       (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                text += i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63u] : '=';
            }
        }
        return text;
    }
};

} // namespace cd::tests
