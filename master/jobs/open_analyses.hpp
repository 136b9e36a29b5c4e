// Analysed scenarios of a job whose results are not merged yet.
#pragma once

#include "master/compute/analyser.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>

namespace cd {

/// Holds the analyses by position in the job's hand-out order, and their approximate memory.
class OpenAnalyses {
  public:
    /// The scenario must not have an open analysis.
    const Analysis& add(Analysis analysis) {
        bytes_ += analysis.bytes;
        const std::uint64_t position = analysis.position;
        return *all_.emplace(position, std::make_shared<const Analysis>(std::move(analysis)))
                    .first->second;
    }
    /// Frees the analysis of a scenario that has a result, if its analysis is open.
    void close(std::uint64_t position) {
        if (const auto found = all_.find(position); found != all_.end()) {
            bytes_ -= found->second->bytes;
            all_.erase(found);
        }
    }
    /// Null if the scenario has no open analysis.
    [[nodiscard]] std::shared_ptr<const Analysis> find(std::uint64_t position) const {
        const auto found = all_.find(position);
        return found == all_.end() ? nullptr : found->second;
    }
    [[nodiscard]] bool has(std::uint64_t position) const { return all_.contains(position); }
    /// Approximate memory of all open analyses: the sum of their `Analysis::bytes`.
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] const auto& all() const { return all_; }

  private:
    std::unordered_map<std::uint64_t, std::shared_ptr<const Analysis>> all_;
    std::uint64_t bytes_ = 0;
};

} // namespace cd
