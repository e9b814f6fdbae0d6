#include "osm/side_strips.hpp"

#include "streetgen/measure_text.hpp"

namespace streetgen {

namespace {

// A green strip wider than that is a field.
constexpr double widest_strip = 19.5;  // metres
constexpr std::initializer_list<const char*> track_words = {"track", "opposite_track"};
constexpr std::initializer_list<const char*> lane_words = {"lane", "soft_lane", "opposite_lane"};
constexpr std::initializer_list<const char*> on_roadway = {
    "solid_line", "dashed_line", "double_solid_line", "barred_area",    "surface",
    "bump",       "studs",       "flex_post",         "vertical_panel", "cone",
    "bollard",    "planter",     "jersey_barrier",    "parking_lane",   "separation_kerb"};
constexpr std::initializer_list<const char*> on_verge = {"grass_verge", "tree_row", "hedge",
                                                         "ditch", "greenery"};
constexpr std::initializer_list<const char*> yes = {"yes", "true"};
constexpr std::initializer_list<const char*> no = {"no", "none", "false", "0"};

// Of a lane and a track in one value the lane counts.
std::string track_word(const std::string& said) {
  return word_among(word_among(said, lane_words), track_words);
}

// The keys of a side, from its own to that of the way.
std::vector<std::string> keys_of(const std::string& base, RoadSide kerb, const std::string& end,
                                 const WayTags& tags) {
  return {tags.key_of(base, kerb) + end, base + ":both" + end, base + end};
}

std::string first_said(const std::vector<std::string>& keys, const WayTags& tags) {
  for (const std::string& key : keys)
    if (!tags.value(key).empty()) return key;
  return "";
}

// What lies beside a track: towards the lanes, or towards who walks.  A key without a side speaks
// of the lanes.
enum class TrackSide { lanes, walk };

std::vector<std::string> ends_of(const std::string& base, RoadSide kerb, TrackSide side,
                                 const WayTags& tags) {
  const RoadSide other = kerb == RoadSide::near ? RoadSide::far : RoadSide::near;
  if (side == TrackSide::walk) return {base + tags.key_of("", kerb), base + ":both"};
  return {base + tags.key_of("", other), base + ":both", base};
}

bool parted_by(RoadSide kerb, TrackSide side, std::initializer_list<const char*> words,
               const WayTags& tags) {
  for (const std::string& end : ends_of(":separation", kerb, side, tags))
    for (const std::string& key : keys_of("cycleway", kerb, end, tags))
      if (is_among(word_among(tags.value(key), words), words)) return true;
  return false;
}

std::optional<double> metres_of(const std::string& key, WayTags& tags) {
  const std::optional<double> metres = read_metres(tags.value(key));
  if (metres && *metres >= 0.1 && *metres <= widest_strip) return metres;
  tags.name(key, "it is no width of a strip");
  return std::nullopt;
}

// A key without a side speaks of the sides that have what it tells of, of both if none has.
bool speaks_of_side(const std::string& key, RoadSide kerb, const std::string& base, bool any_has,
                    const WayTags& tags) {
  return key.rfind(base + ":both", 0) == 0 || key.rfind(tags.key_of(base, kerb), 0) == 0 ||
         (!key.empty() && !any_has);
}

bool any_verge(const WayTags& tags) {
  for (const char* key : {"verge", "verge:both", "verge:left", "verge:right"})
    if (const std::string said = tags.value(key); !said.empty() && !is_among(said, no)) return true;
  return false;
}

void add_verge(RoadSide kerb, bool by_track, std::vector<SideStrip>& strips, WayTags& tags) {
  const std::string own = first_said({tags.key_of("verge", kerb), "verge:both"}, tags);
  const std::string said = tags.value(own.empty() ? "verge" : own);
  bool there = by_track;
  if (own.empty() && is_among(said, {"left", "right", "both"}))
    there |= said == "both" || tags.key_of("verge", kerb) == "verge:" + said;
  else if (said == "separate")
    tags.name(own.empty() ? "verge" : own, "the source draws the verge apart from the street");
  else if (!said.empty() && !is_among(said, no))
    there = true;
  const std::string wide = first_said(keys_of("verge", kerb, ":width", tags), tags);
  if (!there) {
    if (speaks_of_side(wide, kerb, "verge", any_verge(tags), tags))
      tags.name(wide, "no verge is there");
    return;
  }
  strips.push_back({SideStripKind::verge, wide.empty() ? std::nullopt : metres_of(wide, tags)});
}

void add_buffer(RoadSide kerb, TrackSide side, std::vector<SideStrip>& strips, WayTags& tags) {
  std::vector<std::string> keys;
  for (const std::string& end : ends_of(":buffer", kerb, side, tags))
    for (const std::string& key : keys_of("cycleway", kerb, end, tags)) keys.push_back(key);
  const std::string key = first_said(keys, tags);
  if (key.empty()) return;
  const std::string said = tags.value(key);
  if (is_among(said, no)) return;
  strips.push_back(
      {SideStripKind::buffer, is_among(said, yes) ? std::nullopt : metres_of(key, tags)});
}

void name_what_needs_a_track(RoadSide kerb, bool on_roadway_there, WayTags& tags) {
  const bool any_track = !cycle_track_key(RoadSide::near, tags).empty() ||
                         !cycle_track_key(RoadSide::far, tags).empty();
  const auto name = [&](const char* end) {
    const std::string key = first_said(keys_of("cycleway", kerb, end, tags), tags);
    if (speaks_of_side(key, kerb, "cycleway", any_track, tags) && !is_among(tags.value(key), no))
      tags.name(key, "no cycle track lies behind a kerb there");
  };
  for (const char* end : {":buffer", ":buffer:both", ":buffer:left", ":buffer:right"}) name(end);
  if (!on_roadway_there) name(":separation");
}

}  // namespace

const char* side_strip_name(SideStripKind kind) {
  switch (kind) {
    case SideStripKind::verge:
      return "verge";
    case SideStripKind::buffer:
      return "buffer";
    case SideStripKind::cycle_track:
      return "cycle_track";
    case SideStripKind::two_way_cycle_track:
      return "two_way_cycle_track";
  }
  return "";
}

std::string cycle_track_key(RoadSide kerb, const WayTags& tags) {
  const bool near = kerb == RoadSide::near;
  const std::string own = tags.said_of("cycleway", kerb);
  if (const std::string said = track_word(tags.value(own)); !said.empty())
    return is_among(said, track_words) ? own : "";
  // Without a side it speaks of the near kerb of each direction.
  const std::string of_way = track_word(tags.value("cycleway"));
  if (!tags.one_way()) return of_way == "track" ? "cycleway" : "";
  return of_way == (near ? "track" : "opposite_track") ? "cycleway" : "";
}

bool track_is_on_roadway(RoadSide kerb, const WayTags& tags) {
  return parted_by(kerb, TrackSide::lanes, on_roadway, tags) &&
         !parted_by(kerb, TrackSide::lanes, on_verge, tags);
}

bool cars_stand_before_track(RoadSide kerb, const WayTags& tags) {
  return parted_by(kerb, TrackSide::lanes, {"parking_lane"}, tags);
}

std::vector<SideStrip> side_strips(RoadSide kerb, WayTags& tags) {
  std::vector<SideStrip> strips;
  const std::string key = cycle_track_key(kerb, tags);
  const bool track = !key.empty() && !track_is_on_roadway(kerb, tags);
  add_verge(kerb, track && parted_by(kerb, TrackSide::lanes, on_verge, tags), strips, tags);
  if (!track) {
    name_what_needs_a_track(kerb, !key.empty(), tags);
    return strips;
  }
  add_buffer(kerb, TrackSide::lanes, strips, tags);
  std::optional<double> width;
  for (const char* said : {":width", ":est_width"}) {
    const std::string wide = first_said(keys_of("cycleway", kerb, said, tags), tags);
    if (!wide.empty() && !width) width = metres_of(wide, tags);
  }
  const std::string oneway =
      first_said({tags.key_of("cycleway", kerb) + ":oneway", "cycleway:both:oneway"}, tags);
  const bool both = !oneway.empty() && is_among(tags.value(oneway), no);
  strips.push_back({both ? SideStripKind::two_way_cycle_track : SideStripKind::cycle_track, width});
  add_buffer(kerb, TrackSide::walk, strips, tags);
  if (parted_by(kerb, TrackSide::walk, on_verge, tags))
    strips.push_back({SideStripKind::verge, {}});
  return strips;
}

}  // namespace streetgen
