// The links on which an actor was at the samples of its log.
#pragma once

#include <vector>

#include "streetgen/drive_report.hpp"

namespace streetgen {

// A sample of one actor, with the way that it drove there.
struct DrivenPlace {
  NearPlace near;        // link -1: off the road
  bool against = false;  // it drives against the traffic of the link
  // The links from that of the sample before to its own one, without the first.  Not `joined`: no
  // way without a change of lanes leads there.
  bool joined = false;
  std::vector<std::int32_t> way;
};

// A row for each sample of one actor, by their times, all finite, no two of one time.
std::vector<DrivenPlace> driven_links(const TrafficNetwork& network, const LinkPlaces& places,
                                      const std::vector<DriveSample>& samples);

}  // namespace streetgen
