#include "client/import/foreign/collada_instances.hpp"

#include <set>
#include <string_view>

namespace cd {

namespace {

class InstanceCheck {
  public:
    explicit InstanceCheck(const XmlText& xml) : xml_(xml) {}

    Status run() {
        note_ids();
        for (const pugi::xml_node& library : xml_.root().children()) {
            const std::string_view name = library.name();
            if (name == "library_visual_scenes" || name == "library_nodes" || name == "scene") {
                if (Status instances = check_below(library); !instances) {
                    return instances;
                }
            }
        }
        return Done{};
    }

  private:
    void note_ids() {
        for (const pugi::xml_node& library : xml_.root().children("library_geometries")) {
            for (const pugi::xml_node& geometry : library.children("geometry")) {
                const char* const id = geometry.attribute("id").value();
                (geometry.child("mesh") ? meshes_ : shapeless_).insert(id);
            }
        }
        for (const pugi::xml_node& library : xml_.root().children()) {
            const std::string_view name = library.name();
            if (name == "library_nodes" || name == "library_visual_scenes") {
                note_nodes_below(library);
            }
        }
    }

    void note_nodes_below(const pugi::xml_node& library) {
        for (pugi::xml_node node = library.first_child(); node; node = next(node, library)) {
            const std::string_view name = node.name();
            if (name == "node") {
                nodes_.insert(node.attribute("id").value());
            } else if (name == "visual_scene") {
                scenes_.insert(node.attribute("id").value());
            }
        }
    }

    Status check_below(const pugi::xml_node& library) {
        for (pugi::xml_node node = library.first_child(); node; node = next(node, library)) {
            if (Status instance = check(node); !instance) {
                return instance;
            }
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

    /// The next element below `top` in the order of the file, without recursion.
    static pugi::xml_node next(pugi::xml_node node, const pugi::xml_node& top) {
        const std::string_view name = node.name();
        const bool is_passed_over = name == "extra" || name == "technique";
        if (!is_passed_over && node.first_child()) {
            return node.first_child();
        }
        while (node && node != top && !node.next_sibling()) {
            node = node.parent();
        }
        return node == top ? pugi::xml_node() : node.next_sibling();
    }

    const XmlText& xml_;
    std::set<std::string, std::less<>> meshes_;
    std::set<std::string, std::less<>> shapeless_; ///< Geometries without a mesh.
    std::set<std::string, std::less<>> nodes_;
    std::set<std::string, std::less<>> scenes_;
};

} // namespace

Status check_collada_instances(const XmlText& xml) {
    return InstanceCheck(xml).run();
}

} // namespace cd
