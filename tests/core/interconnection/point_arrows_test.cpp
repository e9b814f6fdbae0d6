// Arrows lie on lanes with marks, and at signals where the lanes of an arm lead apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "geometry/polyline.hpp"
#include "interconnection/joined_town.hpp"
#include "lane/arrow_paint.hpp"
#include "streetgen/street_model.hpp"

namespace streetgen {
namespace point_arrows_test {

StreetModel model_of(const std::vector<LanedAxis>& roads,
                     const std::vector<TurnRestriction>& restrictions = {},
                     const std::vector<ControlPoint>& controls = {}) {
  StreetModelInput input;
  for (const LanedAxis& r : roads) {
    input.axes.push_back({r.id, r.line, 0, r.width, r.width, 8, 5, r.speed});
    input.lanes.push_back({r.id, {r.forward, r.backward, general(r.both_ways)}});
  }
  input.restrictions = restrictions;
  input.controls = controls;
  return street_model(input);
}

// With signals at the node, which is where the lines that leave it begin.
StreetModel signalled(const std::vector<LanedAxis>& roads,
                      const std::vector<TurnRestriction>& restrictions = {}) {
  return model_of(roads, restrictions, {{3, 0, ControlKind::signals}});
}

bool same(const MultiPolygon& a, const MultiPolygon& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Ring &one = a[i].front(), &other = b[i].front();
    if (!std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const Point& p, const Point& q) { return distance(p, q) < 1e-9; }))
      return false;
  }
  return true;
}

// The turns that the arrow of a lane shows, by its rank from the left as one drives along its axis.
std::vector<unsigned> shown(const StreetModel& model, std::int64_t axis_id) {
  const unsigned all[] = {0,
                          turn::left,
                          turn::right,
                          turn::left | turn::right,
                          turn::slight_left,
                          turn::slight_right,
                          turn::through,
                          turn::through | turn::right};
  ArrowPaint paint;
  std::map<int, unsigned> by_position;
  for (const Marking& marking : model.lanes.markings) {
    if (marking.kind != MarkingKind::arrow || !marking.along_axis ||
        model.streets.network.edges[marking.edge].axis_id != axis_id)
      continue;
    const Lane& lane =
        *std::find_if(model.lanes.lanes.begin(), model.lanes.lanes.end(), [&](const Lane& other) {
          return other.edge == marking.edge && other.position == marking.position;
        });
    for (const unsigned turns : all)
      if (same(paint.on(lane, turns, marking.line), marking.surface))
        by_position[marking.position] = turns;
  }
  std::vector<unsigned> found;
  for (const auto& [position, turns] : by_position) found.push_back(turns);
  return found;
}

using Turns = std::vector<unsigned>;
const Line to_west{{0, 0, 0}, {-100, 0, 0}}, to_east{{0, 0, 0}, {100, 0, 0}};

// A stem from the south, of a street from west to east.
std::vector<LanedAxis> stem(const std::vector<LaneWish>& lanes) {
  return {{2, south, lanes, general(1), 3.5 * (1 + lanes.size())},
          road(1, to_west, 1, 1),
          road(3, to_east, 1, 1)};
}

TEST(PointArrows, ShowAtSignalsWhereLanesOfAStemLead) {
  EXPECT_EQ(shown(signalled(stem(general(2))), 2), (Turns{turn::left, turn::right}));
}

TEST(PointArrows, LieOnNoLaneWithoutMarksWhereNoSignalsAre) {
  EXPECT_EQ(shown(model_of(stem(general(2))), 2), Turns{});
  EXPECT_EQ(shown(model_of(stem(general(1))), 2), Turns{});
}

TEST(PointArrows, LieOnNoLaneThatLeadsAsAllOfItsArm) {
  EXPECT_EQ(shown(signalled(stem(general(1))), 2), Turns{});
  const StreetModel model = signalled(
      {road(1, west, 2, 1), road(2, south, 1, 1), road(3, to_east, 2, 1), road(4, north, 1, 1)});
  EXPECT_EQ(shown(model, 1), Turns{});
  EXPECT_EQ(shown(model, 2), Turns{});
}

// Three lanes come from the west, two go on to the east: the left one is for the turn.
TEST(PointArrows, ShowTheTurnOfALaneThatDoesNotGoOn) {
  const std::vector<LanedAxis> fork{road(1, west, 3, 0), road(3, to_east, 2, 0),
                                    road(4, {{0, 0, 0}, {0, 100, 0}}, 1, 0)};
  EXPECT_EQ(shown(signalled(fork), 1), (Turns{turn::left, turn::through, turn::through}));
  EXPECT_EQ(shown(model_of(fork), 1), Turns{});
}

TEST(PointArrows, ShowNoTurnThatIsForbidden) {
  EXPECT_EQ(shown(signalled(stem(general(2)), {{2, 1, {0, 0, 0}}}), 2), Turns{});
}

TEST(PointArrows, LieOnLanesWithMarksAlone) {
  std::vector<LaneWish> lanes = general(2);
  lanes[0].turns = turn::left;
  EXPECT_EQ(shown(model_of(stem(lanes)), 2), (Turns{turn::left}));
}

TEST(PointArrows, ShowNoMarkStraightOnWhereThereIsNone) {
  EXPECT_EQ(shown(model_of(stem(general(1, turn::through | turn::right))), 2),
            (Turns{turn::right}));
  auto crossing = stem(general(1, turn::through | turn::right));
  crossing.push_back(road(4, north, 1, 1));
  EXPECT_EQ(shown(model_of(crossing), 2), (Turns{turn::through | turn::right}));
}

}  // namespace point_arrows_test
}  // namespace streetgen
