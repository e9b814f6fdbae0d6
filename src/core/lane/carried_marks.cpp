#include "lane/carried_marks.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "lane/lane_layout.hpp"
#include "lane/lane_succession.hpp"
#include "lane/turn_mark.hpp"

namespace streetgen {

namespace {

constexpr double longest_within = 100;  // metres of an edge within a junction
constexpr double seen_along = 10;       // metres of an edge by which it is seen where it leads
constexpr double straight_on = 50;      // degrees
constexpr double same_turn = 1e-4;      // degrees

// Indices of the lanes that drive in one direction alone, from left to right as one drives.
std::vector<int> driven_lanes(const std::vector<LaneWish>& lanes, bool along_axis) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i)
    if (drives(lanes[i].kind) && !lanes[i].both_ways && lanes[i].along_axis == along_axis)
      found.push_back(i);
  if (!along_axis) std::reverse(found.begin(), found.end());
  return found;
}

// One of two lanes becomes the other's too; where nothing is said of one it goes straight on.
unsigned united(unsigned a, unsigned b) {
  if (a == b) return a;
  return (a == 0 ? turn::through : a) | (b == 0 ? turn::through : b);
}

// What stays on a lane where others begin beside it that take some of its turns.
unsigned less(unsigned turns, unsigned taken) { return turns & ~taken ? turns & ~taken : turns; }

// Leaves the lanes that go straight on, with what they are marked for beyond.  Gives whether any
// turns off there.
bool cross_over(std::vector<LaneAbreast>& lanes, unsigned answered) {
  const auto turns_off = [&](const LaneAbreast& lane) {
    return lane.turns != 0 && (lane.turns & ~answered) == 0;
  };
  lanes.erase(std::remove_if(lanes.begin(), lanes.end(), turns_off), lanes.end());
  bool sideways = false;
  for (LaneAbreast& lane : lanes) {
    lane.turns &= ~answered;
    sideways = sideways || (lane.turns & (turn::leftwards | turn::rightwards)) != 0;
  }
  return sideways;
}

}  // namespace

CarriedMarks::CarriedMarks(const Network& network, const std::vector<Roadway>& roadways,
                           const LaneWishes& wishes, const LaneSettings& settings)
    : network_(network),
      roadways_(roadways),
      wishes_(wishes),
      settings_(settings),
      any_(wishes.mark_any()),
      own_(2 * network.edges.size()),
      open_(2 * network.edges.size()),
      ends_(network.nodes.size()),
      known_(2 * network.edges.size()) {
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    ends_[network.edges[e].from_node].push_back({e, true});
    ends_[network.edges[e].to_node].push_back({e, false});
    for (const LaneWish& lane : wishes.of(network.edges[e]).lanes)
      for (const bool along_axis : {true, false}) {
        if (!drives(lane.kind) || !(lane.both_ways || lane.along_axis == along_axis)) continue;
        open_[number({e, along_axis})] = true;
        if (lane.turns != 0 && !lane.both_ways) own_[number({e, along_axis})] = true;
      }
  }
}

std::optional<CarriedMarks::Source> CarriedMarks::source(const DrivenEdge& driven) const {
  const Edge& edge = network_.edges[driven.edge];
  const auto& ends = ends_[driven.along_axis ? edge.from_node : edge.to_node];
  if (ends.size() > 2) return source_across(driven, ends);
  if (ends.size() < 2 || ends[0].edge == ends[1].edge) return std::nullopt;
  const EdgeEnd& other = ends[0].edge == driven.edge ? ends[1] : ends[0];
  return Source{{other.edge, !other.at_start}};
}

// Degrees to the left from one who comes by an end of an edge to one who leaves by another.
double CarriedMarks::angle(const EdgeEnd& from, const EdgeEnd& to) const {
  const auto away = [&](const EdgeEnd& end) {
    const Line& line = network_.edges[end.edge].line;
    const double total = length(line), along = std::min(seen_along, total);
    return unit(position_at(line, end.at_start ? along : total - along).point -
                planar(end.at_start ? line.front() : line.back()));
  };
  const Point in = away(from) * -1, out = away(to);
  return std::atan2(cross(in, out), dot(in, out)) * 180 / M_PI;
}

// The end by which one goes on straightest, or by which comes who does so; none where one turns, or
// where two are as straight.
std::optional<EdgeEnd> CarriedMarks::straight(const EdgeEnd& end, bool onwards,
                                              const std::vector<EdgeEnd>& ends) const {
  std::optional<EdgeEnd> best;
  bool as_straight = false;
  double least = straight_on;
  for (const EdgeEnd& other : ends) {
    if (other.edge == end.edge || !open_[number({other.edge, other.at_start == onwards})]) continue;
    const double turned = std::abs(onwards ? angle(end, other) : angle(other, end));
    as_straight = std::abs(turned - least) < same_turn || (as_straight && turned > least);
    if (turned >= least) continue;
    least = turned;
    best = other;
  }
  return as_straight ? std::nullopt : best;
}

std::optional<CarriedMarks::Source> CarriedMarks::source_across(
    const DrivenEdge& driven, const std::vector<EdgeEnd>& ends) const {
  const Edge& edge = network_.edges[driven.edge];
  const EdgeEnd own{driven.edge, driven.along_axis};
  if (wishes_.circulates(edge) || length(edge.line) > longest_within) return std::nullopt;
  const std::optional<EdgeEnd> from = straight(own, false, ends);
  if (!from || wishes_.circulates(network_.edges[from->edge])) return std::nullopt;
  const std::optional<EdgeEnd> onwards = straight(*from, true, ends);
  if (!onwards || onwards->edge != own.edge || onwards->at_start != own.at_start)
    return std::nullopt;
  Source source{{from->edge, !from->at_start}, turn::reverse, true};
  for (const EdgeEnd& to : ends) {
    if (to.edge == from->edge || !open_[number({to.edge, to.at_start})]) continue;
    const double way = angle(*from, to);
    for (const MarkedTurn& mark : marked_turns)
      if (mark.bit != turn::through && answers(way, mark.angle)) source.answered |= mark.bit;
  }
  return source;
}

bool CarriedMarks::carries(const DrivenEdge& driven) const {
  if (!any_ || has_own(driven)) return false;
  const Marks& marks = marks_of(driven);
  return std::any_of(marks.begin(), marks.end(), [](unsigned turns) { return turns != 0; });
}

void CarriedMarks::carry(int edge, std::vector<LaneWish>& lanes) const {
  for (const bool along_axis : {true, false}) {
    if (!carries({edge, along_axis})) continue;
    const std::vector<int> driven = driven_lanes(lanes, along_axis);
    const Marks& marks = marks_of({edge, along_axis});
    for (std::size_t i = 0; i < driven.size(); ++i) lanes[driven[i]].turns = marks[i];
  }
}

const CarriedMarks::Marks& CarriedMarks::marks_of(DrivenEdge driven) const {
  // Back to the edge that has marks, or to a junction, and on again.  A ring has no first edge.
  std::vector<DrivenEdge> chain{driven};
  std::vector<Source> sources;
  while (!known_[number(chain.back())] && !has_own(chain.back())) {
    const std::optional<Source> source = this->source(chain.back());
    const auto passed = [&](const DrivenEdge& d) { return number(d) == number(source->from); };
    if (!source || std::any_of(chain.begin(), chain.end(), passed)) break;
    sources.push_back(*source);
    chain.push_back(source->from);
  }
  for (std::size_t i = chain.size(); i-- > 0;) {
    std::optional<Marks>& known = known_[number(chain[i])];
    if (known) continue;
    if (i < sources.size()) {
      known = carried(sources[i], chain[i]);
      continue;
    }
    const std::vector<LaneWish> lanes = wishes_.of(network_.edges[chain[i].edge]).lanes;
    known.emplace();
    for (const int lane : driven_lanes(lanes, chain[i].along_axis))
      known->push_back(lanes[lane].turns);
  }
  return *known_[number(driven)];
}

CarriedMarks::Marks CarriedMarks::carried(const Source& source, const DrivenEdge& to) const {
  const DrivenEdge& from = source.from;
  const auto abreast = [&](const DrivenEdge& driven, bool at_start) {
    const std::vector<LaneWish> lanes = wishes_.of(network_.edges[driven.edge]).lanes;
    const Roadway& roadway = roadways_[driven.edge];
    const double width = at_start ? roadway.width : roadway.width_end;
    const std::vector<double> shares = lane_shares(lanes, width, settings_.narrowest);
    std::vector<LaneAbreast> found;
    for (const int i : driven_lanes(lanes, driven.along_axis)) {
      const double aside = width / 2 * (1 - shares[i] - shares[i + 1]) + roadway.roadway_offset;
      found.push_back({lanes[i].turns, driven.along_axis ? aside : -aside});
    }
    return found;
  };
  std::vector<LaneAbreast> in = abreast(from, !from.along_axis);
  const std::vector<LaneAbreast> out = abreast(to, to.along_axis);
  Marks marks(out.size());
  const Marks& own = marks_of(from);
  for (std::size_t i = 0; i < in.size(); ++i) in[i].turns = own[i];
  if (source.crossing && !cross_over(in, source.answered)) return marks;
  if (in.empty() || out.empty()) return marks;
  const int n = static_cast<int>(in.size()), m = static_cast<int>(out.size());
  const int shift = succession(in, out, settings_.driving_side);
  std::vector<bool> reached(m);
  for (int i = 0; i < n; ++i) {
    const int lane = std::clamp(i + shift, 0, m - 1);
    const bool ends = lane != i + shift;
    const unsigned turns = ends ? in[i].turns & ~turn::merges : in[i].turns;
    if (ends && turns == 0) continue;
    marks[lane] = reached[lane] ? united(marks[lane], turns) : turns;
    reached[lane] = true;
  }
  if (n >= m) return marks;
  const int last = shift + n - 1;
  const unsigned on_left = shift > 0 ? marks[shift] & turn::leftwards : 0;
  const unsigned on_right = last + 1 < m ? marks[last] & turn::rightwards : 0;
  std::fill(marks.begin(), marks.begin() + shift, on_left);
  std::fill(marks.begin() + last + 1, marks.end(), on_right);
  if (n == 1) {
    marks[shift] = less(marks[shift], on_left | on_right);
  } else {
    marks[shift] = less(marks[shift], on_left);
    marks[last] = less(marks[last], on_right);
  }
  return marks;
}

}  // namespace streetgen
