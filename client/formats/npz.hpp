// Writes NumPy's .npz: a zip of .npy files.
#pragma once

#include "client/formats/array_file.hpp"
#include "common/core/host/stop_check.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// Writes an archive whose arrays grow in pieces, without holding them in memory: each array is
/// spooled to a file beside the target.
class NpzWriter final : public ArrayFile {
  public:
    /// `stop` interrupts `finish`, which takes long since it compresses all arrays.
    explicit NpzWriter(std::filesystem::path path, StopCheck stop = {})
        : ArrayFile(std::move(path)), stop_(std::move(stop)) {}
    /// Removes the spool files.
    ~NpzWriter() override;

    [[nodiscard]] std::size_t add_array(const ArrayLayout& layout) override;
    [[nodiscard]] Status finish() override;

  private:
    struct Array {
        ArrayLayout layout;
        std::filesystem::path spool = {};
        std::ofstream file = {};
        Bytes waiting = {};         ///< Elements that are not in `file` yet.
        std::uint64_t elements = 0; ///< Also those that wait.
    };

    [[nodiscard]] Status
    append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item) override;
    [[nodiscard]] bool is_stopped() const { return stop_ && stop_(); }
    [[nodiscard]] Status spool(Array& array) const;
    void remove_spools();

    StopCheck stop_;
    std::vector<Array> arrays_;
};

} // namespace cd
