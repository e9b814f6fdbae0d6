#include "streetgen/osm_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "read_lanes.hpp"
#include "rounds.hpp"

namespace streetgen {
namespace osm_lanes_test {

TEST(OsmLanes, LanesAmongSeveralWords) {
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway", "lane;shared_lane"}}),
            "general cycle | general cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:both", "track;lane"}}),
            "general cycle | general cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:right", "soft_lane"}}), "general cycle | general");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "1"}, {"cycleway", "lane;opposite_lane"}}),
            "general cycle | cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:right", "track;separate"}}), "general | general");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:both", "half_on_kerb;lane"}}),
            "general parking | general parking");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:lane:right", "no_parking;parallel"}}),
            "general parking | general");
  EXPECT_EQ(read({{"lanes", "4"}, {"busway", "lane;lane"}}), "general bus | general bus");
}

// Of a two-way street whose lanes are unknown.
TEST(OsmLanes, OneLaneWhereKerbsLeaveNoRoomForTwo) {
  OsmLaneUse use;
  const auto of_width = [&](double width, const OsmTags& tags) {
    use.roadway_width = width;
    return read(tags, use);
  };
  const OsmTags parking{{"parking:both", "lane"}};
  EXPECT_EQ(of_width(7, parking), "parking | parking | 1");
  EXPECT_EQ(of_width(9, parking), "general parking | general parking");
  EXPECT_EQ(of_width(6, {{"cycleway", "lane"}}), "cycle | cycle | 1");
  EXPECT_EQ(of_width(5, {{"parking:right", "lane"}}), "parking |  | 1");
  use.roadway_width = 5;
  EXPECT_EQ(read_osm_lanes({{"parking:right", "lane"}}, use).lane_count, 1);
  EXPECT_EQ(of_width(4, {}), "general | general") << "a width alone is judged by the model";
  EXPECT_EQ(of_width(7, {{"parking:both", "lane"}, {"lanes", "2"}}),
            "general parking | general parking")
      << "stated lanes stay";
  EXPECT_EQ(of_width(7, {{"parking:both", "lane"}, {"oneway", "yes"}}),
            "parking general parking | ");
}

TEST(OsmLanes, MarksOfAWholeDirection) {
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"turn", "left;through"}}),
            "general:left;through general:left;through | ");
  EXPECT_EQ(read({{"oneway", "-1"}, {"lanes", "1"}, {"turn", "right"}}), " | general:right");
  EXPECT_EQ(read({{"lanes", "2"}, {"turn:backward", "right"}, {"cycleway", "lane"}}),
            "general cycle | general:right cycle");
  EXPECT_EQ(read({{"lanes", "4"}, {"turn:forward", "right"}, {"turn:lanes:forward", "left|"}}),
            "general:left general | general general");
  EXPECT_EQ(read({{"lanes", "2"}, {"turn", "left"}}), "general | general ?turn");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "1"}, {"turn", "yes"}}), "general |  ?turn");
  EXPECT_EQ(read({{"oneway", "yes"}, {"turn", "left"}}), "general |  ?turn");
}

TEST(OsmLanes, WhatMakesNoLaneIsNamed) {
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"oneway:bus", "no"}}),
            "general general |  ?oneway:bus");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:left", "yes"}}), "general | general ?cycleway:left");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:right", "yes"}}), "general | general ?parking:right");
  EXPECT_EQ(read({{"lanes", "2"}, {"access", "designated|designated"}}),
            "general | general ?access");
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:both_ways", "1"}, {"centre_turn_lane", "-1"}}),
            "general | general | 1 ?centre_turn_lane");
  EXPECT_EQ(read({{"lanes", "2"}, {"hov:forward", "designated"}}), "carpool | general");
}

TEST(OsmLanes, CountsOfTagLanes) {
  EXPECT_EQ(read({}), "general | general");
  EXPECT_EQ(read({{"lanes", "4"}}), "general general | general general");
  EXPECT_EQ(read({{"lanes", "1"}}), " |  | 1");
  EXPECT_EQ(read({{"lanes", "3"}}), "general | general | 1 ?lanes")
      << "the same for both directions, and told";
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:forward", "2"}, {"turn:lanes:forward", "left||right"}}),
            "general:left general general:right | general general ?lanes:forward ?lanes")
      << "lanes that a list overrules are told";
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:forward", "2"}}), "general general | general");
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:backward", "2"}}), "general | general general");
  EXPECT_EQ(read({{"lanes", "5"}, {"lanes:forward", "2"}, {"lanes:both_ways", "1"}}),
            "general general | general general | 1");
  EXPECT_EQ(read({{"lanes", "2"}, {"oneway", "yes"}}), "general general | ");
  EXPECT_EQ(read({{"lanes", "2"}, {"oneway", "-1"}}), " | general general");
  EXPECT_EQ(read({{"lanes:forward", "3"}, {"oneway", "yes"}}), "general general general | ");
  for (const char* none : {"2;3", "1.5", "many", "0", "-2", "31", "2 lanes"})
    EXPECT_EQ(read({{"lanes", none}}), "general | general ?lanes") << none;
  EXPECT_EQ(read({{"lanes", "2.0"}}), "general | general");
  EXPECT_EQ(read({{"lanes", "2"}, {"lanes:forward", "2"}}), "general general | general ?lanes");
  EXPECT_EQ(read_osm_lanes({{"lanes", "3"}, {"oneway", "yes"}}, {}).lane_count, 3);
  EXPECT_FALSE(read_osm_lanes({}, {}).lane_count);
  EXPECT_FALSE(read_osm_lanes({{"lanes", "4"}}, {}).forward_known);
}

TEST(OsmLanes, OneWayStreetsOfUnknownLanesHaveTheUsualOnes) {
  OsmLaneUse use;
  use.usual_lanes = 3;
  EXPECT_EQ(read({{"oneway", "yes"}, {"cycleway:right", "lane"}}, use),
            "general general general cycle | ");
  EXPECT_FALSE(read_osm_lanes({{"oneway", "yes"}}, use).forward_known);
  EXPECT_EQ(read({{"highway", "motorway"}}, use), "general general general | ");
  EXPECT_EQ(read({{"highway", "motorway"}, {"oneway", "no"}}, use), "general | general");
  const OsmTags link = {{"highway", "motorway_link"}, {"lanes", "3"}};
  const auto with = [&](OsmTags tags) {
    tags.insert(link.begin(), link.end());
    return read(tags);
  };
  EXPECT_EQ(with({}), "general general general | ");
  EXPECT_EQ(with({{"lanes:backward", "1"}}), "general general | general")
      << "stated lanes go before what a class implies";
  EXPECT_EQ(with({{"lanes:backward", "0"}}), "general general general | ");
  EXPECT_EQ(with({{"lanes:backward", "some"}}), "general general general |  ?lanes:backward");
  EXPECT_EQ(with({{"lanes:backward", "1"}, {"oneway", "yes"}, {"oneway:bus", "no"}}),
            "general general | bus");
  EXPECT_EQ(with({{"lanes:backward", "1"}, {"oneway:bus", "no"}}), "general general | bus");
  EXPECT_EQ(read({{"junction", "roundabout"}, {"lanes", "2"}, {"lanes:backward", "1"}}),
            "general | bus ?lanes:backward")
      << "nobody drives round both ways";
}

TEST(OsmLanes, ListsGoFromLeftToRightInDrivingDirection) {
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "3"},
                  {"turn:lanes", "left|through;Right | none"},
                  {"width:lanes", "3.5|3 m|"},
                  {"change:lanes", "no|not_left|yes"}}),
            "general:left/no=3.50 general:through;right/not_left=3.00 general:none/yes | ");
  EXPECT_EQ(read({{"oneway", "-1"}, {"lanes", "2"}, {"turn:lanes", "left|"}}),
            " | general:left general");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes:forward", "3"},
                  {"turn:lanes:forward", "left|through|right"},
                  {"width:lanes:forward", "3.2|3.2|3.2"}}),
            "general:left=3.20 general:through=3.20 general:right=3.20 | ");
  EXPECT_EQ(read({{"lanes", "3"}, {"turn:lanes:forward", "left|right"}}),
            "general:left general:right | general")
      << "a list says how lanes are shared";
  EXPECT_EQ(read({{"turn:lanes", "left|right"}}), "general | general ?turn:lanes");
  EXPECT_EQ(read({{"lanes", "4"}, {"bus:lanes", "yes|designated"}, {"lanes:bus", "2"}}),
            "general bus | general bus")
      << "a list of half of the lanes speaks of each direction";
}

TEST(OsmLanes, AWordThatMeansNothingIsLostAlone) {
  const auto turns = [](const std::string& list) {
    return read({{"oneway", "yes"}, {"lanes", "2"}, {"turn:lanes", list}});
  };
  EXPECT_EQ(turns("left|next_lane"), "general:left general |  ?turn:lanes");
  for (const char* strange :
       {"left;next_lane", "left,right", "left;left;left;left;left;left;left;left;left;left;left"})
    EXPECT_EQ(turns(strange + std::string("|through")), "general general:through |  ?turn:lanes")
        << strange;
  for (const char* empty : {"left;right;", ";left;right", "left;;right"})
    EXPECT_EQ(turns(empty + std::string("|;")), "general:left;right general | ") << empty;
  const auto widths = [](const std::string& list) {
    return read({{"oneway", "yes"}, {"lanes", "2"}, {"width:lanes", list}});
  };
  for (const char* strange : {"-3", "0", "0.01", "99.9999", "1e3", "wide", "nan"})
    EXPECT_EQ(widths(strange + std::string("|3")), "general general=3.00 |  ?width:lanes")
        << strange;
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"change:lanes", "never|no"}}),
            "general general/no |  ?change:lanes");
  for (const char* strange : {"-1", "0", "50", "much"})
    EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:right", "lane"}, {"cycleway:right:width", strange}}),
              "general cycle | general ?cycleway:right:width")
        << strange;
  EXPECT_EQ(
      read({{"lanes", "2"}, {"cycleway:right", "lane"}, {"cycleway:right:est_width", "1.25"}}),
      "general cycle=1.25 | general");
  EXPECT_EQ(read({{"lanes", "2"},
                  {"cycleway:right", "lane"},
                  {"cycleway:right:width", "wide"},
                  {"cycleway:est_width", "1.25"}}),
            "general cycle=1.25 | general ?cycleway:right:width");
  for (const char* key : {"maxspeed:lanes", "maxspeed:lanes:forward"}) {
    for (const char* strange : {"fast|50", "50|", "50|none", "30 mph|DE:urban"})
      EXPECT_EQ(read({{key, strange}}),
                *strange == 'f' ? std::string("general | general ?") + key : "general | general")
          << strange;
  }
}

TEST(OsmLanes, WordsOfListsAreNoWordsOfAWay) {
  for (const char* key : {"motor_vehicle", "access", "bus", "motorcar:forward"})
    EXPECT_EQ(read({{key, "lane"}}), std::string("general | general ?") + key);
  EXPECT_EQ(read({{"access", "designated"}}), "general | general");
}

TEST(OsmLanes, WidthsOfLanesThatTheStreetHasNoRoomForAreNamed) {
  OsmLaneUse use;
  const OsmTags tags = {{"oneway", "yes"}, {"lanes", "2"}, {"width:lanes", "3|3"}};
  for (const double wide : {5.6, 6.0, 6.2, 9.0}) {
    use.roadway_width = wide;
    EXPECT_EQ(read(tags, use), "general=3.00 general=3.00 | ") << wide;
  }
  use.roadway_width = 5;
  EXPECT_EQ(read(tags, use), "general=3.00 general=3.00 |  ?width:lanes");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"width:lanes", "3|"}}, use),
            "general=3.00 general | ")
      << "a lane without a width takes what is left";
}

TEST(OsmLanes, UnknownLanesBesideACycleLaneAreTheSameForBothDirections) {
  OsmLaneUse use;
  use.roadway_width = 14;
  use.usual_lanes = 4;
  EXPECT_EQ(read({{"cycleway:right", "lane"}}, use), "general general cycle | general general");
  EXPECT_EQ(read({{"cycleway:left", "lane"}}, use), "general general | general general cycle");
  EXPECT_EQ(read({{"parking:both", "lane"}, {"cycleway:right", "lane"}}, use),
            "general cycle parking | general parking");
  use.roadway_width = 6;
  use.usual_lanes = 2;
  EXPECT_EQ(read({{"cycleway:right", "lane"}}, use), "general cycle | general");
  EXPECT_EQ(read({{"cycleway:right", "lane"}, {"lanes", "2"}}, use), "general cycle | general");
}

TEST(OsmLanes, UnknownLanesOfAOneWayStreetHaveRoomBesideThoseOfTheKerbs) {
  OsmLaneUse use;
  use.roadway_width = 7;
  use.usual_lanes = 2;
  EXPECT_EQ(read({{"oneway", "yes"}}, use), "general general | ");
  EXPECT_EQ(read({{"oneway", "yes"}, {"busway", "lane"}}, use), "general bus | ");
  EXPECT_EQ(read({{"oneway", "yes"}, {"parking:right", "lane"}}, use), "general parking | ");
  EXPECT_EQ(read({{"oneway", "-1"}, {"cycleway", "opposite_lane"}}, use), "cycle | general general")
      << "2.75 m each";
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"parking:right", "lane"}}, use),
            "general general parking | ")
      << "stated lanes stay";
  use.roadway_width = 3;
  use.usual_lanes = 1;
  EXPECT_EQ(read({{"oneway", "yes"}, {"parking:both", "lane"}}, use), "parking general parking | ")
      << "one is left where there is no room";
}

TEST(OsmLanes, MisspeltKeysAreNamed) {
  for (const char* key : {"turns:lanes", "Turn:lanes", "turn:lane", "Oneway", "onway", "lane",
                          "Lanes", "lanes:foward", "bus:lane", "cicleway", "LANES:Backward"})
    EXPECT_EQ(read({{key, "1"}}), std::string("general | general ?") + key);
  for (const char* key :
       {"access:motorcar", "access:bus", "access:motor_vehicle", "width:feet", "width:m"})
    EXPECT_EQ(read({{key, "7"}}), std::string("general | general ?") + key);
  for (const char* key : {"surface", "name", "maxspeed", "lit", "foot", "layer", "sidewalk",
                          "source:lanes", "lane_markings", "oneway:foot", "width", "bridge", "taxi",
                          "hgv", "goods", "shoulder", "overtaking"})
    EXPECT_EQ(read({{key, "no"}}), "general | general") << key;
}

TEST(OsmLanes, ListsCountAllLanesAndTagLanesThoseOfCars) {
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "3"},
                  {"turn:lanes", "left|through|through|right"},
                  {"vehicle:lanes", "yes|yes|no|yes"},
                  {"bicycle:lanes", "yes|no|designated|yes"},
                  {"width:lanes", "3|3|1.5|3.5"}}),
            "general:left=3.00 general:through=3.00 cycle:through=1.50 general:right=3.50 | ");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"turn:lanes", "through|through|right"},
                  {"bicycle:lanes", "|designated|"}}),
            "general:through cycle:through general:right | ");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"turn:lanes", "through|through|right"},
                  {"cycleway:lanes", "none|lane|none"}}),
            "general:through cycle:through general:right | ");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"turn:lanes", "through|right"},
                  {"bicycle:lanes", "|designated|"}}),
            "general:through cycle general:right | ")
      << "a list of cars leaves out the cycle lane";
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"bicycle:lanes", "|designated"}}),
            "general general | ")
      << "bicycles may use a lane that cars are counted on";
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "3"},
                  {"vehicle:lanes", "||no"},
                  {"bicycle:lanes", "||designated"}}),
            "general general cycle |  ?lanes")
      << "lanes counts the cycle lane too";
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"turn:lanes", "left|through|"},
                  {"cycleway:right", "lane"}}),
            "general:left general:through cycle | ")
      << "a list counts the cycle lane at the kerb";
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"turn:lanes", "left|through|right"}}),
            "general:left general:through general:right |  ?lanes");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "4"}, {"turn:lanes", "left|through|right"}}),
            "general general general general |  ?turn:lanes")
      << "it lands on no other lane's place";
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "3"},
                  {"turn:lanes", "left||"},
                  {"change:lanes", "no|no|no|no"}}),
            "general:left general general |  ?change:lanes");
}

TEST(OsmLanes, LanesOfListsThatAreCalledLane) {
  const auto one_way = [](const char* lanes, OsmTags tags) {
    tags.insert({{"oneway", "yes"}, {"lanes", lanes}});
    return read(tags);
  };
  EXPECT_EQ(one_way("2", {{"bicycle:lanes", "||lane"}}), "general general cycle | ");
  EXPECT_EQ(one_way("2", {{"bicycle:lanes", "||designated"}}), "general general cycle | ");
  EXPECT_EQ(one_way("3", {{"bicycle:lanes", "||lane"}}), "general general cycle |  ?lanes");
  for (const char* key : {"bus:lanes", "psv:lanes", "taxi:lanes"})
    EXPECT_EQ(one_way("2", {{key, "lane|"}}), "bus general | ") << key;
  EXPECT_EQ(one_way("2", {{"hov:lanes", "lane|"}}), "carpool general | ");
  for (const char* key : {"access:lanes", "motor_vehicle:lanes"})
    for (const char* word : {"|destination", "|lane", "|delivery"})
      EXPECT_EQ(one_way("2", {{key, word}}), std::string("general general |  ?") + key) << word;
}

TEST(OsmLanes, LanesForBusesTaxisAndCarpools) {
  const OsmTags one_way = {{"oneway", "yes"}, {"lanes", "3"}};
  const auto with = [&](OsmTags tags) {
    tags.insert(one_way.begin(), one_way.end());
    return read(tags);
  };
  EXPECT_EQ(with({{"bus:lanes", "||designated"}, {"vehicle:lanes", "||no"}}),
            "general general bus | ");
  EXPECT_EQ(with({{"psv:lanes", "yes|yes|designated"}, {"access:lanes", "||no"}}),
            "general general bus | ");
  EXPECT_EQ(with({{"bus:lanes", "||yes"}, {"motor_vehicle:lanes", "yes|yes|no"}}),
            "general general bus | ");
  EXPECT_EQ(with({{"taxi:lanes", "||designated"}, {"access:lanes", "||no"}}),
            "general general bus | ");
  EXPECT_EQ(with({{"hov:lanes", "designated||"}}), "carpool general general | ");
  EXPECT_EQ(with({{"psv:lanes", "||designated"}, {"bicycle:lanes", "||designated"}}),
            "general general bus | ")
      << "bicycles on a bus lane";
  EXPECT_EQ(with({{"vehicle:lanes", "||no"}, {"change:lanes", "no|no|no"}}),
            "general/no general/no closed/no |  ?vehicle:lanes");
  EXPECT_EQ(with({{"access:lanes", "private|yes|yes"}}), "closed general general |  ?access:lanes")
      << "nobody says that buses drive there";
  EXPECT_EQ(with({{"access:lanes", "private|yes|yes"}, {"psv", "yes"}}), "bus general general | ");
  EXPECT_EQ(with({{"access:lanes", "private|yes|yes"}, {"bicycle:lanes", "designated||"}}),
            "cycle general general |  ?lanes");
  EXPECT_EQ(with({{"parking:lanes", "||designated"}}), "general general general |  ?parking:lanes");
  EXPECT_EQ(with({{"hov", "designated"}}), "carpool carpool carpool | ");
  EXPECT_EQ(with({{"hov", "designated"}, {"hov:lanes", "designated||"}}),
            "carpool general general | ")
      << "a list says which";
  EXPECT_EQ(with({{"hov", "lane"}}), "general general general |  ?hov");
  EXPECT_EQ(with({{"lanes:bus", "1"}}), "general general bus |  ?lanes:bus")
      << "no tag says at which kerb";
  EXPECT_EQ(with({{"busway", "lane"}}), "general general bus | ");
  EXPECT_EQ(with({{"busway:left", "lane"}, {"turn:lanes", "left|through|through"}}),
            "bus:left general:through general:through | ");
  EXPECT_EQ(with({{"busway", "lane"}, {"psv:lanes", "yes|designated|yes"}}),
            "general bus general | ")
      << "a list goes before a kerb";
}

TEST(OsmLanes, BusLanesOfStreetsOfBothDirections) {
  EXPECT_EQ(read({{"lanes", "3"},
                  {"lanes:forward", "1"},
                  {"lanes:backward", "1"},
                  {"lanes:psv:forward", "1"}}),
            "general bus | general ?lanes:psv:forward")
      << "lanes:forward leaves the bus lane out";
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:forward", "2"}, {"lanes:psv:forward", "1"}}),
            "general bus | general ?lanes:psv:forward");
  EXPECT_EQ(read({{"lanes", "3"}, {"busway:right", "lane"}}), "general bus | general");
  EXPECT_EQ(read({{"lanes", "3"}, {"busway:left", "lane"}}), "general | general bus");
  EXPECT_EQ(read({{"lanes", "4"}, {"busway", "lane"}}), "general bus | general bus");
  EXPECT_EQ(read({{"busway", "lane"}}), "general bus | general bus");
  EXPECT_EQ(read({{"lanes", "1"}, {"busway", "lane"}}), "general bus | general bus ?lanes");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:psv", "2"}}), "general bus | general bus ?lanes:psv");
  EXPECT_EQ(read({{"lanes", "3"}, {"lanes:psv", "1"}}), "general | general | 1 ?lanes:psv ?lanes");
  EXPECT_EQ(read({{"busway", "designated"}}), "general | general ?busway");
}

TEST(OsmLanes, StreetsForBusesAlone) {
  EXPECT_EQ(read({{"access", "no"}, {"bus", "yes"}, {"psv", "yes"}, {"lanes", "2"}}), "bus | bus");
  EXPECT_EQ(read({{"motor_vehicle", "no"}, {"psv", "yes"}, {"lanes", "2"}}), "bus | bus");
  EXPECT_EQ(read({{"highway", "busway"}, {"lanes", "2"}}), "bus | bus");
  EXPECT_EQ(read({{"highway", "busway"}}), "bus | bus");
  EXPECT_EQ(read({{"motor_vehicle:backward", "no"}, {"bus:backward", "designated"}}),
            "general | bus");
  EXPECT_EQ(read({{"access", "no"}, {"lanes", "2"}}), "general | general");
  const OsmTags closed = {{"access", "no"}, {"bus", "yes"}};
  const auto with = [&](OsmTags tags) {
    tags.insert(closed.begin(), closed.end());
    return read(tags);
  };
  EXPECT_EQ(with({{"busway", "lane"}}), "bus | bus") << "its lanes are the bus lanes";
  EXPECT_EQ(with({{"busway", "lane"}, {"lanes", "2"}}), "bus | bus");
  EXPECT_EQ(with({{"busway:right", "lane"}, {"oneway", "yes"}}), "bus | ");
  EXPECT_EQ(with({{"busway", "opposite_lane"}, {"oneway", "yes"}}), "bus | bus");
  EXPECT_EQ(with({{"lanes:psv:forward", "2"}, {"lanes:psv:backward", "1"}}), "bus bus | bus");
  EXPECT_EQ(with({{"lanes", "2"}, {"lanes:psv", "2"}}), "bus | bus");
  EXPECT_EQ(read({{"highway", "busway"}, {"busway:both", "lane"}}), "bus | bus");
  for (const char* word : {"private", "permit", "agricultural;private", "residents"})
    EXPECT_EQ(read({{"access", word}, {"psv", "yes"}, {"lanes", "2"}}), "bus | bus") << word;
  for (const char* word : {"destination", "delivery", "private;destination", "customers"})
    EXPECT_EQ(read({{"motor_vehicle", word}, {"bus", "yes"}, {"lanes", "2"}}),
              "general | general ?bus")
        << word;
  EXPECT_EQ(read({{"access", "private"}, {"bus", "no"}, {"lanes", "2"}}), "general | general");
  EXPECT_EQ(read({{"access", "no"}, {"motor_vehicle", "yes"}, {"bus", "yes"}, {"lanes", "2"}}),
            "general | general");
}

TEST(OsmLanes, LanesAgainstTheTrafficOfOneWayStreets) {
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"oneway:bus", "no"},
                  {"lanes", "3"},
                  {"lanes:forward", "2"},
                  {"lanes:backward", "1"},
                  {"bus:lanes:backward", "designated"},
                  {"vehicle:lanes:forward", "no|yes"},
                  {"bus:lanes:forward", "designated|yes"}}),
            "bus general | bus");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"oneway:bus", "no"},
                  {"lanes", "3"},
                  {"lanes:forward", "2"},
                  {"lanes:backward", "1"},
                  {"bus:lanes:backward", "yes"},
                  {"vehicle:lanes:forward", "no|yes"}}),
            "bus general | bus");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"lanes:forward", "1"},
                  {"lanes:backward", "1"},
                  {"access:lanes:backward", "no"},
                  {"psv:lanes:backward", "designated"}}),
            "general | bus");
  EXPECT_EQ(
      read({{"oneway", "yes"}, {"oneway:psv", "no"}, {"lanes", "3"}, {"lanes:backward", "1"}}),
      "general general | bus")
      << "without a list";
  EXPECT_EQ(read({{"oneway", "yes"}, {"oneway:psv", "no"}, {"lanes", "3"}, {"lanes:forward", "2"}}),
            "general general | bus");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"lanes:backward", "1"}}),
            "general | bus ?lanes:backward")
      << "nobody is said to drive there";
  for (const OsmTags& of_buses :
       {OsmTags{{"bus", "no"}}, OsmTags{{"maxspeed:bus", "50"}}, OsmTags{{"psv", "yes"}},
        OsmTags{{"bus:lanes:forward", "yes"}}, OsmTags{{"oneway:bus", "yes"}}}) {
    OsmTags tags = {
        {"oneway", "yes"}, {"lanes", "2"}, {"lanes:backward", "1"}, {"oneway:bicycle", "no"}};
    tags.insert(of_buses.begin(), of_buses.end());
    EXPECT_EQ(read(tags), "general | cycle") << of_buses.begin()->first << " is none against it";
  }
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"busway", "opposite_lane"}}),
            "general | bus");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"turn:lanes:backward", "left"}}),
            "general general |  ?turn:lanes:backward");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "2"},
                  {"bus:lanes:forward", "yes|designated"},
                  {"bus:lanes:backward", "yes|designated"}}),
            "general bus |  ?bus:lanes:backward")
      << "lanes counts none of those";
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "1"}, {"bicycle:lanes:backward", "designated"}}),
            "general | cycle");
}

TEST(OsmLanes, CycleLanesAtKerbs) {
  const auto one_way = [&](OsmTags tags, const OsmLaneUse& use = {}) {
    tags["oneway"] = "yes";
    return read(tags, use);
  };
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway", "lane"}}), "general cycle | general cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:both", "lane"}, {"cycleway:both:lane", "advisory"}}),
            "general cycle | general cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:left", "lane"}, {"cycleway:left:width", "2"}}),
            "general | general cycle=2.00");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:left", "lane"}, {"cycleway:left:oneway", "-1"}}),
            "general | general cycle");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway:right", "lane"}, {"cycleway:right:oneway", "no"}}),
            "general cycle | general ?cycleway:right")
      << "the lane for both is told";
  EXPECT_EQ(one_way({{"cycleway", "opposite"}, {"oneway:bicycle", "no"}}), "general | ");
  EXPECT_EQ(one_way({{"cycleway", "opposite_lane"}}), "general | cycle");
  EXPECT_EQ(one_way({{"cycleway:left", "lane"}, {"oneway:bicycle", "no"}}), "general | cycle");
  EXPECT_EQ(one_way({{"cycleway:left", "lane"}}), "cycle general | ");
  EXPECT_EQ(one_way({{"cycleway:left", "lane"}, {"cycleway:left:oneway", "no"}}),
            "cycle general | cycle")
      << "a lane of each direction";
  EXPECT_EQ(one_way({{"cycleway:left", "lane"},
                     {"cycleway:left:oneway", "-1"},
                     {"cycleway:right", "lane"},
                     {"oneway:bicycle", "no"}}),
            "general cycle | cycle");
  EXPECT_EQ(one_way({{"cycleway", "lane"}}, left_hand()), "cycle general | ");
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway", "track"}}), "general | general");
  EXPECT_EQ(read({{"lanes", "2"},
                  {"cycleway", "lane"},
                  {"access:lanes:forward", "bicycle|yes"},
                  {"access:lanes:backward", "bicycle|yes"},
                  {"bicycle:lanes:forward", "designated|yes"},
                  {"bicycle:lanes:backward", "designated|yes"},
                  {"vehicle:lanes:forward", "no|yes"},
                  {"vehicle:lanes:backward", "no|yes"},
                  {"width:lanes:forward", "1.5|2.5"},
                  {"width:lanes:backward", "1.5|2.5"}},
                 left_hand()),
            "cycle=1.50 general=2.50 | cycle=1.50 general=2.50")
      << "no lane is made twice";
  EXPECT_EQ(read({{"lanes", "3"},
                  {"lanes:forward", "2"},
                  {"lanes:backward", "1"},
                  {"cycleway:left", "lane"},
                  {"cycleway:left:lane", "advisory"},
                  {"cycleway:right", "no"},
                  {"turn:lanes:forward", "left|"},
                  {"vehicle:lanes:backward", "yes|yes"},
                  {"bicycle:lanes:backward", "yes|designated"}}),
            "general:left general | general cycle");
}

TEST(OsmLanes, ParkingLanesLieOutermost) {
  EXPECT_EQ(read({{"lanes", "2"}, {"cycleway", "lane"}, {"parking:right", "lane"}}),
            "general cycle parking | general cycle");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "1"}, {"parking:lane:both", "parallel"}}),
            "parking general parking | ");
  EXPECT_EQ(read({{"oneway", "yes"},
                  {"lanes", "1"},
                  {"parking:lane:both", "parallel"},
                  {"cycleway", "opposite_lane"}}),
            "general parking | cycle parking");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:right", "street_side"}}), "general | general");
  EXPECT_EQ(read({{"lanes", "2"},
                  {"parking:both", "lane"},
                  {"parking:right:width", "2.4 m"},
                  {"parking:left:orientation", "diagonal"}}),
            "general parking=2.40 | general parking=4.50");
  EXPECT_EQ(read({{"lanes", "2"},
                  {"parking:both", "lane"},
                  {"parking:both:width", "-2"},
                  {"parking:both:orientation", "perpendicular"}}),
            "general parking=5.00 | general parking=5.00 ?parking:both:width");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:lane:right", "diagonal"}}),
            "general parking=4.50 | general");
  const OsmTags parallel = {{"lanes", "2"}, {"parking:lane:right", "parallel"}};
  const auto with = [&](OsmTags tags) {
    tags.insert(parallel.begin(), parallel.end());
    return read(tags);
  };
  for (const char* off : {"on_kerb", "half_on_kerb", "shoulder", "street_side", "lay_by"})
    for (const char* key : {"parking:lane:right:parallel", "parking:lane:both:parallel"})
      EXPECT_EQ(with({{key, off}}), "general | general") << key << "=" << off;
  for (const char* on : {"on_street", "lane", "painted_area_only"})
    EXPECT_EQ(with({{"parking:lane:right:parallel", on}}), "general parking | general") << on;
  EXPECT_EQ(with({{"parking:lane:right:diagonal", "on_kerb"}}), "general parking | general")
      << "no car stands so";
  EXPECT_EQ(with({{"parking:lane:right:parallel", "kerb"}}),
            "general | general ?parking:lane:right:parallel");
  EXPECT_EQ(with({{"parking:right", "on_kerb"}}), "general | general")
      << "the newer scheme goes before the older one";
}

TEST(OsmLanes, CarsThatStandAcrossTheStreetLeaveItsLanes) {
  OsmLaneUse use;
  const OsmTags tags = {{"lanes", "2"},
                        {"width", "9"},
                        {"parking:right", "lane"},
                        {"parking:right:orientation", "diagonal"}};
  use.roadway_width = 10;
  EXPECT_EQ(read(tags, use), "general parking=4.50 | general");
  use.roadway_width = 9;
  EXPECT_EQ(read(tags, use), "general parking=3.75 | general ?width")
      << "2.625 m are left to each lane";
  use.roadway_width = 6;
  EXPECT_EQ(read(tags, use), "general parking=2.00 | general ?width") << "as along the street";
  OsmTags stated = tags;
  stated["parking:right:width"] = "4.5";
  EXPECT_EQ(read(stated, use), "general parking=4.50 | general");
}

TEST(OsmLanes, LanesInTheMiddle) {
  EXPECT_EQ(read({{"lanes", "3"}, {"turn:lanes:both_ways", "left"}}), "general | general | 1");
  EXPECT_EQ(read({{"lanes", "3"}, {"turn:lanes:both_ways", "left;reverse"}}),
            "general | general | 1 ?turn:lanes:both_ways")
      << "nobody turns back there but where one may everywhere";
  EXPECT_EQ(read({{"lanes", "3"}, {"turn:lanes:both_ways", "through"}}),
            "general | general | 1 ?turn:lanes:both_ways");
  EXPECT_EQ(read({{"lanes", "5"}, {"centre_turn_lane", "yes"}}),
            "general general | general general | 1");
  EXPECT_EQ(read({{"lanes", "4"}, {"centre_turn_lane", "yes"}}),
            "general general | general general | 1 ?centre_turn_lane");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:reversible", "2"}}), "general | general | 2");
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"lanes:both_ways", "1"}}),
            "general general |  ?lanes:both_ways");
  EXPECT_EQ(read({{"lanes", "2"}, {"lanes:both_ways", "1"}}), "general | general | 1 ?lanes")
      << "it does not count the lane in the middle";
  EXPECT_EQ(read({{"lanes", "2"}, {"turn:lanes:both_ways", "left"}}),
            "general | general | 1 ?lanes");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:both_ways", "1"}}),
            "general general | general general | 1 ?lanes");
  EXPECT_EQ(read({{"lanes", "4"}, {"lanes:both_ways", "1"}, {"busway:right", "lane"}}),
            "general bus | general | 1");
  EXPECT_EQ(read({{"lanes", "1"}, {"lanes:both_ways", "1"}}), " |  | 1");
  EXPECT_EQ(read({{"lanes", "1"}, {"turn:lanes:both_ways", "left"}}),
            "general | general | 1 ?lanes");
  EXPECT_EQ(read({{"oneway", "reversible"}, {"lanes", "2"}}), " |  | 2");
  EXPECT_EQ(read({{"oneway", "alternating"}, {"lanes", "1"}}), " |  | 1");
  EXPECT_EQ(read({{"oneway", "reversible"}}), " |  | 2 ?oneway");
  EXPECT_EQ(read({{"oneway", "alternating"}}), " |  | 1 ?oneway");
  EXPECT_EQ(read({{"oneway", "reversible"}, {"lanes:forward", "1"}, {"lanes:backward", "2"}}),
            " |  | 3 ?lanes:forward ?lanes:backward");
  EXPECT_EQ(read({{"oneway", "reversible"}, {"lanes", "3"}, {"lanes:reversible", "1"}}),
            " |  | 3 ?lanes");
}

TEST(OsmLanes, WhatIsNotReadIsNamed) {
  EXPECT_EQ(read({{"lanes:psv:conditional", "1 @ (Mo-Fr)"}}),
            "general | general ?lanes:psv:conditional");
  EXPECT_EQ(read({{"lanes:forward", "30"}, {"lanes:backward", "1"}}),
            " |  ?lanes:backward ?lanes:forward");
  EXPECT_EQ(read({{"source:lanes", "survey"}}), "general | general");
  EXPECT_EQ(read({{"oneway", "maybe"}}), "general | general ?oneway");
  EXPECT_EQ(read({{"destination:lanes", "Lyon|Paris"}}), "general | general")
      << "it says nothing of lanes";
  EXPECT_EQ(read({{"cycleway:right", "track"}, {"cycleway:right:lane", "exclusive"}}),
            "general | general ?cycleway:right:lane");
  std::string wide = "8";
  for (int i = 1; i < 28; ++i) wide += "|8";
  EXPECT_EQ(
      read_osm_lanes(
          {{"oneway", "yes"}, {"lanes", "28"}, {"width:lanes", wide}, {"placement", "left_of:1"}},
          {})
          .unread.at(0)
          .key,
      "placement")
      << "a way lies no farther than 100 m from its lanes";
}

TEST(OsmLanes, PlacementByTheWidthsOfLanes) {
  const auto offset = [](const OsmTags& tags) {
    return read_osm_lanes(tags, {}).roadway_offset.value_or(99);
  };
  EXPECT_DOUBLE_EQ(offset({{"oneway", "yes"}, {"lanes", "3"}, {"placement", "right_of:1"}}), -1.75);
  EXPECT_DOUBLE_EQ(offset({{"oneway", "-1"}, {"lanes", "3"}, {"placement", "right_of:1"}}), 1.75);
  EXPECT_DOUBLE_EQ(offset({{"oneway", "yes"}, {"lanes", "2"}, {"placement:forward", "right_of:2"}}),
                   3.5);
  EXPECT_DOUBLE_EQ(
      offset({{"lanes", "3"}, {"lanes:forward", "2"}, {"placement:forward", "left_of:1"}}), -1.75)
      << "the line stays between the directions";
  EXPECT_DOUBLE_EQ(
      offset({{"lanes", "3"}, {"lanes:forward", "2"}, {"placement:backward", "left_of:1"}}), -1.75);
  EXPECT_DOUBLE_EQ(offset({{"oneway", "yes"},
                           {"lanes", "3"},
                           {"placement", "right_of:1"},
                           {"cycleway:right", "lane"}}),
                   -2.5)
      << "the cycle lane counts";
  for (const char* none : {"right_of:3", "right_of", "left_of:0", "center", "left_of:1x"})
    EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"placement", none}}),
              "general general |  ?placement")
        << none;
  EXPECT_EQ(read({{"oneway", "yes"}, {"lanes", "2"}, {"placement", "transition"}}),
            "general general | ");
}

TEST(OsmLanes, NonsenseIsNamedAndRaisesNothing) {
  std::mt19937 random(7);
  const std::vector<std::string> keys = {"lanes",
                                         "lanes:forward",
                                         "lanes:backward",
                                         "lanes:both_ways",
                                         "lanes:psv",
                                         "turn:lanes",
                                         "turn:lanes:forward",
                                         "turn:lanes:both_ways",
                                         "width:lanes:backward",
                                         "bus:lanes",
                                         "oneway",
                                         "bicycle:lanes:forward",
                                         "vehicle:lanes",
                                         "cycleway",
                                         "cycleway:left:oneway",
                                         "busway:left",
                                         "cycleway:right:width",
                                         "parking:both",
                                         "placement",
                                         "placement:backward",
                                         "change:lanes",
                                         "oneway:bus",
                                         "access",
                                         "hov:lanes",
                                         "centre_turn_lane",
                                         "junction",
                                         "highway"};
  const std::vector<std::string> words = {"",
                                          "yes",
                                          "no",
                                          "-1",
                                          "lane",
                                          "opposite_lane",
                                          "|",
                                          "|||",
                                          "designated|",
                                          "no|yes|",
                                          "3",
                                          "999999999999",
                                          "-3",
                                          "1e9",
                                          "left|through;right",
                                          ";;|;",
                                          "reversible",
                                          "right_of:99",
                                          "nan",
                                          "inf",
                                          "\xff\xfe",
                                          "üß|ö",
                                          "3,5 m|",
                                          "busway",
                                          std::string(5000, '|')};
  const auto any = [&](const std::vector<std::string>& list) {
    return list[random() % list.size()];
  };
  for (int i = 0; i < rounds(10000); ++i) {
    OsmTags tags;
    for (int n = random() % 8; n >= 0; --n) tags[any(keys)] = any(words);
    OsmLaneUse use = i % 2 ? left_hand() : OsmLaneUse{};
    const OsmLanes lanes = read_osm_lanes(tags, use);
    EXPECT_LE(lanes.forward.size() + lanes.backward.size() + lanes.both_ways, 30u);
    EXPECT_TRUE(std::isfinite(lanes.roadway_offset.value_or(0)));
  }
}

TEST(OsmLanes, NameSlipsOfTagsThatSpeakOfTheWay) {
  const auto named = [](const char* key, const char* word) { return read({{key, word}}); };
  for (const char* key : {"wdith", "Width", "maxsped", "layr", "Maxspeed:forward", "est_widht"})
    EXPECT_EQ(named(key, "7"), std::string("general | general ?") + key);
  for (const char* key : {"name", "length", "lit", "surface", "width:source", "bridge:name"})
    EXPECT_EQ(named(key, "7"), "general | general") << key;
  for (const char* word : {"roundabut", "roundabouts", "cicular"})
    EXPECT_EQ(named("junction", word), "general | general ?junction") << word;
  for (const char* word : {"approach", "jughandle", "yes"})
    EXPECT_EQ(named("junction", word), "general | general") << word;
  EXPECT_EQ(named("tunnel", "buildingpassage"), "general | general ?tunnel");
  EXPECT_EQ(named("tunnel", "culvert"), "general | general");
}

}  // namespace osm_lanes_test
}  // namespace streetgen
