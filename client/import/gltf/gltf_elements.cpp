#include "client/import/gltf/gltf_elements.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace cd {

namespace {

template <class T>
double load(const std::byte* from, bool is_normalized) {
    T value{};
    std::memcpy(&value, from, sizeof value);
    const auto number = static_cast<double>(value);
    // glTF 2.0, section 3.11: the smallest signed integer means -1 as well.
    return is_normalized
               ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0)
               : number;
}

double load_number(GltfNumber type, const std::byte* from, bool is_normalized) {
    switch (type) {
    case GltfNumber::I8:
        return load<std::int8_t>(from, is_normalized);
    case GltfNumber::U8:
        return load<std::uint8_t>(from, is_normalized);
    case GltfNumber::I16:
        return load<std::int16_t>(from, is_normalized);
    case GltfNumber::U16:
        return load<std::uint16_t>(from, is_normalized);
    case GltfNumber::U32:
        return load<std::uint32_t>(from, is_normalized);
    case GltfNumber::F32:
        break;
    }
    return load<float>(from, false);
}

bool is_within(std::uint64_t offset, std::uint64_t bytes, std::uint64_t size) {
    return offset <= size && bytes <= size - offset;
}

} // namespace

Result<GltfElements::Run> GltfElements::open_run(const GltfDocument& document,
                                                 const GltfBuffers& buffers,
                                                 const GltfRun& run,
                                                 std::uint64_t count,
                                                 std::uint64_t stride,
                                                 std::uint64_t element_bytes) {
    const GltfView& view = document.views[run.view];
    const std::string name = "bufferView " + std::to_string(run.view);
    const auto buffer = buffers.bytes(view.buffer);
    if (!is_within(view.offset, view.bytes, buffer.size())) {
        return bad_input(name + " goes beyond buffer " + std::to_string(view.buffer) + " of " +
                         std::to_string(buffer.size()) + " bytes");
    }
    if (stride < element_bytes) {
        return bad_input(name + " has a byteStride of " + std::to_string(stride) +
                         ", less than an element of " + std::to_string(element_bytes) + " bytes");
    }
    if (count == 0) {
        return Run{nullptr, stride};
    }
    const bool is_there = is_within(run.offset, element_bytes, view.bytes) &&
                          count - 1 <= (view.bytes - run.offset - element_bytes) / stride;
    if (!is_there) {
        return bad_input("its " + std::to_string(count) + " elements go beyond " + name + " of " +
                         std::to_string(view.bytes) + " bytes");
    }
    return Run{buffer.data() + view.offset + run.offset, stride};
}

Status GltfElements::open_sparse(const GltfDocument& document,
                                 const GltfBuffers& buffers,
                                 const GltfAccessor& accessor) {
    const GltfSparse& sparse = *accessor.sparse;
    if (sparse.indices.type != GltfNumber::U8 && sparse.indices.type != GltfNumber::U16 &&
        sparse.indices.type != GltfNumber::U32) {
        return bad_input("its sparse indices are not unsigned integers");
    }
    const std::uint64_t index_bytes = size_of(sparse.indices.type);
    const std::uint64_t element_bytes = size_of(accessor.type) * accessor.width;
    const Run indices =
        CD_TRY(open_run(document, buffers, sparse.indices, sparse.count, index_bytes, index_bytes));
    replacements_ = CD_TRY(
        open_run(document, buffers, sparse.values, sparse.count, element_bytes, element_bytes));
    for (std::uint64_t i = 0; i < sparse.count; ++i) {
        const auto element = static_cast<std::uint64_t>(
            load_number(sparse.indices.type, indices.first + i * indices.stride, false));
        if (element >= accessor.count || !replaced_.emplace(element, i).second) {
            return bad_input("its sparse index " + std::to_string(i) + " is " +
                             std::to_string(element) +
                             (element < accessor.count ? ", like an earlier one"
                                                       : ", of " + std::to_string(accessor.count)));
        }
    }
    return Done{};
}

Result<GltfElements>
GltfElements::open(const GltfDocument& document, const GltfBuffers& buffers, std::size_t number) {
    const GltfAccessor& accessor = document.accessors[number];
    const std::string place = "accessor " + std::to_string(number) + ": ";
    GltfElements elements;
    elements.count_ = accessor.count;
    elements.type_ = accessor.type;
    elements.is_normalized_ = accessor.is_normalized;
    const std::uint64_t element_bytes = size_of(accessor.type) * accessor.width;
    if (accessor.view) {
        const std::uint64_t stride = document.views[*accessor.view].stride;
        elements.base_ = CD_TRY(within(place,
                                       open_run(document,
                                                buffers,
                                                {*accessor.view, accessor.offset, accessor.type},
                                                accessor.count,
                                                stride == 0 ? element_bytes : stride,
                                                element_bytes)));
    } else if (accessor.count > buffers.size()) {
        return bad_input(place + "it counts " + std::to_string(accessor.count) +
                         " elements and has no bytes for them");
    }
    if (accessor.sparse) {
        CD_TRY(within(place, elements.open_sparse(document, buffers, accessor)));
    }
    return elements;
}

double GltfElements::at(std::uint64_t element, std::size_t component) const {
    const Run* run = &base_;
    if (!replaced_.empty()) {
        const auto found = replaced_.find(element);
        if (found != replaced_.end()) {
            run = &replacements_;
            element = found->second;
        }
    }
    if (run->first == nullptr) {
        return 0;
    }
    return load_number(
        type_, run->first + element * run->stride + component * size_of(type_), is_normalized_);
}

} // namespace cd
