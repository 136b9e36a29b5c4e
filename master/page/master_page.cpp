#include "master/page/master_page.hpp"

#include "common/core/timing/web.hpp"
#include "common/core/version.hpp"

#include <utility>

namespace cd {

namespace {

PageOrigin origin_of_master(bool is_tls) {
    boost::system::error_code ignored;
    PageOrigin origin;
    origin.kind = PageOrigin::Kind::Master;
    origin.program = "cdmaster " + std::string(version);
    origin.name = asio::ip::host_name(ignored);
    origin.is_tls = is_tls;
    return origin;
}

Status check_right(const Access& access, PageRight right) {
    if (right == PageRight::Nothing) {
        return Done{};
    }
    const Status allowed =
        access.check(right == PageRight::Cluster ? Message(StatusQuery{}) : Message(JobQuery{}));
    return allowed ? allowed
                   : Error{allowed.error().code,
                           allowed.error().detail +
                               "; open the page with: cdctl view [JOB] --master HOST:PORT"};
}

} // namespace

MasterPage::MasterPage(Coordinator& coordinator, std::vector<std::string> host_names, bool is_tls)
    : reader_(coordinator),
      source_({coordinator.parts().executor,
               reader_,
               reading_,
               coordinator.parts().compute,
               timing::page_run_max},
              origin_of_master(is_tls)),
      server_(coordinator.parts().executor, source_, {std::move(host_names)}) {}

void MasterPage::answer(const HttpRequest& request, const Access& access, HttpRespond respond) {
    server_.answer(
        request,
        [&access](PageRight right) { return check_right(access, right); },
        std::move(respond));
}

} // namespace cd
