#include "height/plateau.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

const double straight_on =
    std::sqrt(0.5);  // cosine of the 45 degrees by which a road turns at most

}  // namespace

ThroughRoads::ThroughRoads(const std::vector<ProfileEdge>& edges)
    : edges_(edges), next_(edges.size()), road_(edges.size(), -1), piece_(edges.size()) {
  find_next();
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (road_[e] < 0) follow(static_cast<int>(e));
}

// Two arms of a node are one road where each is the straightest way on from the other.
void ThroughRoads::find_next() {
  struct Arm {
    End end;
    Point away;  // unit
  };
  std::map<std::int64_t, std::vector<Arm>> nodes;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Line& line = edges_[e].line;
    const int edge = static_cast<int>(e);
    nodes[edges_[e].from_node].push_back({{edge, true}, unit(line[1] - line[0])});
    nodes[edges_[e].to_node].push_back(
        {{edge, false}, unit(line[line.size() - 2] - line[line.size() - 1])});
  }
  for (const auto& [node, arms] : nodes) {
    std::vector<int> best(arms.size(), -1);
    for (std::size_t a = 0; a < arms.size(); ++a) {
      double most = straight_on;
      for (std::size_t b = 0; b < arms.size(); ++b)
        if (const double along = -dot(arms[a].away, arms[b].away); b != a && along > most)
          best[a] = static_cast<int>(b), most = along;
    }
    for (std::size_t a = 0; a < arms.size(); ++a)
      if (best[a] >= 0 && best[best[a]] == static_cast<int>(a))
        next_[arms[a].end.edge][arms[a].end.at_start ? 0 : 1] = arms[best[a]].end;
  }
}

void ThroughRoads::follow(int edge) {
  const auto led_on = [&](End end) { return next_[end.edge][end.at_start ? 0 : 1]; };
  // The road is followed back to where it begins, or once around.
  End first{edge, true};
  for (End before = led_on(first); before.edge >= 0 && before.edge != edge; before = led_on(first))
    first = {before.edge, !before.at_start};
  std::vector<Piece> road;
  double begin = 0;
  for (End at = first; at.edge >= 0 && road_[at.edge] < 0; at = led_on({at.edge, !at.at_start})) {
    road_[at.edge] = static_cast<int>(roads_.size());
    piece_[at.edge] = static_cast<int>(road.size());
    const double end = begin + length(edges_[at.edge].line);
    road.push_back({at.edge, at.at_start, begin, end});
    begin = end;
  }
  roads_.push_back(std::move(road));
}

double ThroughRoads::on_road(const LiftedPlace& place) const {
  const Piece& piece = roads_[road_[place.edge]][piece_[place.edge]];
  return piece.forward ? piece.begin + place.at : piece.end - place.at;
}

std::vector<Plateau> ThroughRoads::plateaus(const std::vector<LiftedPlace>& places,
                                            const std::vector<HeightLine>& heights,
                                            const std::vector<HeightLine>& ground,
                                            double factor) const {
  const auto over = [&](int e, double at) {
    return height_at(heights[e], at) - height_at(ground[e], at);
  };
  const auto way_down = [&](int e, double height) {
    return factor * (height / edges_[e].grade + edges_[e].radius * edges_[e].grade);
  };
  std::map<int, std::vector<LiftedPlace>> of_road;
  for (const LiftedPlace& place : places) of_road[road_[place.edge]].push_back(place);
  std::vector<Plateau> found;
  for (auto& [road, along] : of_road) {
    std::sort(along.begin(), along.end(),
              [&](const LiftedPlace& a, const LiftedPlace& b) { return on_road(a) < on_road(b); });
    for (std::size_t i = 1; i < along.size(); ++i) {
      const LiftedPlace &a = along[i - 1], &b = along[i];
      const double from = on_road(a), to = on_road(b);
      const double lower = std::min(over(a.edge, a.at), over(b.edge, b.at));
      if (to - from <= same_place || lower <= same_place ||
          to - from > std::max(way_down(a.edge, lower), way_down(b.edge, lower)))
        continue;
      const double z_from = height_at(heights[a.edge], a.at),
                   z_to = height_at(heights[b.edge], b.at);
      std::vector<Plateau> parts;
      bool comes_down = false;
      for (int p = piece_[a.edge]; p <= piece_[b.edge]; ++p) {
        const Piece& piece = roads_[road][p];
        // A node on the ground is not solved together with what lies beyond.
        if (p > piece_[a.edge])
          comes_down = comes_down ||
                       over(piece.edge, piece.forward ? 0 : piece.end - piece.begin) <= same_place;
        HeightLine bound;
        for (const double at : {std::max(from, piece.begin), std::min(to, piece.end)})
          bound.push_back({piece.forward ? at - piece.begin : piece.end - at,
                           z_from + (z_to - z_from) * ((at - from) / (to - from))});
        if (!piece.forward) std::swap(bound.front(), bound.back());
        if (bound.back().at > bound.front().at + same_place)
          parts.push_back({piece.edge, std::move(bound)});
      }
      if (!comes_down) found.insert(found.end(), parts.begin(), parts.end());
    }
  }
  return found;
}

}  // namespace streetgen
