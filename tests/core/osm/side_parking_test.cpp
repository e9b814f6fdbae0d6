#include <gtest/gtest.h>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {
namespace side_parking_test {

// Place, orientation, depth and number of cars on both sides, and what was not read.
std::string parking(const OsmTags& tags) {
  const OsmLanes read = read_osm_lanes(tags, {});
  std::string text;
  for (const OsmSideParking* side : {&read.parking_left, &read.parking_right}) {
    text += (text.empty() ? "" : " / ") + (side->place.empty() ? "-" : side->place);
    if (!side->orientation.empty()) text += " " + side->orientation;
    if (side->depth) text += " " + std::to_string(*side->depth).substr(0, 4) + " m";
    if (side->capacity) text += " x" + std::to_string(*side->capacity);
  }
  for (const UnreadTag& tag : read.unread) text += " ?" + tag.key;
  return text;
}

TEST(OsmSideParking, TheNewSchemeSaysPlaceOrientationWidthAndCapacity) {
  EXPECT_EQ(parking({}), "- / -");
  EXPECT_EQ(parking({{"parking:both", "street_side"}}), "street_side / street_side");
  EXPECT_EQ(parking({{"parking:left", "on_kerb"},
                     {"parking:left:orientation", "diagonal"},
                     {"parking:left:width", "4.2"},
                     {"parking:left:capacity", "12"},
                     {"parking:right", "no"}}),
            "on_kerb diagonal 4.20 m x12 / no");
  EXPECT_EQ(parking({{"parking:both", "half_on_kerb"}, {"parking:left", "no"}}),
            "no / half_on_kerb")
      << "a side alone says more than both";
  EXPECT_EQ(parking({{"parking:both", "separate"}}), "- / - ?parking:both")
      << "no bay is made, and the way is named";
  EXPECT_EQ(parking({{"parking:lane:left", "separate"}}), "- / - ?parking:lane:left");
  EXPECT_EQ(parking({{"parking:right", "shoulder"}}), "- / - ?parking:right");
  EXPECT_EQ(parking({{"parking:right", "lane"}, {"parking:right:capacity", "7"}}), "- / lane x7");
  EXPECT_EQ(parking({{"parking:right", "lane"}}), "- / -") << "the lane says all";
}

TEST(OsmSideParking, TheOlderSchemeSaysThePlaceBeneathTheWayToStand) {
  EXPECT_EQ(parking({{"parking:lane:right", "perpendicular"},
                     {"parking:lane:right:perpendicular", "lay_by"},
                     {"parking:lane:left", "no_stopping"}}),
            "no / street_side perpendicular");
  EXPECT_EQ(
      parking({{"parking:lane:both", "parallel"}, {"parking:lane:both:parallel", "half_on_kerb"}}),
      "half_on_kerb parallel / half_on_kerb parallel");
  EXPECT_EQ(parking({{"parking:lane:both", "parallel"}}), "- / -") << "on lanes";
  EXPECT_EQ(parking({{"parking:lane:both", "fire_lane"}}), "no / no");
  EXPECT_EQ(parking({{"parking:lane:both", "no_parking"}, {"parking:both", "on_kerb"}}),
            "on_kerb / on_kerb")
      << "the new scheme says more";
}

TEST(OsmSideParking, WhatMeansNothingIsNamed) {
  EXPECT_EQ(parking({{"parking:left", "street_side"}, {"parking:left:capacity", "many"}}),
            "street_side / - ?parking:left:capacity");
  EXPECT_EQ(parking({{"parking:left", "street_side"}, {"parking:left:capacity", "1001"}}),
            "street_side / - ?parking:left:capacity");
  EXPECT_EQ(parking({{"parking:left", "street_side"}, {"parking:left:width", "20"}}),
            "street_side / - ?parking:left:width");
}

TEST(OsmSideParking, WhereCarsStandOnALaneTooThatIsALane) {
  for (const char* places : {"lane;half_on_kerb", "half_on_kerb;lane"}) {
    const OsmLanes read = read_osm_lanes({{"lanes", "2"}, {"parking:right", places}}, {});
    EXPECT_EQ(read.forward.size(), 2u) << places;
    EXPECT_EQ(read.parking_right.place, "") << places;
  }
}

TEST(OsmSideParking, SidesAreThoseOfTheWayAsItIsDrawn) {
  EXPECT_EQ(parking({{"oneway", "-1"}, {"parking:left", "on_kerb"}}), "on_kerb / -");
  OsmLaneUse use;
  use.driving_side = DrivingSide::left;
  EXPECT_EQ(read_osm_lanes({{"parking:left", "on_kerb"}}, use).parking_left.place, "on_kerb");
}

TEST(OsmSideParking, SettingsSayHowDeepCarsStandOnLanes) {
  OsmLaneUse use;
  use.diagonal_depth = 4.2;
  use.perpendicular_depth = 5.3;
  const auto width = [&](const char* turned) {
    return read_osm_lanes(
               {{"lanes", "2"}, {"parking:right", "lane"}, {"parking:right:orientation", turned}},
               use)
        .forward.back()
        .width;
  };
  EXPECT_EQ(width("diagonal"), 4.2);
  EXPECT_EQ(width("perpendicular"), 5.3);
}

TEST(OsmSideParking, WhatLiesBesideLanesAndIsNotMadeIsNamed) {
  EXPECT_EQ(parking({{"bus_bay", "right"}}), "- / - ?bus_bay");
  EXPECT_EQ(parking({{"minor_lanes", "1"}}), "- / - ?minor_lanes");
  EXPECT_EQ(parking({{"minor_lanes:forward", "1"}}), "- / - ?minor_lanes:forward");
  EXPECT_EQ(parking({{"shoulder", "both"}, {"shoulder:right:width", "2"}}), "- / - ?shoulder");
  EXPECT_EQ(parking({{"shoulder:left", "yes"}}), "- / - ?shoulder:left");
  EXPECT_EQ(parking({{"shoulder", "no"}, {"bus_bay", "none"}, {"minor_lanes", "0"}}), "- / -");
}

}  // namespace side_parking_test
}  // namespace streetgen
