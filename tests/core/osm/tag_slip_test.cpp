#include <gtest/gtest.h>

#include "read_lanes.hpp"

namespace streetgen {
namespace osm_lanes_test {

TEST(OsmTagSlip, KeysThatArePartedOtherwiseAreNamed) {
  for (const char* key :
       {"turnlanes", "turn_lanes", "turn-lanes:forward", "buslanes", "bus_lanes:forward",
        "lanes_forward", "cycleway_right", "parkinglane", "parking_lane_right", "one_way",
        "max_speed", "lanesforward", "bicycle_lanes"})
    EXPECT_EQ(read({{key, "1"}}), std::string("general | general ?") + key);
}

TEST(OsmTagSlip, KnownWordsThatSayNothingTogetherAreNamed) {
  for (const char* key :
       {"width:forward", "oneway:forward", "lanes:left", "turn:both_ways", "busway:forward",
        "placement:left", "parking:lane", "cycleway:backward", "lanes:taxi"})
    EXPECT_EQ(read({{key, "1"}}), std::string("general | general ?") + key);
}

TEST(OsmTagSlip, TagsOfLanesThatHoldAtTimesAreNamed) {
  for (const char* key : {"oneway:conditional", "lanes:conditional", "turn:lanes:conditional",
                          "motor_vehicle:conditional", "busway:right:conditional"})
    EXPECT_EQ(read({{key, "yes @ (22:00-06:00)"}}), std::string("general | general ?") + key);
  for (const char* key :
       {"maxspeed:conditional", "foot:conditional", "parking:left:fee:conditional"})
    EXPECT_EQ(read({{key, "no"}}), "general | general") << key;
}

TEST(OsmTagSlip, OtherKeysAreNot) {
  for (const char* key :
       {"cycleway:surface", "cycleway:right:buffer", "parking:left:restriction",
        "parking:condition:left", "oneway:foot", "maxspeed:hgv", "maxspeed:bus", "width:source",
        "bridge:name", "lane_markings", "service", "foot", "access", "source:turn_lanes"})
    EXPECT_EQ(read({{key, "no"}}), "general | general") << key;
}

}  // namespace osm_lanes_test
}  // namespace streetgen
