// Lists about the lanes of one direction, as columns of axis hold them: a word a lane, from left
// to right in driving direction, parted by |.
#pragma once

#include <string>
#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"

namespace streetgen::pg {

// Widths of lanes that say none; 0: an equal share.
struct KindWidths {
  double cycle = 0, parking = 0;
};

// `count` general lanes, or those of `kinds`; general ones become `general_as`.  `widths` and `turns` that name another number of
// lanes are not read; they may speak of the lanes of motor traffic only.  `what` ends each message
// of Error{invalid_input}.
std::vector<LaneWish> read_lanes(int count, const std::string& kinds, const std::string& widths,
                                 const std::string& turns, KindWidths defaults,
                                 const std::string& what,
                                 LaneKind general_as = LaneKind::general);

// Whether a list of widths or turns has a word for each lane, or for each lane of motor traffic.
bool names_lanes(const std::string& list, const std::vector<LaneWish>& lanes);

// "bus|cycle"; none of an empty text.  `what` as word_of has it.
std::vector<LaneKind> read_kinds(const std::string& kinds, const std::string& what);

// "bus|cycle" and its like.
std::string kinds_text(const LaneKinds& kinds);

// What the general lanes of a street are for those who may drive there: "bus", "no" and its like;
// general of a word that binds nobody, such as "private", and of an empty one.
LaneKind lanes_for(const std::string& access);

// "left" and its like, of a turn restriction.
Turn read_turn(const std::string& word);

// "left;through"; empty where nothing is said.
std::string turn_text(unsigned turns);

const char* lane_kind_name(LaneKind kind);
const char* lane_side_name(LaneSide side);

LaneSettings read_lane_settings(const char* order, const char* driving_side, double narrowest);

}  // namespace streetgen::pg
