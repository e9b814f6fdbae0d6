#include <gtest/gtest.h>

#include "read_lanes.hpp"

namespace streetgen {
namespace osm_lanes_test {

TEST(OsmKerbLanes, WidthsAreBelievedByTheKindOfTheLane) {
  const auto parking = [](const char* width) {
    return read({{"lanes", "2"}, {"parking:right", "lane"}, {"parking:right:width", width}});
  };
  EXPECT_EQ(parking("20"), "general parking | general ?parking:right:width");
  EXPECT_EQ(parking("0.5"), "general parking | general ?parking:right:width");
  EXPECT_EQ(parking("5.5"), "general parking=5.50 | general");
  const auto cycle = [](const char* width) {
    return read({{"lanes", "2"}, {"cycleway:right", "lane"}, {"cycleway:right:width", width}});
  };
  EXPECT_EQ(cycle("15"), "general cycle | general ?cycleway:right:width");
  EXPECT_EQ(cycle("0.75"), "general cycle=0.75 | general");
  const auto listed = [](const char* widths) {
    return read({{"oneway", "yes"},
                 {"lanes", "1"},
                 {"bicycle:lanes", "|designated"},
                 {"vehicle:lanes", "|no"},
                 {"width:lanes", widths}});
  };
  EXPECT_EQ(listed("3|1.25"), "general=3.00 cycle=1.25 | ");
  EXPECT_EQ(listed("15|1.25"), "general cycle=1.25 |  ?width:lanes");
  EXPECT_EQ(listed("1.25|3"), "general cycle=3.00 |  ?width:lanes");
  EXPECT_EQ(listed("3|5"), "general=3.00 cycle |  ?width:lanes");
}

TEST(OsmKerbLanes, TagsOfALaneThatNoTagTellsOfAreNamed) {
  for (const char* key : {"cycleway:right:width", "cycleway:left:width", "cycleway:both:width",
                          "cycleway:right:est_width", "parking:left:width", "parking:both:width"})
    EXPECT_EQ(read({{key, "2"}}), std::string("general | general ?") + key);
  EXPECT_EQ(read({{"cycleway:right:oneway", "no"}}), "general | general ?cycleway:right:oneway");
  for (const char* key : {"parking:left:orientation", "parking:both:orientation"})
    EXPECT_EQ(read({{key, "diagonal"}}), std::string("general | general ?") + key);
  EXPECT_EQ(read({{"parking:lane:left:parallel", "on_street"}}),
            "general | general ?parking:lane:left:parallel");
  EXPECT_EQ(read({{"cycleway:right", "track"}, {"cycleway:right:width", "2"}}), "general | general")
      << "that of a track";
  EXPECT_EQ(read({{"cycleway", "no"}, {"cycleway:right:width", "2"}}), "general | general");
  EXPECT_EQ(read({{"cycleway:left", "track"}, {"cycleway:both:width", "2"}}), "general | general");
  EXPECT_EQ(read({{"parking:left", "street_side"}, {"parking:left:orientation", "diagonal"}}),
            "general | general");
  EXPECT_EQ(read({{"parking:left", "street_side"}, {"parking:both:orientation", "parallel"}}),
            "general | general");
}

TEST(OsmKerbLanes, OfSeveralWaysToStandTheDeepestCounts) {
  EXPECT_EQ(read({{"lanes", "2"},
                  {"parking:right", "lane"},
                  {"parking:right:orientation", "parallel;diagonal"}}),
            "general parking=4.50 | general ?parking:right:orientation");
  EXPECT_EQ(read({{"lanes", "2"}, {"parking:lane:right", "parallel;perpendicular"}}),
            "general parking=5.00 | general ?parking:lane:right");
  for (const char* where : {"on_street;half_on_kerb", "half_on_kerb;on_street"})
    EXPECT_EQ(read({{"lanes", "2"},
                    {"parking:lane:right", "parallel"},
                    {"parking:lane:right:parallel", where}}),
              "general parking | general")
        << "the lane among several places is made";
}

}  // namespace osm_lanes_test
}  // namespace streetgen
