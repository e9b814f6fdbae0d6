#include "interconnection/turning_back.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

const double side_by_side = std::cos(M_PI / 6 + same_angle);         // of two carriageways
const double upon = std::cos(M_PI / 18 + same_angle);                // of streets drawn twice
constexpr double upon_each_other = 2;                                // metres between these
const double about_a_nose = std::cos(75 * M_PI / 180 + same_angle);  // where their street parts

// Whether two streets leave the node on one ground: who goes from one to the other goes back.
bool on_one_ground(const Leg& a, const Leg& b) {
  return dot(a.course, b.course) >= upon && distance(a.stand, b.stand) <= upon_each_other;
}

bool lets_cars(const std::vector<LaneEnd>& lanes) {
  return std::any_of(lanes.begin(), lanes.end(),
                     [](const LaneEnd& lane) { return leads_as(lane.kind) == LaneKind::general; });
}

bool lets_motors(const std::vector<LaneEnd>& lanes) {
  return std::any_of(lanes.begin(), lanes.end(),
                     [](const LaneEnd& lane) { return drives(lane.kind); });
}

bool leads_alone(const std::vector<LaneEnd>& lanes, const std::vector<LaneEnd>& others) {
  return lets_cars(lanes) ? !lets_cars(others)
                          : lets_motors(lanes) && !lets_cars(others) && !lets_motors(others);
}

// Whether a street of both directions parts into the two legs: the only other one for cars, and
// across the node from both.
bool parts(const std::vector<Leg>& legs, int a, int b) {
  const Leg* street = nullptr;
  for (int leg = 0; leg < static_cast<int>(legs.size()); ++leg) {
    const bool open = lets_cars(legs[leg].in) || lets_cars(legs[leg].out);
    if (leg == a || leg == b || !open) continue;
    if (street != nullptr || !lets_cars(legs[leg].in) || !lets_cars(legs[leg].out)) return false;
    street = &legs[leg];
  }
  return street != nullptr && legs[a].importance == legs[b].importance &&
         dot(street->course, legs[a].course) < 0 && dot(street->course, legs[b].course) < 0;
}

}  // namespace

bool comes_alone(const Leg& leg) { return leads_alone(leg.in, leg.out); }

bool goes_alone(const Leg& leg) { return leads_alone(leg.out, leg.in); }

bool turns_back(const std::vector<Leg>& legs, int from, int to) {
  if (from == to) return true;
  const Leg &a = legs[from], &b = legs[to];
  if (a.on_ring || b.on_ring) return false;
  if (legs.size() > 2 && on_one_ground(a, b)) return true;
  if (!comes_alone(a) || !goes_alone(b)) return false;
  const double cosine = dot(a.course, b.course);
  return cosine >= side_by_side || (cosine >= about_a_nose && parts(legs, from, to));
}

}  // namespace streetgen
