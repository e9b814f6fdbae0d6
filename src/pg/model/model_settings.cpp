#include "model/model_settings.hpp"

#include <cstdlib>
#include <limits>
#include <sstream>

#include "value/lane_text.hpp"

namespace streetgen::pg {

Settings::Settings(const StreetsCall& call) {
  for (int i = 0; i < call.settings.count; ++i)
    if (call.settings.values[i] != nullptr)
      values_[call.settings.names[i]] = call.settings.values[i];
}

double Settings::measure(const char* name, double low, double high) const {
  const std::string& text = word(name);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0')
    throw Error(ErrorKind::invalid_input,
                "setting " + std::string(name) + " is \"" + text + "\", expected a number");
  return in_range(value, low, high, "setting " + std::string(name));
}

double Settings::measure_or_unbounded(const char* name) const {
  return is_given(name) ? measure(name, 0, 1e6) : std::numeric_limits<double>::infinity();
}

std::map<double, double> Settings::steps(const char* name) const {
  const std::string what = "setting " + std::string(name);
  std::map<double, double> steps;
  std::istringstream text(word(name));
  char mark = 0;
  const auto expect = [&](char wanted) {
    if (!(text >> mark) || mark != wanted)
      throw Error(ErrorKind::invalid_input, what + " is no JSON object of number to number");
  };
  const auto number = [&] {
    double value = 0;
    if (!(text >> value))
      throw Error(ErrorKind::invalid_input, what + " is no JSON object of number to number");
    return in_range(value, 0, 1000, what);
  };
  expect('{');
  do {
    expect('"');
    const double from = number();
    expect('"');
    expect(':');
    steps[from] = number();
  } while (text >> mark && mark == ',');
  if (mark != '}')
    throw Error(ErrorKind::invalid_input, what + " is no JSON object of number to number");
  return steps;
}

const std::string& Settings::word(const char* name) const {
  const auto found = values_.find(name);
  if (found == values_.end())
    throw Error(ErrorKind::invalid_input, "setting " + std::string(name) + " has no value");
  return found->second;
}

TransitionKind transition_kind_of(const std::string& word) {
  return word_of<TransitionKind>(word, "transition_kind",
                                 {{"symmetric", TransitionKind::symmetric},
                                  {"left", TransitionKind::left},
                                  {"right", TransitionKind::right}});
}

ControlRules control_rules_of(const Settings& given) {
  return {given.measure("control_distance"), given.measure("queue_length")};
}

StreetSettings street_settings_of(const Settings& given) {
  StreetSettings settings;
  settings.controls = control_rules_of(given);
  settings.tolerance = given.measure("tolerance", 1e-6);
  settings.crossing =
      given.choice<Crossing>("crossing", {{"over", Crossing::over}, {"split", Crossing::split}});
  if (given.choice<bool>("smoothing", {{"none", false}, {"arcs", true}}))
    settings.smoothing = Smoothing{given.measure("smoothing_shift", 1e-6),
                                   given.measure("smoothing_tolerance", 1e-6)};
  settings.ring_shift = given.measure("ring_shift");
  settings.max_arc_distance = given.measure("max_arc_distance");
  settings.radius_minimal = given.measure("radius_minimal");
  settings.transition = {transition_kind_of(given.word("transition_kind"))};
  if (given.is_given("transition_length"))
    settings.transition.length = given.measure("transition_length");
  settings.taper_ratio = given.steps("taper_ratio");
  settings.radius_rule = given.choice<RadiusRule>("radius_rule", {{"min", RadiusRule::min},
                                                                  {"max", RadiusRule::max},
                                                                  {"mean", RadiusRule::mean},
                                                                  {"major", RadiusRule::major}});
  settings.round_dead_ends = given.choice<bool>("dead_end", {{"flat", false}, {"round", true}});
  settings.max_hole_area = given.measure("max_hole_area");
  settings.slit_width = given.measure("slit_width");
  settings.overlaps_maximal = static_cast<int>(given.measure("overlaps_maximal", 1));
  settings.kerb_stone_width = given.measure("kerb_stone_width");
  settings.reach = given.measure("reach");
  settings.corner_length = given.measure_or_unbounded("corner_length");
  settings.corner_area = given.measure_or_unbounded("corner_area");
  settings.limit_distance = given.measure_or_unbounded("limit_distance");
  settings.follow_length = given.measure_or_unbounded("follow_length");
  settings.follow_area = given.measure_or_unbounded("follow_area");
  settings.median_width_minimal = given.measure("median_width_minimal", 1e-6);
  settings.median_width_maximal = given.measure("median_width_maximal");
  settings.island_area = given.measure("island_area", 0, 1e6);
  settings.island_area_minimal = given.measure("island_area_minimal");
  settings.island_nose_radius = given.measure("island_nose_radius", 1e-6);
  settings.kerb_radius_minimal = given.measure_or_none("kerb_radius_minimal");
  settings.short_axis = given.choice<ShortAxis>(
      "short_axis", {{"reduce", ShortAxis::reduce}, {"follow", ShortAxis::follow}});
  return settings;
}

LaneSettings lane_settings_of(const Settings& given) {
  // Until an import tells otherwise.
  const std::string side =
      given.word("driving_side") == "auto" ? "right" : given.word("driving_side");
  LaneSettings settings = read_lane_settings(given.word("lane_order").c_str(), side.c_str(),
                                             given.measure("lane_width_minimal"));
  settings.edge_lines = given.choice<bool>("edge_line", {{"none", false}, {"solid", true}});
  settings.kerb_radius_minimal = given.measure_or_none("kerb_radius_minimal");
  settings.controls = control_rules_of(given);
  settings.line_before_kerb = given.measure("line_before_kerb");
  return settings;
}

InterconnectionSettings interconnection_settings_of(const Settings& given) {
  InterconnectionSettings settings;
  settings.u_turn = given.choice<bool>("u_turn", {{"true", true}, {"false", false}});
  settings.rule = given.choice<TrajectoryRule>(
      "trajectory", {{"bezier", TrajectoryRule::bezier}, {"arcs", TrajectoryRule::arcs}});
  settings.tolerance = given.measure("trajectory_tolerance", 1e-3);
  settings.least_radius = given.measure("trajectory_radius");
  settings.most = static_cast<int>(given.measure("interconnections_maximal", 0, 1e6));
  settings.node_tolerance = given.measure("tolerance", 1e-6);
  settings.look_ahead = given.measure("look_ahead");
  settings.driving_side = lane_settings_of(given).driving_side;
  return settings;
}

}  // namespace streetgen::pg
