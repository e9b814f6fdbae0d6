// Who keeps which lanes where several ways lead into one street.
#pragma once

#include <optional>

#include "interconnection/way.hpp"

namespace streetgen {

// Who enters beside a street that goes on takes the lanes on his side, those that are left, so that
// he crosses no path of it.  The others leave the goals of the way.
void leave_to_main(const Ways& of_node, Way& way);

// Whether others enter the street of the way from its left alone; none where they come from both
// sides or from neither.
std::optional<bool> entered_from_left(const Ways& of_node, const Way& way);

// Whether a path from lane to lane would cross one of a way that enters the street beside it, where
// both slant into it and turn no more.
bool crosses_beside(const Ways& of_node, const Way& way, int in, int out);

}  // namespace streetgen
