#include "osm/lane_list.hpp"

#include <algorithm>
#include <set>

#include "osm/way_access.hpp"
#include "streetgen/measure_text.hpp"

namespace streetgen {

namespace {

// Metres that anybody would believe.
struct WidthRange {
  double least, most;
};
constexpr WidthRange of_cycle_lane{0.5, 4}, of_parking_lane{1, 7}, of_other_lane{1.5, 8};

constexpr const char* list_names[] = {"turn",          "change",   "width",   "access", "vehicle",
                                      "motor_vehicle", "motorcar", "bus",     "psv",    "taxi",
                                      "hov",           "bicycle",  "cycleway"};

// Lists of cars: the first that has a word speaks of them most closely.
constexpr const char* car_names[] = {"motorcar", "motor_vehicle", "vehicle", "access"};

bool reserved(const std::string& word) {
  return word == "designated" || word == "official" || word == "lane";
}
bool open(const std::string& word) {
  return reserved(word) || word == "yes" || word == "permissive";
}
bool lane_of_cycles(const std::string& word) {
  return word == "lane" || word == "exclusive" || word == "advisory" || word == "designated" ||
         word == "soft_lane";
}

}  // namespace

std::optional<double> lane_width_of(const std::string& word, LaneKind kind) {
  const WidthRange believed = kind == LaneKind::cycle     ? of_cycle_lane
                              : kind == LaneKind::parking ? of_parking_lane
                                                          : of_other_lane;
  const std::optional<double> width = read_metres(word);
  return width >= believed.least && width <= believed.most ? width : std::nullopt;
}

bool speaks_of_each_direction(const std::string& list, const WayTags& tags) {
  return !tags.one_way() && !tags.takes_turns() &&
         tags.value("lanes") == std::to_string(2 * parted_list(list).size());
}

LaneLists::LaneLists(WayTags& tags, Heading heading) : heading_(heading) {
  for (const std::string name : list_names) {
    std::string key = tags.said_of(name + ":lanes", heading), list = tags.value(key);
    if (list.empty() && speaks_of_each_direction(tags.value(name + ":lanes"), tags)) {
      key = name + ":lanes";
      list = tags.value(key);
    }
    if (list.empty()) continue;
    std::vector<std::string> words = parted_list(list);
    if (words.size() > 30) {
      tags.name(key, "it lists more than 30 lanes");
      continue;
    }
    lists_.push_back({key, std::move(words)});
    names_.push_back(name);
  }
}

int LaneLists::Reading::of_motor_traffic() const {
  return static_cast<int>(std::count_if(kinds.begin(), kinds.end(), [](LaneKind kind) {
    return drives(kind) || kind == LaneKind::closed;
  }));
}

std::string LaneLists::word(const std::string& name, std::size_t length, std::size_t lane) const {
  for (std::size_t i = 0; i < lists_.size(); ++i)
    if (names_[i] == name && lists_[i].words.size() == length) return lists_[i].words[lane];
  return {};
}

void LaneLists::name_word_of_cars(std::size_t length, std::size_t lane, const char* reason,
                                  WayTags& tags) const {
  for (const char* name : car_names)
    for (std::size_t i = 0; i < lists_.size(); ++i)
      if (names_[i] == name && lists_[i].words.size() == length && !lists_[i].words[lane].empty())
        return tags.name(lists_[i].key, reason);
}

LaneLists::Mark LaneLists::mark(std::size_t length, std::size_t lane, WayTags& tags) const {
  const auto said = [&](const char* name) { return word(name, length, lane); };
  std::string cars;
  for (const char* name : car_names)
    if (cars.empty()) cars = said(name);
  const Access of_cars = access_of(cars);
  const std::string bus = said("bus"), psv = said("psv"), taxi = said("taxi"),
                    bicycle = said("bicycle");
  if (reserved(said("hov")) || of_cars == Access::carpool) return Mark::carpool;
  if (reserved(bus) || reserved(psv) || reserved(taxi) || of_cars == Access::bus) return Mark::bus;
  const bool closed = shuts_cars_out(of_cars) || of_cars == Access::cycle;
  if (closed && (reserved(bicycle) || of_cars == Access::cycle)) return Mark::cycle;
  if (closed && (open(bus) || open(psv) || open(taxi))) return Mark::bus;
  if (lane_of_cycles(said("cycleway")) || bicycle == "lane") return Mark::cycle;
  if (closed && open(bicycle)) return Mark::cycle;
  if (closed) {
    if (lets_buses_in(Heading::along, tags) || lets_buses_in(Heading::against, tags))
      return Mark::bus;
    name_word_of_cars(length, lane, "nothing says who may drive on a lane that is closed to cars",
                      tags);
    return Mark::closed;
  }
  if (lets_cars_end(of_cars))
    name_word_of_cars(length, lane, "the lane is open to all cars: those that end there have none",
                      tags);
  return reserved(bicycle) ? Mark::maybe_cycle : Mark::general;
}

std::vector<LaneLists::Reading> LaneLists::readings(KerbCycles kerbs, WayTags& tags) const {
  std::set<std::size_t, std::greater<>> lengths;
  for (const List& list : lists_) lengths.insert(list.words.size());
  std::vector<Reading> found;
  for (const std::size_t length : lengths) {
    Reading strict, shared;
    bool doubtful = false;
    for (std::size_t lane = 0; lane < length; ++lane) {
      const Mark said = mark(length, lane, tags);
      const LaneKind kind = said == Mark::bus       ? LaneKind::bus
                            : said == Mark::carpool ? LaneKind::carpool
                            : said == Mark::closed  ? LaneKind::closed
                            : said == Mark::general ? LaneKind::general
                                                    : LaneKind::cycle;
      doubtful |= said == Mark::maybe_cycle;
      strict.kinds.push_back(kind);
      shared.kinds.push_back(said == Mark::maybe_cycle ? LaneKind::general : kind);
    }
    strict.counted = strict.of_motor_traffic();
    shared.counted = shared.of_motor_traffic();
    // A direction is not for bicycles alone where nothing closes it to cars.
    if (!(doubtful && strict.counted == 0 && heading_ == Heading::along)) found.push_back(strict);
    shared.supposed = true;
    if (doubtful) found.push_back(shared);
    Reading careless = strict;
    careless.counted = static_cast<int>(length);
    careless.disagrees = careless.supposed = true;
    if (careless.counted != strict.counted && !doubtful) found.push_back(careless);
    if (careless.counted != strict.counted) continue;
    Reading kerbside = strict;
    if (kerbs.at_left) kerbside.kinds.front() = LaneKind::cycle;
    if (kerbs.at_right) kerbside.kinds.back() = LaneKind::cycle;
    kerbside.counted = kerbside.of_motor_traffic();
    kerbside.supposed = true;
    if (kerbside.counted > 0 && kerbside.counted < strict.counted) found.push_back(kerbside);
  }
  return found;
}

bool LaneLists::say_who() const {
  for (std::size_t i = 0; i < lists_.size(); ++i)
    for (const char* name : {"bus", "psv", "taxi", "bicycle", "cycleway"})
      if (names_[i] == name && std::any_of(lists_[i].words.begin(), lists_[i].words.end(), open))
        return true;
  return false;
}

}  // namespace streetgen
