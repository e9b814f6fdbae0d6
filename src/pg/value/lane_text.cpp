#include "value/lane_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "frame/argument.hpp"

namespace streetgen::pg {

namespace {

constexpr std::pair<const char*, unsigned> turn_words[] = {{"reverse", turn::reverse},
                                                           {"sharp_left", turn::sharp_left},
                                                           {"left", turn::left},
                                                           {"slight_left", turn::slight_left},
                                                           {"merge_to_left", turn::merge_left},
                                                           {"through", turn::through},
                                                           {"merge_to_right", turn::merge_right},
                                                           {"slight_right", turn::slight_right},
                                                           {"right", turn::right},
                                                           {"sharp_right", turn::sharp_right}};

std::vector<std::string> parted(const std::string& text, char mark) {
  std::vector<std::string> words;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = text.find(mark, from);
    words.push_back(text.substr(from, to - from));
    if (to == std::string::npos) return words;
    from = to + 1;
  }
}

unsigned turns_of(const std::string& text, const std::string& what) {
  unsigned turns = 0;
  if (text.empty() || text == "none") return turns;
  for (const std::string& word : parted(text, ';')) {
    unsigned found = 0;
    for (const auto& [name, bit] : turn_words)
      if (word == name) found = bit;
    if (found == 0 && word != "none" && !word.empty())
      refuse_word(word, "turn" + what, "a movement of OSM's turn:lanes, such as left or through");
    turns |= found;
  }
  return turns;
}

double width_of(const std::string& text, const std::string& what) {
  if (text.empty()) return 0;
  char* end = nullptr;
  const double width = std::strtod(text.c_str(), &end);
  if (*end != '\0') refuse_word(text, "lane width" + what, "metres");
  return in_range(width, 0, 200, "lane width" + what);
}

}  // namespace

std::vector<LaneKind> read_kinds(const std::string& kinds, const std::string& what) {
  std::vector<LaneKind> read;
  if (kinds.empty()) return read;
  for (const std::string& kind : parted(kinds, '|'))
    read.push_back(word_of<LaneKind>(kind, what,
                                     {{"general", LaneKind::general},
                                      {"bus", LaneKind::bus},
                                      {"carpool", LaneKind::carpool},
                                      {"cycle", LaneKind::cycle},
                                      {"parking", LaneKind::parking},
                                      {"closed", LaneKind::closed}}));
  return read;
}

std::string kinds_text(const LaneKinds& kinds) {
  std::string text;
  for (const LaneKind kind : {LaneKind::general, LaneKind::bus, LaneKind::carpool, LaneKind::cycle})
    if (kinds[index_of(kind)])
      text += (text.empty() ? "" : "|") + std::string(lane_kind_name(kind));
  return text;
}

LaneKind lanes_for(const std::string& access) {
  for (const LaneKind kind : {LaneKind::bus, LaneKind::carpool, LaneKind::cycle})
    if (access == lane_kind_name(kind)) return kind;
  return access == "no" ? LaneKind::closed : LaneKind::general;
}

Turn read_turn(const std::string& word) {
  return word_of<Turn>(word, "turn of a turn restriction",
                       {{turn_name(Turn::through), Turn::through},
                        {turn_name(Turn::left), Turn::left},
                        {turn_name(Turn::right), Turn::right},
                        {turn_name(Turn::u_turn), Turn::u_turn}});
}

std::vector<LaneWish> read_lanes(int count, const std::string& kinds, const std::string& widths,
                                 const std::string& turns, KindWidths defaults,
                                 const std::string& what, LaneKind general_as) {
  std::vector<LaneWish> lanes(kinds.empty() ? count : 0);
  for (const LaneKind kind : read_kinds(kinds, "lane" + what)) lanes.emplace_back().kind = kind;
  std::vector<LaneWish*> all, driving;
  for (LaneWish& lane : lanes) {
    all.push_back(&lane);
    if (drives(lane.kind)) driving.push_back(&lane);
  }
  // The lanes that a list speaks of, a word each.
  const auto each = [&](const std::string& list, const auto& read) {
    if (list.empty() || !names_lanes(list, lanes)) return;
    const std::vector<std::string> words = parted(list, '|');
    const std::vector<LaneWish*>& named = words.size() == driving.size() ? driving : all;
    for (std::size_t i = 0; i < words.size(); ++i) read(*named[i], words[i]);
  };
  each(widths, [&](LaneWish& lane, const std::string& word) { lane.width = width_of(word, what); });
  each(turns, [&](LaneWish& lane, const std::string& word) { lane.turns = turns_of(word, what); });
  for (LaneWish& lane : lanes) {
    if (lane.width == 0 && (lane.kind == LaneKind::cycle || lane.kind == LaneKind::parking)) {
      lane.width = lane.kind == LaneKind::cycle ? defaults.cycle : defaults.parking;
      lane.yields = true;
    }
    if (lane.kind == LaneKind::general) lane.kind = general_as;
  }
  return lanes;
}

bool names_lanes(const std::string& list, const std::vector<LaneWish>& lanes) {
  const std::size_t words = parted(list, '|').size();
  const auto driving = std::count_if(lanes.begin(), lanes.end(),
                                     [](const LaneWish& lane) { return drives(lane.kind); });
  return words == lanes.size() || words == static_cast<std::size_t>(driving);
}

std::string turn_text(unsigned turns) {
  std::string text;
  for (const auto& [name, bit] : turn_words)
    if (turns & bit) text += (text.empty() ? "" : ";") + std::string(name);
  return text;
}

const char* lane_side_name(LaneSide side) {
  switch (side) {
    case LaneSide::left:
      return "left";
    case LaneSide::centre:
      return "centre";
    case LaneSide::right:
      return "right";
  }
  return "";
}

LaneSettings read_lane_settings(const char* order, const char* driving_side, double narrowest) {
  LaneSettings settings;
  settings.order = word_of<LaneOrder>(
      order, "lane_order",
      {{"left_first", LaneOrder::left_first}, {"right_first", LaneOrder::right_first}});
  settings.driving_side = word_of<DrivingSide>(
      driving_side, "driving_side", {{"right", DrivingSide::right}, {"left", DrivingSide::left}});
  settings.narrowest = in_range(narrowest, 0.01, 1000, "lane_width_minimal");
  return settings;
}

const char* lane_kind_name(LaneKind kind) {
  switch (kind) {
    case LaneKind::general:
      return "general";
    case LaneKind::bus:
      return "bus";
    case LaneKind::carpool:
      return "carpool";
    case LaneKind::cycle:
      return "cycle";
    case LaneKind::parking:
      return "parking";
    case LaneKind::merging:
      return "merging";
    case LaneKind::closed:
      return "closed";
  }
  return "";
}

}  // namespace streetgen::pg
