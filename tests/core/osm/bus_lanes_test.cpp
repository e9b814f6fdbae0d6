#include <gtest/gtest.h>

#include "read_lanes.hpp"

namespace streetgen {
namespace osm_lanes_test {

std::string access(const OsmTags& tags) {
  const OsmLanes lanes = read_osm_lanes(tags, {});
  return lanes.access_forward + "|" + lanes.access_backward;
}

TEST(OsmBusLanes, ListsOfBusesOpenAStreetThatIsClosedToCars) {
  for (const char* closed : {"motor_vehicle", "access", "vehicle", "motorcar"})
    for (const char* buses : {"bus:lanes", "psv:lanes", "taxi:lanes"}) {
      const OsmTags one_way = {
          {closed, "no"}, {buses, "designated|designated"}, {"lanes", "2"}, {"oneway", "yes"}};
      EXPECT_EQ(read(one_way), "bus bus | ") << closed << " " << buses;
      EXPECT_EQ(access(one_way), "bus|bus") << closed << " " << buses;
      const OsmTags both = {{closed, "no"}, {buses, "designated|designated"}, {"lanes", "2"}};
      EXPECT_EQ(read(both), "bus | bus") << closed << " " << buses;
      EXPECT_EQ(access(both), "bus|bus") << closed << " " << buses;
    }
  const OsmTags some = {{"access", "no"}, {"bus:lanes", "|designated"}, {"oneway", "yes"}};
  EXPECT_EQ(read(some), "bus bus | ") << "nobody else may drive on the other lane";
  EXPECT_EQ(access({{"access", "no"}, {"lanes:psv", "2"}, {"lanes", "2"}}), "bus|bus");
  EXPECT_EQ(access({{"motor_vehicle", "no"}, {"busway:right", "lane"}}), "bus|cycle");
  EXPECT_EQ(access({{"access", "no"}, {"bus:lanes:forward", "designated"}, {"lanes", "2"}}),
            "bus|no");
  EXPECT_EQ(access({{"access", "no"}, {"bus:lanes", "no|no"}, {"oneway", "yes"}}), "no|no");
}

TEST(OsmBusLanes, KerbsSayTheSidesOfTheLanesThatACountHas) {
  for (const char* count : {"lanes:psv", "lanes:bus"}) {
    const auto one_way = [&](const char* number, OsmTags tags) {
      tags.insert({{"oneway", "yes"}, {"lanes", "3"}, {count, number}});
      return read(tags);
    };
    EXPECT_EQ(one_way("1", {{"busway:left", "lane"}}), "bus general general | ");
    EXPECT_EQ(one_way("1", {{"busway:right", "lane"}}), "general general bus | ");
    EXPECT_EQ(one_way("2", {{"busway:left", "lane"}}), std::string("bus general bus |  ?") + count)
        << "no tag says where the other one lies";
    EXPECT_EQ(one_way("2", {{"busway:both", "lane"}}), "bus general bus | ");
    EXPECT_EQ(one_way("1", {{"busway", "opposite_lane"}}), "general general | bus");
    EXPECT_EQ(one_way("1", {{"busway:left", "opposite_lane"}}), "general general | bus");
    EXPECT_EQ(one_way("2", {{"busway:left", "opposite_lane"}, {"busway:right", "lane"}}),
              "general bus | bus");
    EXPECT_EQ(one_way("1", {{"busway:left", "lane"}, {"oneway:bus", "no"}}),
              "general general | bus");
    EXPECT_EQ(one_way("1", {{"busway:both", "lane"}}), std::string("bus general bus |  ?") + count)
        << "the kerbs have more than are counted";
  }
  EXPECT_EQ(read({{"oneway", "-1"}, {"lanes", "3"}, {"lanes:psv", "1"}, {"busway:right", "lane"}}),
            " | bus general general");
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:psv", "1"}, {"busway:right", "lane"}}),
            "general bus | general");
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:psv", "1"}, {"busway:left", "lane"}}),
            "general | general bus");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:psv", "2"}, {"busway", "lane"}}),
            "general bus | general bus");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:psv:forward", "1"}, {"busway:both", "lane"}}),
            "general bus | general bus");
}

TEST(OsmBusLanes, OppositeLanesThatCannotBeThereAreNamed) {
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"busway:right", "opposite_lane"}}),
            "general | bus ?busway:right");
  EXPECT_EQ(
      read({{"oneway", "yes"}, {"lanes", "2"}, {"busway:left", "opposite_lane"}}, left_hand()),
      "general | bus ?busway:left");
  EXPECT_EQ(read({{"lanes", "2"}, {"busway", "opposite_lane"}}), "general | general ?busway");
}

TEST(OsmBusLanes, AStreetThatOneDirectionHasAtATimeHasNone) {
  EXPECT_EQ(read({{"oneway", "reversible"}, {"lanes", "2"}, {"lanes:psv", "1"}}),
            " |  | 2 ?lanes:psv");
  EXPECT_EQ(read({{"oneway", "reversible"}, {"lanes", "2"}, {"busway:left", "lane"}}),
            " |  | 2 ?busway:left");
}

TEST(OsmBusLanes, BicyclesShareALaneThatThereIs) {
  const OsmTags shared = {{"oneway", "yes"}, {"lanes", "2"}, {"cycleway:right", "share_busway"}};
  const auto with = [&](OsmTags tags) {
    tags.insert(shared.begin(), shared.end());
    return read(tags);
  };
  EXPECT_EQ(with({}), "general general |  ?cycleway:right");
  EXPECT_EQ(with({{"busway:right", "lane"}}), "general bus | ");
  EXPECT_EQ(with({{"access", "no"}, {"bus", "yes"}}), "bus bus | ");
  const OsmTags opposite = {
      {"oneway", "yes"}, {"lanes", "2"}, {"cycleway", "opposite_share_busway"}};
  EXPECT_EQ(read(opposite), "general general |  ?cycleway");
  OsmTags contraflow = opposite;
  contraflow["busway"] = "opposite_lane";
  EXPECT_EQ(read(contraflow), "general | bus");
}

}  // namespace osm_lanes_test
}  // namespace streetgen
