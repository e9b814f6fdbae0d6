// Streets fitted to observations, against closed forms, differences and the streets that made them.
#include "streetgen/fit.hpp"

#include "fit/solve_fit.hpp"
#include "streetgen/error.hpp"

namespace {

using namespace streetgen;

FitAxis street(Line line, double width) {
  FitAxis axis;
  axis.line = std::move(line);
  axis.width_start = axis.width_end = width;
  double length = 0;
  for (std::size_t i = 1; i < axis.line.size(); ++i)
    length += std::hypot(axis.line[i].x - axis.line[i - 1].x, axis.line[i].y - axis.line[i - 1].y);
  axis.stretches.push_back({0, length, 5, length - 5, 1, 2});
  return axis;
}

// Points of both kerbs of a street along the x axis, a metre apart.
std::vector<Observation> kerbs(double left, double right, double slope = 0) {
  std::vector<Observation> observations;
  for (int x = 6; x < 95; ++x) {
    observations.push_back({{double(x), left + slope * x, 0}});
    observations.push_back({{double(x), -right - slope * x, 0}});
  }
  return observations;
}

FitRules free_of_regularisers() {
  FitRules rules;
  rules.width = rules.origin = rules.spacing = rules.angle = 0;
  return rules;
}

TEST(FitStreets, HasTheKerbsOfAStraightStreet) {
  const auto fitted =
      fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, kerbs(5.2, 3.1), free_of_regularisers());
  EXPECT_NEAR(fitted.axes[0].width_start, 8.3, 1e-9);
  EXPECT_NEAR(fitted.axes[0].width_end, 8.3, 1e-9);
  EXPECT_NEAR(fitted.axes[0].roadway_offset, 1.05, 1e-9);
  EXPECT_NEAR(fitted.after.mean, 0, 1e-9);
  EXPECT_NEAR(fitted.before.mean, (2.2 + 0.1) / 2, 1e-9);
  EXPECT_EQ(fitted.used, 178);
}

TEST(FitStreets, HasAWidthThatChangesAlongTheStreet) {
  const auto fitted =
      fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, kerbs(4, 4, 0.01), free_of_regularisers());
  EXPECT_NEAR(fitted.axes[0].width_start, 8, 1e-9);
  EXPECT_NEAR(fitted.axes[0].width_end, 10, 1e-9);
}

TEST(FitStreets, HasOneWidthWhereKerbsTellOfAPartAlone) {
  std::vector<Observation> part;
  for (const Observation& one : kerbs(4, 4, 0.01))
    if (one.place.x < 40) part.push_back(one);
  const auto fitted =
      fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, part, free_of_regularisers());
  EXPECT_EQ(fitted.axes[0].width_start, fitted.axes[0].width_end);
}

TEST(FitStreets, HasOneWidthWhereAFewKerbsTellOfTheRest) {
  std::vector<Observation> part;
  for (const Observation& one : kerbs(4, 4, 0.01))
    if (one.place.x < 40 || one.place.x > 93) part.push_back(one);
  const auto fitted =
      fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, part, free_of_regularisers());
  EXPECT_EQ(fitted.axes[0].width_start, fitted.axes[0].width_end);
}

TEST(FitStreets, TakesNothingThatNobodyIsSureOf) {
  std::vector<Observation> seen = kerbs(4, 4);
  for (int x = 6; x < 95; ++x) {
    Observation back;
    back.kind = ObservationKind::sidewalk_back;
    back.place = {double(x), 6.5, 0};
    seen.push_back(back);
  }
  for (Observation& one : seen) one.confidence = 0;
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  axis.sidewalk_left = 1.75;
  const auto fitted = fit_streets({axis}, seen, FitRules());
  EXPECT_EQ(fitted.axes[0].width_start, 6);
  EXPECT_EQ(fitted.axes[0].sidewalk_left, 1.75);
  EXPECT_EQ(fitted.used, 0);
  EXPECT_EQ(taken_observations({axis}, seen, FitRules())[0].fate, ObservationFate::not_sure);
}

TEST(FitStreets, MovesAnAxisToTheMiddleOfItsKerbs) {
  FitRules rules;
  rules.axes_move = true;
  rules.origin = 0.01;
  const auto fitted = fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, kerbs(5.2, 3.1), rules);
  for (const Point& p : fitted.axes[0].line)
    if (p.x > 20 && p.x < 80) EXPECT_NEAR(p.y, 1.05, 0.02);
  EXPECT_NEAR(fitted.axes[0].width_start, 8.3, 0.05);
  EXPECT_EQ(fitted.axes[0].roadway_offset, 0);
}

TEST(FitStreets, KeepsWhatNobodyObserved) {
  const FitAxis axis = street({{0, 0, 0}, {50, 7, 0}, {100, 0, 0}}, 6);
  for (bool moves : {false, true}) {
    FitRules rules;
    rules.axes_move = moves;
    const auto fitted = fit_streets({axis}, {}, rules);
    EXPECT_EQ(fitted.axes[0].width_start, 6);
    EXPECT_EQ(fitted.axes[0].roadway_offset, 0);
    ASSERT_EQ(fitted.axes[0].line.size(), 3u);
    EXPECT_EQ(fitted.axes[0].line[1].y, 7);
    EXPECT_TRUE(std::isnan(fitted.after.mean));
  }
}

TEST(FitStreets, KeepsNodesThatStay) {
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  axis.stretches[0].end_node = 0;
  FitRules rules;
  rules.axes_move = true;
  const auto fitted = fit_streets({axis}, kerbs(5.2, 3.1), rules);
  EXPECT_GT(fitted.axes[0].line.front().y, 0.3);
  EXPECT_EQ(fitted.axes[0].line.back().y, 0);
}

TEST(FitStreets, SharesTheDisplacementOfANode) {
  FitAxis west = street({{0, 0, 0}, {60, 0, 0}}, 6), east = street({{60, 0, 0}, {120, 0, 0}}, 6);
  east.stretches[0].start_node = 2;
  east.stretches[0].end_node = 3;
  std::vector<Observation> seen;
  for (int x = 5; x < 116; ++x)
    for (double y : {5.0, -3.0}) seen.push_back({{double(x), y, 0}});
  FitRules rules;
  rules.axes_move = true;
  auto fitted = fit_streets({west, east}, seen, rules);
  EXPECT_EQ(fitted.axes[0].line.back().y, fitted.axes[1].line.front().y);
  EXPECT_GT(fitted.axes[0].line.back().y, 0.3);
  // Nothing moves a node of an axis that stays.
  east.moves = false;
  fitted = fit_streets({west, east}, seen, rules);
  EXPECT_EQ(fitted.axes[0].line.back().y, 0);
  EXPECT_EQ(fitted.axes[1].line.front().y, 0);
  EXPECT_EQ(fitted.axes[1].width_start, 6);
}

TEST(FitStreets, HasTheSidewalkOfItsBack) {
  std::vector<Observation> seen = kerbs(4, 4);
  for (int x = 6; x < 95; ++x) {
    Observation back;
    back.kind = ObservationKind::sidewalk_back;
    back.place = {double(x), 6.5, 0};
    seen.push_back(back);
  }
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  axis.sidewalk_right = 1.75;
  const auto fitted = fit_streets({axis}, seen, free_of_regularisers());
  EXPECT_NEAR(fitted.axes[0].sidewalk_left, 2.5, 1e-6);
  EXPECT_EQ(fitted.axes[0].sidewalk_right, 1.75);
}

TEST(FitStreets, KeepsObjectsOnTheirSideOfTheKerb) {
  std::vector<Observation> seen;
  for (int x = 10; x < 90; x += 4) {
    Observation tree, car;
    tree.kind = car.kind = ObservationKind::object;
    tree.relation = ObservationRelation::out;
    tree.place = {double(x), 5, 0};
    car.relation = ObservationRelation::in;
    car.place = {double(x + 2), -4, 0};
    seen.push_back(tree);
    seen.push_back(car);
  }
  const auto fitted = fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, seen, FitRules());
  const FittedAxis& axis = fitted.axes[0];
  EXPECT_LE(axis.width_start / 2 + axis.roadway_offset, 5);
  EXPECT_GE(axis.width_start / 2 - axis.roadway_offset, 4);
}

// Beside a bend the place of an axis that is nearest counts, though its other segment ends as far
// away as its kerb is.
TEST(FitStreets, TakesObservationsAtTheNearestPlaceOfAnAxis) {
  const FitAxis axis = street({{0, 0, 0}, {50, 4, 0}, {100, 0, 0}}, 6);
  Observation seen;
  seen.kind = ObservationKind::kerb;
  FitRules rules;
  for (const double x : {47.5, 48.0, 52.0, 52.5}) {
    seen.place = {x, 1.9, 0};
    const auto taken = taken_observations({axis}, {seen}, rules);
    const double nearest = std::min(distance_to_segment(seen.place, axis.line[0], axis.line[1]),
                                    distance_to_segment(seen.place, axis.line[1], axis.line[2]));
    EXPECT_NEAR(std::abs(taken[0].offset), nearest, 1e-9) << x;
  }
}

// What would go beyond its bound stays there, and the others are as if it were fixed: the width is
// the mean of what both kerbs ask for.
TEST(FitStreets, FitsTheOthersWhereOneIsAtItsBound) {
  FitRules rules = free_of_regularisers();
  rules.loss = FitLoss::squares;
  rules.move = 0.5;
  std::vector<Observation> seen;
  int left = 0, right = 0;
  for (const Observation& one : kerbs(5, 2)) {
    if (one.place.y < 0 && static_cast<int>(one.place.x) % 2 != 0) continue;
    ++(one.place.y > 0 ? left : right);
    seen.push_back(one);
  }
  const auto fitted = fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, seen, rules);
  EXPECT_NEAR(fitted.axes[0].roadway_offset, 0.5, 1e-9);
  EXPECT_NEAR(fitted.axes[0].width_start, 2 * (4.5 * left + 2.5 * right) / (left + right), 1e-6);
}

TEST(FitStreets, HasALineBetweenLanesInTheMiddleAndNoKerbThere) {
  std::vector<Observation> seen;
  for (int x = 6; x < 95; ++x) {
    Observation line;
    line.kind = ObservationKind::marking;
    line.place = {double(x), 2.2, 0};
    seen.push_back(line);
  }
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  axis.lanes = 2;
  FittedAxis fitted = fit_streets({axis}, seen, FitRules()).axes[0];
  EXPECT_NEAR(fitted.roadway_offset, 2.2, 0.01);
  EXPECT_NEAR(fitted.width_start, 6, 0.01);
  axis.lanes = 1;
  fitted = fit_streets({axis}, seen, FitRules()).axes[0];
  EXPECT_EQ(fitted.roadway_offset, 0);
  EXPECT_EQ(fitted.width_start, 6);
}

TEST(FitStreets, TakesNoLineBetweenLanesWhereThereIsOne) {
  Observation line;
  line.kind = ObservationKind::marking;
  line.place = {50, 1, 0};
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  for (int lanes : {1, 2}) {
    axis.lanes = lanes;
    const bool taken = lanes > 1;
    EXPECT_EQ(fit_streets({axis}, {line}, FitRules()).used, taken);
    EXPECT_EQ(taken_observations({axis}, {line}, FitRules())[0].fate,
              taken ? ObservationFate::taken : ObservationFate::no_street);
  }
}

TEST(FitStreets, WidensAStreetOfOneKerbAlikeWhetherItTapers) {
  std::vector<Observation> left, part;
  for (const Observation& one : kerbs(5, 3)) {
    if (one.place.y < 0) continue;
    left.push_back(one);
    if (one.place.x < 60) part.push_back(one);
  }
  const FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  const FittedAxis whole = fit_streets({axis}, left, FitRules()).axes[0];
  const FittedAxis some = fit_streets({axis}, part, FitRules()).axes[0];
  EXPECT_NEAR(whole.width_start, some.width_start, 0.05);
  EXPECT_NEAR(whole.width_end, some.width_end, 0.05);
  EXPECT_NEAR(whole.roadway_offset, some.roadway_offset, 0.05);
}

TEST(FitStreets, TakesAWidthAcross) {
  Observation across;
  across.kind = ObservationKind::width;
  across.place = {50, 0, 0};
  across.width = 9;
  across.weight = 1000;
  const auto fitted = fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, {across}, FitRules());
  EXPECT_NEAR(fitted.axes[0].width_start, 9, 0.01);
  EXPECT_EQ(fitted.axes[0].roadway_offset, 0);
}

TEST(FitStreets, BringsLanesUnderTheirMarkings) {
  std::vector<Observation> seen;
  for (int x = 10; x < 90; ++x) {
    Observation marking;
    marking.kind = ObservationKind::marking;
    marking.place = {double(x), 0.8, 0};
    seen.push_back(marking);
  }
  FitAxis axis = street({{0, 0, 0}, {100, 0, 0}}, 6);
  axis.lanes = 2;
  const auto fitted = fit_streets({axis}, seen, free_of_regularisers());
  EXPECT_NEAR(fitted.axes[0].roadway_offset, 0.8, 1e-6);
}

TEST(FitStreets, IsEqualWhateverTheOrderOfObservations) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.3);
  std::vector<Observation> seen = kerbs(4.4, 3.2);
  for (Observation& one : seen) one.place.y += noise(random);
  const std::vector<FitAxis> axes{street({{0, 0, 0}, {40, 1, 0}, {100, 0, 0}}, 6)};
  for (bool moves : {false, true}) {
    FitRules rules;
    rules.axes_move = moves;
    const auto first = fit_streets(axes, seen, rules);
    for (int trial = 0; trial < 3; ++trial) {
      std::shuffle(seen.begin(), seen.end(), random);
      const auto again = fit_streets(axes, seen, rules);
      EXPECT_EQ(first.axes[0].width_start, again.axes[0].width_start);
      EXPECT_EQ(first.axes[0].roadway_offset, again.axes[0].roadway_offset);
      for (std::size_t i = 0; i < first.axes[0].line.size(); ++i)
        EXPECT_EQ(first.axes[0].line[i].y, again.axes[0].line[i].y);
      EXPECT_EQ(first.after.mean, again.after.mean);
    }
  }
}

// The slopes of the cost against differences of it, with all kinds of observations and
// regularisers.
TEST(FitStreets, HasTheSlopesOfItsCost) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> along(8, 92), aside(-8, 8), step(-0.4, 0.4);
  for (int trial = 0; trial < 20; ++trial) {
    FitRules rules;
    rules.axes_move = trial % 2 == 0;
    rules.scale = 0.2;
    rules.loss = trial % 3 == 0 ? FitLoss::soft_l1 : FitLoss::cauchy;
    FitAxis axis = street({{0, 0, 0}, {35, 4, 0}, {100, 0, 0}}, 6);
    axis.lanes = 2;
    std::vector<Observation> seen;
    for (int i = 0; i < 60; ++i) {
      Observation one;
      one.place = {along(random), aside(random), 0};
      one.kind = static_cast<ObservationKind>(i % 5);
      one.relation = static_cast<ObservationRelation>(i % 3);
      one.width = 8;
      one.confidence = 0.7;
      one.weight = 1 + i % 4;
      seen.push_back(one);
    }
    const std::vector<FitAxis> axes{axis};
    Unknowns unknowns = vertices_of(axes, rules);
    const FitMatcher matcher(axes, unknowns, seen, rules);
    add_widths(axes, {true}, {true}, rules, unknowns);
    std::vector<double> values = unknowns.origin;
    for (double& value : values) value += step(random);
    std::vector<FitMatch> matches;
    for (std::size_t i = 0; i < seen.size(); ++i)
      matches.push_back(matcher.match(static_cast<int>(i), values));
    const auto cost = [&](const std::vector<double>& at, std::vector<double>* slopes) {
      std::vector<FitMatch> copy = matches;
      return fit_cost(axes, unknowns, seen, matcher, rules, at, copy, rules.scale, slopes);
    };
    std::vector<double> slopes;
    cost(values, &slopes);
    for (std::size_t i = 0; i < values.size(); ++i) {
      // Of the fourth order, so that digits which a large cost loses do not count.
      const double h = 1e-4;
      const auto about = [&](double step) {
        std::vector<double> up = values, down = values;
        up[i] += step;
        down[i] -= step;
        return cost(up, nullptr) - cost(down, nullptr);
      };
      const double difference = (8 * about(h) - about(2 * h)) / (12 * h);
      EXPECT_NEAR(slopes[i], difference, 1e-6 * std::max(1.0, std::abs(difference)))
          << "trial " << trial << " unknown " << i;
    }
  }
}

TEST(FitStreets, SaysWhyNoStreetTakesAnObservation) {
  const auto taken = taken_observations({street({{0, 0, 0}, {100, 0, 0}}, 6)},
                                        {{{50, 3.5, 0}}, {{2, 3.5, 0}}, {{50, 40, 0}}}, FitRules());
  EXPECT_EQ(taken[0].fate, ObservationFate::taken);
  EXPECT_NEAR(taken[0].off, 0.5, 1e-12);
  EXPECT_EQ(taken[1].fate, ObservationFate::at_junction);
  EXPECT_EQ(taken[2].fate, ObservationFate::no_street);
}

TEST(FitStreets, RefusesWhatIsNotFinite) {
  Observation one;
  one.place.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fit_streets({street({{0, 0, 0}, {100, 0, 0}}, 6)}, {one}, FitRules()), Error);
}

}  // namespace
