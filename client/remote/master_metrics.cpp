#include "client/remote/master_metrics.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "proto/channel/http/http_get.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

Error no_sample(std::string_view line) {
    return {ErrorCode::BadFrame, "'" + std::string(line.substr(0, 80)) + "' is no metric"};
}

/// Reads `key="value"` pairs up to the closing brace, and removes them from `line`. Returns false
/// if the text is none.
bool take_labels(std::string_view& line, MetricSample& sample) {
    while (!line.empty() && line.front() != '}') {
        const std::size_t equals = line.find("=\"");
        if (equals == std::string_view::npos) {
            return false;
        }
        const std::string key(line.substr(0, equals));
        line.remove_prefix(equals + 2);
        std::string value;
        while (!line.empty() && line.front() != '"') {
            if (line.front() == '\\' && line.size() > 1) {
                line.remove_prefix(1);
                value += line.front() == 'n' ? '\n' : line.front();
            } else {
                value += line.front();
            }
            line.remove_prefix(1);
        }
        if (line.empty()) {
            return false;
        }
        line.remove_prefix(1);
        if (line.starts_with(',')) {
            line.remove_prefix(1);
        }
        sample.labels[key] = std::move(value);
    }
    if (line.empty()) {
        return false;
    }
    line.remove_prefix(1);
    return true;
}

std::optional<double> metric_value(std::string_view text) {
    if (text == "+Inf" || text == "-Inf") {
        const double infinity = std::numeric_limits<double>::infinity();
        return text[0] == '-' ? -infinity : infinity;
    }
    return text == "NaN" ? std::nan("") : number_in<double>(text);
}

std::optional<MetricSample> sample_of(std::string_view line) {
    MetricSample sample;
    const std::size_t end = line.find_first_of("{ ");
    if (end == 0 || end == std::string_view::npos) {
        return std::nullopt;
    }
    sample.name = line.substr(0, end);
    const bool has_labels = line[end] == '{';
    line.remove_prefix(end + (has_labels ? 1 : 0));
    if ((has_labels && !take_labels(line, sample)) || !line.starts_with(' ')) {
        return std::nullopt;
    }
    line.remove_prefix(1);
    const auto value = metric_value(line.substr(0, line.find(' ')));
    sample.value = value.value_or(0);
    return value ? std::optional(std::move(sample)) : std::nullopt;
}

} // namespace

std::string MetricSample::label(std::string_view key) const {
    const auto found = labels.find(key);
    return found == labels.end() ? "" : found->second;
}

Result<std::vector<MetricSample>> parse_metrics(std::string_view text) {
    std::vector<MetricSample> samples;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.empty() || line.front() == '#') {
            continue;
        }
        auto sample = sample_of(line);
        if (!sample) {
            return no_sample(line);
        }
        samples.push_back(*std::move(sample));
    }
    return samples;
}

std::vector<const MetricSample*> MasterMetrics::all(std::string_view name) const {
    std::vector<const MetricSample*> found;
    for (const MetricSample& sample : samples) {
        if (sample.name == name) {
            found.push_back(&sample);
        }
    }
    return found;
}

std::optional<double> MasterMetrics::value(std::string_view name) const {
    const auto found = all(name);
    return found.size() == 1 ? std::optional(found.front()->value) : std::nullopt;
}

Result<MasterMetrics>
read_metrics(const Endpoint& http, std::shared_ptr<const Tls> tls, std::chrono::seconds timeout) {
    const std::string text = CD_TRY(http_get({http, "/metrics", std::move(tls)}, timeout));
    auto samples = CD_TRY(parse_metrics(text));
    return MasterMetrics{std::move(samples)};
}

} // namespace cd
