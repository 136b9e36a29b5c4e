// The metrics of a master, read from its HTTP port.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/tls.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A sample of the text format of Prometheus.
struct MetricSample {
    std::string name;
    std::map<std::string, std::string, std::less<>> labels;
    double value = 0;

    /// The label's value; empty if there is none.
    [[nodiscard]] std::string label(std::string_view key) const;
};

/// Parses a page of metrics; skips comments. Errors: BadFrame naming the first line that is no
/// sample.
[[nodiscard]] Result<std::vector<MetricSample>> parse_metrics(std::string_view text);

/// The metrics of a master at one moment.
struct MasterMetrics {
    std::vector<MetricSample> samples;

    [[nodiscard]] std::vector<const MetricSample*> all(std::string_view name) const;
    /// The value of the only sample of this name; empty if there is none.
    [[nodiscard]] std::optional<double> value(std::string_view name) const;
};

/// Reads /metrics; each step of it has the timeout. Errors: as `http_get` and `parse_metrics`.
[[nodiscard]] Result<MasterMetrics>
read_metrics(const Endpoint& http, std::shared_ptr<const Tls> tls, std::chrono::seconds timeout);

} // namespace cd
