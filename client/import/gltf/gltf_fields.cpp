#include "client/import/gltf/gltf_fields.hpp"

#include <utility>

namespace cd {

GltfFields::GltfFields(const Json& json, std::string place)
    : json_(&json), place_(std::move(place)) {
    if (!json.is_object()) {
        refuse("is not an object");
    }
}

const GltfFields::Json* GltfFields::find(const char* key) const {
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}

bool GltfFields::has(const char* key) const {
    return find(key) != nullptr;
}

std::optional<std::uint64_t> GltfFields::whole(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_number_unsigned()) {
        refuse(std::string(key) + " is not a whole number");
    }
    return value == nullptr ? std::nullopt : std::optional(value->get<std::uint64_t>());
}

std::uint64_t GltfFields::needed_whole(const char* key) const {
    const auto value = whole(key);
    if (!value) {
        refuse(std::string(key) + " is missing");
    }
    return *value;
}

std::size_t GltfFields::checked_index(const Json& value, const char* key, std::size_t count) const {
    if (!value.is_number_unsigned()) {
        refuse(std::string(key) + " is not an index");
    }
    const auto index = value.get<std::uint64_t>();
    if (index >= count) {
        refuse(std::string(key) + " is " + std::to_string(index) + ", and there are " +
               std::to_string(count));
    }
    return static_cast<std::size_t>(index);
}

std::optional<std::size_t> GltfFields::index(const char* key, std::size_t count) const {
    const Json* value = find(key);
    return value == nullptr ? std::nullopt : std::optional(checked_index(*value, key, count));
}

std::size_t GltfFields::needed_index(const char* key, std::size_t count) const {
    const auto value = index(key, count);
    if (!value) {
        refuse(std::string(key) + " is missing");
    }
    return *value;
}

bool GltfFields::flag(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_boolean()) {
        refuse(std::string(key) + " is neither true nor false");
    }
    return value != nullptr && value->get<bool>();
}

std::string GltfFields::text(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_string()) {
        refuse(std::string(key) + " is not text");
    }
    return value == nullptr ? std::string() : value->get<std::string>();
}

std::optional<std::vector<double>> GltfFields::numbers(const char* key) const {
    if (!has(key)) {
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (const Json& value : list(key)) {
        if (!value.is_number()) {
            refuse(std::string(key) + " holds something other than numbers");
        }
        numbers.push_back(value.get<double>());
    }
    return numbers;
}

std::optional<std::vector<double>> GltfFields::numbers(const char* key, std::size_t count) const {
    auto found = numbers(key);
    if (found && found->size() != count) {
        refuse(std::string(key) + " has " + std::to_string(found->size()) +
               " numbers in place of " + std::to_string(count));
    }
    return found;
}

std::vector<std::size_t> GltfFields::indices(const char* key, std::size_t count) const {
    std::vector<std::size_t> found;
    for (const Json& value : list(key)) {
        found.push_back(checked_index(value, key, count));
    }
    return found;
}

const GltfFields::Json& GltfFields::list(const char* key) const {
    static const Json none = Json::array();
    const Json* value = find(key);
    if (value != nullptr && !value->is_array()) {
        refuse(std::string(key) + " is not a list");
    }
    return value == nullptr ? none : *value;
}

std::optional<GltfFields> GltfFields::object(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    return GltfFields(*value, place_.empty() ? key : place_ + ", " + key);
}

} // namespace cd
