// Reads the numbers of a glTF accessor in place.
#pragma once

#include "client/import/gltf/gltf_buffers.hpp"
#include "client/import/gltf/gltf_document.hpp"

#include <cstdint>
#include <unordered_map>

namespace cd {

/// An accessor whose bytes are all present. Only the indices of sparse elements are unpacked, so
/// memory does not depend on the accessor's count.
class GltfElements {
  public:
    /// `document` and `buffers` have to outlive the result. Errors: BadInput naming the accessor,
    /// for one that goes beyond its view or buffer, or that has no view and more elements than the
    /// buffers have bytes.
    [[nodiscard]] static Result<GltfElements>
    open(const GltfDocument& document, const GltfBuffers& buffers, std::size_t accessor);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Returns one number of an element. Normalized integers become fractions.
    [[nodiscard]] double at(std::uint64_t element, std::size_t component) const;

  private:
    /// Consecutive elements, `stride` bytes apart; if `first` is null, all elements are zero.
    struct Run {
        const std::byte* first = nullptr;
        std::uint64_t stride = 0;
    };

    [[nodiscard]] static Result<Run> open_run(const GltfDocument& document,
                                              const GltfBuffers& buffers,
                                              const GltfRun& run,
                                              std::uint64_t count,
                                              std::uint64_t stride,
                                              std::uint64_t element_bytes);
    [[nodiscard]] Status open_sparse(const GltfDocument& document,
                                     const GltfBuffers& buffers,
                                     const GltfAccessor& accessor);

    std::uint64_t count_ = 0;
    GltfNumber type_ = GltfNumber::F32;
    bool is_normalized_ = false;
    Run base_;
    Run replacements_;
    std::unordered_map<std::uint64_t, std::uint64_t>
        replaced_; ///< For each sparse element: its position in `replacements_`.
};

} // namespace cd
