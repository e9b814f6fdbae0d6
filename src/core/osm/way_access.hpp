// Who may drive a way, in each direction.
#pragma once

#include "osm/access_word.hpp"
#include "osm/way_tags.hpp"

namespace streetgen {

// By the tags of a direction and by those of the way: that nearest to a vehicle decides, and of one
// tag that of the direction.  Where cars may not drive, buses may that have a lane there.
Access way_access(Heading heading, const WayTags& tags);

// Does a tag say that buses may drive in this direction: a word, a list or a number of lanes, or a
// lane at a kerb?  Against the traffic of a one-way street tags without a direction do not.
bool lets_buses_in(Heading heading, const WayTags& tags);

// The tag of the direction or of the way that lets buses in, with taxis; empty: none does.
std::string key_of_buses(Heading heading, const WayTags& tags);
// What the tag says that is nearest to cars.
Access access_of_cars(Heading heading, const WayTags& tags);

}  // namespace streetgen
