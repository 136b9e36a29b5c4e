#include "web/server/page_server.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/timing/web.hpp"
#include "web/server/page_arrays.hpp"
#include "web/server/page_assets.hpp"
#include "web/server/page_json.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

namespace cd {

namespace {

constexpr std::string_view json_type = "application/json";
constexpr std::string_view bytes_type = "application/octet-stream";
constexpr std::string_view bearer = "Bearer ";

HttpAnswer json_answer(unsigned status, std::string json) {
    return {status, std::move(json), std::string(json_type), {{"Cache-Control", "no-store"}}};
}

HttpAnswer json_answer(std::string json) {
    return json_answer(200, std::move(json));
}

HttpAnswer refusal(unsigned status, const std::string& why) {
    return json_answer(status, error_json(why));
}

HttpAnswer array_answer(Bytes npy) {
    return {200,
            "",
            std::string(bytes_type),
            {{"Cache-Control", "no-store"}},
            make_memory_body(std::move(npy))};
}

HttpAnswer array_answer(BoundedArray array) {
    HttpAnswer answer = array_answer(std::move(array.npy));
    if (array.is_cut) {
        answer.headers.emplace_back("X-Cut", "true");
    }
    return answer;
}

HttpAnswer mesh_answer(std::shared_ptr<HttpBody> body) {
    return {200,
            "",
            std::string(bytes_type),
            {{"Cache-Control", "private, max-age=31536000, immutable"}},
            std::move(body)};
}

/// True if a header's list of values, or an ETag list, has a value.
bool lists(std::string_view header, std::string_view value) {
    while (!header.empty()) {
        std::string_view each = header.substr(0, header.find(','));
        header.remove_prefix(std::min(each.size() + 1, header.size()));
        each.remove_prefix(std::min(each.find_first_not_of(' '), each.size()));
        each = each.substr(0, each.find_first_of("; "));
        if (each == value) {
            return true;
        }
    }
    return false;
}

HttpAnswer asset_answer(const PageAsset& asset, const HttpRequest& request) {
    const bool packs = lists(request.accept_encoding, "gzip");
    HttpAnswer answer{200, "", std::string(asset.content_type)};
    answer.headers = {
        {"ETag", asset.etag}, {"Cache-Control", "no-cache"}, {"Vary", "Accept-Encoding"}};
    if (lists(request.if_none_match, asset.etag)) {
        answer.status = 304;
        return answer;
    }
    if (packs) {
        answer.headers.emplace_back("Content-Encoding", "gzip");
    }
    answer.content = make_memory_body(packs ? asset.gzip : asset.bytes, nullptr);
    return answer;
}

/// Makes a `Take` that answers with what `encode` makes of the value.
template <class T, class Encode>
Take<T> answering(HttpRespond respond, Encode encode) {
    return [respond = std::move(respond), encode](Result<T> found) {
        respond(found ? encode(found.value()) : error_answer(found.error()));
    };
}

PageRight right_of(PageTopic topic) {
    switch (topic) {
    case PageTopic::Source:
        return PageRight::Nothing;
    case PageTopic::Cluster:
    case PageTopic::History:
    case PageTopic::Jobs:
        return PageRight::Cluster;
    default:
        return PageRight::Jobs;
    }
}

/// Returns the name in a Host header, without the port.
std::string_view host_name(std::string_view host) {
    if (host.starts_with('[')) {
        const std::size_t end = host.find(']');
        return end == std::string_view::npos ? host : host.substr(0, end + 1);
    }
    return host.substr(0, host.find(':'));
}

bool is_equal_ignoring_case(std::string_view left, std::string_view right) {
    const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::ranges::equal(left, right, {}, lower, lower);
}

Sha256 hash_of(std::string_view text) {
    return sha256(std::as_bytes(std::span(text)));
}

} // namespace

HttpAnswer error_answer(const Error& error) {
    switch (error.code) {
    case ErrorCode::NotFound:
        return refusal(404, error.detail);
    case ErrorCode::BadInput:
        return refusal(400, error.detail);
    case ErrorCode::Refused:
        return refusal(403, error.detail);
    default:
        return refusal(503, error.detail);
    }
}

bool PageServer::is_own_host(std::string_view host) const {
    constexpr std::array<std::string_view, 4> own{"127.0.0.1", "[::1]", "localhost", "master"};
    const std::string_view name = host_name(host);
    const auto is_name = [&](std::string_view each) { return is_equal_ignoring_case(each, name); };
    return std::ranges::any_of(own, is_name) || std::ranges::any_of(options_.host_names, is_name);
}

bool PageServer::has_key(const HttpRequest& request) const {
    if (!options_.key) {
        return true;
    }
    const std::string_view shown = request.authorization;
    const bool is_bearer = shown.starts_with(bearer);
    // Hashes have one length, so that the comparison takes the same time for any text.
    return is_equal_secret(hash_of(is_bearer ? shown.substr(bearer.size()) : ""),
                           hash_of(*options_.key));
}

void PageServer::refuse_late(HttpRespond respond) {
    const auto timer = std::make_shared<asio::steady_timer>(executor_, timing::wrong_key_delay);
    timer->async_wait([timer, respond = std::move(respond)](const auto&) {
        respond(refusal(401, "this needs the key: open the address that `cdctl view` printed"));
    });
}

void PageServer::answer(const HttpRequest& request, const PageAccess& access, HttpRespond respond) {
    if (request.method != "GET" && request.method != "HEAD") {
        return respond(refusal(405, "only GET and HEAD"));
    }
    if (!is_own_host(request.host)) {
        return respond(refusal(421,
                               "this server is not '" + request.host +
                                   "'; cdmaster --http-name gives it a further name"));
    }
    const std::string_view path =
        std::string_view(request.target).substr(0, request.target.find('?'));
    const auto assets = page_assets();
    const auto asset = std::ranges::find(assets, path, &PageAsset::path);
    if (asset != assets.end()) {
        return respond(asset_answer(*asset, request));
    }
    answer_api(request, access, std::move(respond));
}

void PageServer::answer_api(const HttpRequest& request,
                            const PageAccess& access,
                            HttpRespond respond) {
    if (!has_key(request)) {
        return refuse_late(std::move(respond));
    }
    const Result<PageRequest> parsed = parse_page_request(request.target);
    if (!parsed) {
        return respond(error_answer(parsed.error()));
    }
    if (const Status allowed = access(right_of(parsed.value().topic)); !allowed) {
        return respond(error_answer(allowed.error()));
    }
    ask(parsed.value(), std::move(respond));
}

void PageServer::ask(const PageRequest& request, HttpRespond respond) {
    using Viewed = std::shared_ptr<const ScenarioView>;
    using Parts = std::shared_ptr<const NamedParts>;
    const auto array = [](auto encode) {
        return [encode](const auto& values) { return array_answer(encode(values)); };
    };
    const auto json = [](auto encode) {
        return [encode](const auto& value) { return json_answer(encode(value)); };
    };
    const auto rows = [&](auto encode) {
        return answering<Viewed>(respond, [encode](const Viewed& scenario) {
            return array_answer(
                encode(scenario->drawn != nullptr ? *scenario->drawn : ScenarioResult()));
        });
    };
    switch (request.topic) {
    case PageTopic::Source:
        return respond(json_answer(origin_json(source_.origin())));
    case PageTopic::Cluster:
        return source_.cluster(answering<ClusterView>(respond, json(cluster_json)));
    case PageTopic::History:
        return source_.history(answering<std::vector<HistorySample>>(respond, json(history_json)));
    case PageTopic::Jobs:
        return source_.jobs(answering<std::vector<JobRow>>(respond, json(jobs_json)));
    case PageTopic::Job:
        return source_.job(request.job, answering<JobView>(respond, json(job_view_json)));
    case PageTopic::Progress:
        return source_.progress(request.job, answering<JobRow>(respond, json(progress_json)));
    case PageTopic::Classes:
        return source_.classes(request.job,
                               request.choice,
                               answering<std::vector<std::uint8_t>>(respond, array(classes_npy)));
    case PageTopic::Counts:
        return source_.counts(request.job,
                              request.choice,
                              answering<std::vector<std::uint32_t>>(respond, array(counts_npy)));
    case PageTopic::Distances:
        return source_.distances(request.job,
                                 request.choice,
                                 answering<std::vector<double>>(respond, array(distances_npy)));
    case PageTopic::Poses:
        return source_.poses(
            request.job, request.choice, answering<PoseRows>(respond, array(poses_npy)));
    case PageTopic::Keys:
        return source_.keys(request.job,
                            request.choice,
                            answering<std::vector<MotionKeys>>(respond, array(keys_npy)));
    case PageTopic::Bodies:
        return source_.bodies(request.job,
                              request.choice,
                              answering<std::vector<ScenePlace>>(respond, array(bodies_npy)));
    case PageTopic::Steps:
        return source_.steps(request.job,
                             request.choice,
                             answering<std::vector<StepRow>>(respond, array(steps_npy)));
    case PageTopic::Map:
        return source_.map(request.job,
                           request.number,
                           answering<std::vector<TriangleContacts>>(respond, array(map_npy)));
    case PageTopic::Parts:
        return source_.parts(
            request.job, request.number, answering<Parts>(respond, [](const Parts& parts) {
                return array_answer(parts_npy(parts->runs));
            }));
    case PageTopic::PartNames:
        return source_.parts(
            request.job, request.number, answering<Parts>(respond, [](const Parts& parts) {
                return json_answer(part_names_json(parts->names));
            }));
    case PageTopic::ClosedParts:
        return source_.closed_parts(
            request.job, request.number, answering<std::vector<bool>>(respond, array(closed_npy)));
    case PageTopic::Scenario:
        return source_.scenario(
            request.job,
            request.number,
            answering<Viewed>(respond, [number = request.number](const Viewed& scenario) {
                return json_answer(scenario_json(number, *scenario));
            }));
    case PageTopic::Pairs:
        return source_.scenario(request.job, request.number, rows(pairs_npy));
    case PageTopic::Points:
        return source_.scenario(request.job, request.number, rows(points_npy));
    case PageTopic::Hits:
        return source_.scenario(request.job, request.number, rows(hits_npy));
    case PageTopic::Next:
        return source_.next(
            request.job, request.next, answering<NextFound>(respond, json(next_json)));
    case PageTopic::Mesh:
        return source_.mesh(request.mesh,
                            answering<std::shared_ptr<HttpBody>>(respond, mesh_answer));
    }
}

} // namespace cd
