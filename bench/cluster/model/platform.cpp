#include "bench/cluster/model/platform.hpp"

#include <algorithm>

namespace cd::bench {

namespace {

namespace s4u = simgrid::s4u;

class PlatformBuilder {
  public:
    explicit PlatformBuilder(const ClusterSpec& spec)
        : spec_(spec), zone_(s4u::create_star_zone("cluster")) {}

    Platform build(double slow_ratio, std::uint32_t master_cores) {
        Platform platform;
        platform.master = add_computer("master", fast_speed, master_cores);
        add_loopback(platform.master);
        if (spec_.shared_cores != 0) {
            platform.workers.assign(spec_.fast_cores, {platform.master, 1});
            zone_->seal();
            return platform;
        }
        add_kind("fast", spec_.fast_cores, spec_.fast_cores_each, fast_speed, platform);
        add_kind(
            "slow", spec_.slow_cores, spec_.slow_cores_each, fast_speed / slow_ratio, platform);
        zone_->seal();
        return platform;
    }

  private:
    s4u::Host* add_computer(const std::string& name, double speed, std::uint32_t cores) {
        s4u::Host* host = zone_->create_host(name, speed)->set_core_count(static_cast<int>(cores));
        s4u::SplitDuplexLink* link =
            zone_->create_split_duplex_link(name + " link", spec_.bytes_per_second);
        link->set_latency(spec_.latency_seconds);
        link->seal();
        host->seal();
        zone_->add_route(host->get_netpoint(),
                         nullptr,
                         nullptr,
                         nullptr,
                         {{link, s4u::LinkInRoute::Direction::UP}},
                         true);
        return host;
    }

    /// Messages from the analysing cores to the master take no time.
    void add_loopback(s4u::Host* host) {
        s4u::Link* link = zone_->create_link("loopback", 1e12);
        link->set_latency(0)->set_sharing_policy(s4u::Link::SharingPolicy::FATPIPE)->seal();
        zone_->add_route(host->get_netpoint(),
                         host->get_netpoint(),
                         nullptr,
                         nullptr,
                         {s4u::LinkInRoute(link)},
                         true);
    }

    void add_kind(const std::string& kind,
                  std::uint32_t cores,
                  std::uint32_t cores_each,
                  double speed,
                  Platform& platform) {
        for (std::uint32_t first = 0; first < cores; first += cores_each) {
            const std::string name = kind + " " + std::to_string(first / cores_each);
            s4u::Host* host = add_computer(name, speed, cores_each);
            const std::uint32_t here = std::min(cores_each, cores - first);
            if (spec_.worker_per_computer) {
                platform.workers.push_back({host, here});
            } else {
                platform.workers.insert(platform.workers.end(), here, {host, 1});
            }
        }
    }

    const ClusterSpec& spec_;
    s4u::NetZone* zone_;
};

} // namespace

Platform build_platform(const ClusterSpec& spec, double slow_ratio, std::uint32_t master_cores) {
    return PlatformBuilder(spec).build(slow_ratio, master_cores);
}

} // namespace cd::bench
