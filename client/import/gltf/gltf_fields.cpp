#include "client/import/gltf/gltf_fields.hpp"

#include <utility>

namespace cd {

GltfFields::GltfFields(const Json& json, std::string place, GltfProblem& problem)
    : json_(&json), place_(std::move(place)), problem_(&problem) {
    if (!json.is_object()) {
        report("is not an object");
    }
}

const GltfFields::Json* GltfFields::find(const char* key) const {
    if (!json_->is_object()) {
        return nullptr;
    }
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}

bool GltfFields::has(const char* key) const {
    return find(key) != nullptr;
}

std::optional<std::uint64_t> GltfFields::whole(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_number_unsigned()) {
        report(std::string(key) + " is not a whole number");
        return std::nullopt;
    }
    return value == nullptr ? std::nullopt : std::optional(value->get<std::uint64_t>());
}

std::uint64_t GltfFields::needed_whole(const char* key) const {
    if (!has(key)) {
        report(std::string(key) + " is missing");
    }
    return whole(key).value_or(0);
}

std::size_t GltfFields::checked_index(const Json& value, const char* key, std::size_t count) const {
    if (!value.is_number_unsigned()) {
        report(std::string(key) + " is not an index");
        return 0;
    }
    const auto index = value.get<std::uint64_t>();
    if (index >= count) {
        report(std::string(key) + " is " + std::to_string(index) + ", and there are " +
               std::to_string(count));
        return 0;
    }
    return static_cast<std::size_t>(index);
}

std::optional<std::size_t> GltfFields::index(const char* key, std::size_t count) const {
    const Json* value = find(key);
    return value == nullptr ? std::nullopt : std::optional(checked_index(*value, key, count));
}

std::size_t GltfFields::needed_index(const char* key, std::size_t count) const {
    if (!has(key)) {
        report(std::string(key) + " is missing");
    }
    return index(key, count).value_or(0);
}

bool GltfFields::flag(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_boolean()) {
        report(std::string(key) + " is neither true nor false");
        return false;
    }
    return value != nullptr && value->get<bool>();
}

std::string GltfFields::text(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_string()) {
        report(std::string(key) + " is not text");
        return {};
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
            report(std::string(key) + " holds something other than numbers");
            return std::nullopt;
        }
        numbers.push_back(value.get<double>());
    }
    return numbers;
}

std::optional<std::vector<double>> GltfFields::numbers(const char* key, std::size_t count) const {
    auto found = numbers(key);
    if (found && found->size() != count) {
        report(std::string(key) + " has " + std::to_string(found->size()) +
               " numbers in place of " + std::to_string(count));
        return std::nullopt;
    }
    return found;
}

std::vector<std::size_t> GltfFields::indices(const char* key, std::size_t count) const {
    std::vector<std::size_t> found;
    if (count != 0 || has(key)) {
        for (const Json& value : list(key)) {
            found.push_back(checked_index(value, key, count));
        }
    }
    return found;
}

const GltfFields::Json& GltfFields::list(const char* key) const {
    static const Json none = Json::array();
    const Json* value = find(key);
    if (value != nullptr && !value->is_array()) {
        report(std::string(key) + " is not a list");
        return none;
    }
    return value == nullptr ? none : *value;
}

std::optional<GltfFields> GltfFields::object(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    return GltfFields(*value, place_.empty() ? key : place_ + ", " + key, *problem_);
}

} // namespace cd
