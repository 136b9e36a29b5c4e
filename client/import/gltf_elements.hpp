// The numbers of a glTF accessor, read where they stand.
#pragma once

#include "client/import/gltf_buffers.hpp"
#include "client/import/gltf_document.hpp"

#include <cstdint>
#include <span>
#include <unordered_map>

namespace cd {

/// An accessor whose bytes are all there. Nothing is unpacked but the places of sparse elements, so
/// it takes little memory whatever the file counts.
class GltfElements {
  public:
    /// Document and buffers have to outlive it. Errors: BadInput naming the accessor, for one that
    /// goes beyond its view or buffer, or that has neither a view nor as few elements as the
    /// buffers have bytes.
    [[nodiscard]] static Result<GltfElements>
    open(const GltfDocument& document, const GltfBuffers& buffers, std::size_t accessor);

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// The number as it is: normalized integers as fractions.
    [[nodiscard]] double at(std::uint64_t element, std::size_t component) const;

  private:
    /// Elements one after the other, `stride` bytes apart.
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
    std::unordered_map<std::uint64_t, std::uint64_t> replaced_; ///< Element to replacement.
};

} // namespace cd
