#include "field_report.h"

#include <array>

#include "audit_report.h"
#include "number_text.h"
#include "terminal_text.h"
#include "text_report.h"
#include "unit.h"

namespace cdfr::command {
namespace {

std::string hexadecimal(std::uint64_t number) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[number >> shift & 15U];
  return text;
}

Json levels_json(const Stats& stats) {
  Json levels = Json::array();
  for (const LevelStats& level : stats.levels) {
    levels.push_back({{"level", level.level},
                      {"cells", level.cells},
                      {"leaves", level.leaves},
                      {"entries_in", level.entries_in},
                      {"entries_pruned", level.entries_pruned},
                      {"entries_kept", level.entries_kept},
                      {"mean_list", level.mean_list}});
  }
  return levels;
}

std::string domain_text(const BuildOptions& options) {
  if (options.domain == Domain::box) return "box";
  return options.domain == Domain::interior ? "interior" : "band:" + short_text(options.band);
}

Json options_json(const BuildOptions& options) {
  return {{"max_triangles", options.max_triangles_per_leaf},
          {"max_level", options.max_level},
          {"margin", options.margin},
          {"gain", options.gain},
          {"sign", sign_text(options.sign)},
          {"lists", lists_text(options.lists)},
          {"domain", domain_text(options)}};
}

std::string box_text(const Box& box, const std::string& unit) {
  return short_text(box.lo) + " to " + short_text(box.hi) + after_number(unit);
}

std::vector<std::vector<std::string>> level_rows(const Stats& stats) {
  std::vector<std::vector<std::string>> rows{
      {"level", "cells", "leaves", "entries in", "pruned", "kept", "triangles a leaf"}};
  for (const LevelStats& level : stats.levels) {
    rows.push_back({std::to_string(level.level), count_text(level.cells), count_text(level.leaves),
                    count_text(level.entries_in), count_text(level.entries_pruned),
                    count_text(level.entries_kept), short_text(level.mean_list)});
  }
  return rows;
}

}  // namespace

Json begin_field_report(const std::string& name, const Input& input) {
  Json report = begin_report(name, input.unit);
  report["sign"] = sign_text(input.field.sign());
  report["audit"] = json_of(input.field.report());
  return report;
}

Json field_json(const std::string& name, const Input& input) {
  const Stats stats = input.field.stats();
  Json report = begin_report(name, input.unit);
  report["triangles"] = stats.triangles;
  report["vertices"] = stats.vertices;
  report["sign"] = sign_text(input.field.sign());
  report["audit"] = json_of(input.field.report());
  report["bounds"] = json_of(input.field.bounds());
  report["domain"] = json_of(input.field.domain());
  report["leaves"] = {{"inside", stats.inside_leaves},
                      {"surface", stats.surface_leaves},
                      {"outside", stats.outside_leaves},
                      {"undecided", stats.undecided_leaves}};
  report["levels"] = levels_json(stats);
  report["list"] = {{"mean", stats.mean_list}, {"p95", stats.p95_list}, {"max", stats.max_list}};
  report["entries"] = stats.entries;
  report["bytes"] = stats.bytes;
  report["checksum"] = hexadecimal(input.field.checksum());
  report["options"] = options_json(input.field.options());
  report["seconds"] = input.seconds;
  return report;
}

std::string field_text(const std::string& name, const Input& input) {
  const Stats stats = input.field.stats();
  const std::uint64_t leaves =
      stats.inside_leaves + stats.surface_leaves + stats.outside_leaves + stats.undecided_leaves;
  TextReport report(terminal_text(name));
  report.line("triangles", count_text(stats.triangles));
  report.line("vertices", count_text(stats.vertices));
  report.line("sign", sign_text(input.field.sign()));
  report.line("mesh", sign_reason(input.field.report()));
  const MeshReport& mesh = input.field.report();
  const std::string unit = after_number(input.unit);
  if (mesh.closed()) report.line("volume", short_text(mesh.volume) + (unit.empty() ? "" : unit + "^3"));
  report.line("area", short_text(mesh.area) + (unit.empty() ? "" : unit + "^2"));
  report.line("part", box_text(input.field.bounds(), input.unit));
  report.line("domain", box_text(input.field.domain(), input.unit));
  report.line(
      "leaves",
      count_text(leaves) + ": " + count_text(stats.inside_leaves) + " inside, " +
          count_text(stats.surface_leaves) + " at the surface, " + count_text(stats.outside_leaves) +
          " outside" +
          (stats.undecided_leaves == 0 ? "" : ", " + count_text(stats.undecided_leaves) + " undecided"));
  report.line("triangles a leaf", "mean " + short_text(stats.mean_list) + ", 95 % at most " +
                                      short_text(stats.p95_list) + ", all at most " +
                                      count_text(stats.max_list));
  report.line("memory", bytes_text(stats.bytes));
  report.line("checksum", hexadecimal(input.field.checksum()));
  report.line("time", seconds_text(input.seconds));
  report.blank();
  report.table(level_rows(stats));
  return report.text();
}

}  // namespace cdfr::command
