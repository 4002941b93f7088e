#include "framework/report/page/page.hpp"

#include <fmt/format.h>

#include "framework/report/page/html.hpp"
#include "framework/report/run_json.hpp"

namespace stope::report {

std::string report_page(const ReportData& data) {
  std::string page = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">";
  page += fmt::format("<title>{}</title></head>\n<body><h1>{}</h1><p>{}: {}</p></body></html>\n",
                      escaped(data.plan.name), escaped(data.plan.name), end_name(data.record.end),
                      escaped(data.record.sentence));
  return page;
}

}  // namespace stope::report
