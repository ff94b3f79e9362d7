#include "json_report.h"

#include "byte_sink.h"

namespace cdfr::command {

Json begin_report(const std::string& input, const std::string& unit) {
  Json report;
  report["schema"] = 1;
  if (!input.empty()) report["input"] = input;
  report["unit"] = unit;
  return report;
}

Json json_of(Vec3 value) { return Json::array({value.x, value.y, value.z}); }

Json json_of(const Box& box) {
  if (!(box.lo.x <= box.hi.x)) return nullptr;
  return {{"min", json_of(box.lo)}, {"max", json_of(box.hi)}};
}

std::string text_of(const Json& report) {
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void print_json(const Json& report) { print_text(text_of(report)); }

}  // namespace cdfr::command
