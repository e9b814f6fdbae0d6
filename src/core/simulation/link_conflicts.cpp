#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_set>

#include "simulation/link_course.hpp"
#include "simulation/swept_ground.hpp"
#include "simulation/yield_order.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/link_conflict.hpp"

namespace streetgen {

namespace {

constexpr double longest_movement = 1e4;
constexpr double oncoming = 3 * M_PI / 4;   // radians between headings, from which on
constexpr double side_by_side = M_PI / 12;  // the same, below which

void check(const std::vector<ConflictMovement>& movements) {
  const auto refuse = [](std::size_t i, const std::string& why) {
    throw Error(ErrorKind::invalid_input, "movement " + std::to_string(i + 1) + " " + why);
  };
  std::unordered_set<std::int64_t> junctions;
  for (std::size_t i = 0; i < movements.size(); ++i) {
    const ConflictMovement& m = movements[i];
    if (!(m.length > 0 && m.length <= longest_movement))
      refuse(i, "is " + text_of(m.length) + " metres long");
    if (!(m.width > 0 && m.width <= longest_movement))
      refuse(i, "is " + text_of(m.width) + " metres wide");
    if (m.course.empty()) refuse(i, "has no course");
    for (const LinkPiece& piece : m.course)
      for (const double number : {piece.metres, piece.x, piece.y, piece.heading, piece.curvature})
        if (!std::isfinite(number)) refuse(i, "has a course with " + text_of(number));
    const bool begins = i == 0 || movements[i - 1].junction != m.junction;
    if (begins && !junctions.insert(m.junction).second)
      refuse(i, "stands apart from the others of junction " + std::to_string(m.junction));
  }
}

// A rule that says who gives way; the last ones give way themselves, where a circle would close.
enum class Rule { none, right_before_left, importance, turn, rank, protection };

struct Answer {
  Rule rule = Rule::none;
  bool first_waits = false;
};

Answer by_number(int first, int second, Rule rule) {
  if (first == second) return {};
  return {rule, first > second};
}

// The movements of one junction, from `movements` on; rows count from these.
class MeetingPaths {
 public:
  MeetingPaths(const ConflictMovement* movements, int count, bool left_hand)
      : movements_(movements), count_(count), across_(left_hand ? Turn::right : Turn::left) {
    ground_.reserve(count);
    for (int i = 0; i < count; ++i) ground_.emplace_back(movements[i]);
  }

  const std::vector<MovementConflict>& conflicts() {
    for (int a = 0; a < count_; ++a) {
      poll_cancel();
      for (int b = a + 1; b < count_; ++b) look_at(a, b);
    }
    order();
    return found_;
  }

 private:
  void look_at(int a, int b) {
    const ConflictMovement &first = movements_[a], &second = movements_[b];
    if (first.lane_in == second.lane_in && first.along_in == second.along_in) return;
    const bool merging = first.lane_out == second.lane_out && first.along_out == second.along_out;
    const bool first_enters = enters(first, second), second_enters = enters(second, first);
    if (!ground_[a].box().meets(ground_[b].box()) && !merging && !first_enters && !second_enters)
      return;
    SweptGround::Stretch of_first = ground_[a].within(ground_[b]);
    SweptGround::Stretch of_second;
    if (of_first.to >= 0) of_second = ground_[b].within(ground_[a]);
    if (of_first.to < 0) {
      if (!merging && !first_enters && !second_enters) return;
      // Courses that end beside each other, though in one lane.
      of_first = {first.length, first.length};
      of_second = {second.length, second.length};
    }
    MovementConflict found{a, b};
    if (merging || first_enters || second_enters)
      found.kind = merging ? ConflictKind::merging : ConflictKind::opposing;
    to_end(of_first, first, merging || first_enters, second_enters);
    to_end(of_second, second, merging || second_enters, first_enters);
    found.first_from = of_first.from;
    found.first_to = of_first.to;
    found.second_from = of_second.from;
    found.second_to = of_second.to;
    found_.push_back(found);
  }

  // Whether one enters a lane for both directions that another one leaves.
  static bool enters(const ConflictMovement& one, const ConflictMovement& other) {
    return one.lane_out == other.lane_in && one.along_out != other.along_in;
  }

  static void to_end(SweptGround::Stretch& stretch, const ConflictMovement& movement,
                     bool ends_in_shared, bool starts_in_shared) {
    if (ends_in_shared) {
      stretch.from = std::min(stretch.from, movement.length);
      stretch.to = movement.length;
    }
    if (starts_in_shared) stretch.from = 0;
  }

  Answer answer(int a, int b) const {
    const ConflictMovement &first = movements_[a], &second = movements_[b];
    if (together(first, second) != 0) {
      const bool first_protected = (first.protected_states & second.permitted_states) != 0;
      const bool second_protected = (second.protected_states & first.permitted_states) != 0;
      if (first_protected != second_protected) return {Rule::protection, second_protected};
      const Answer by_precedence = by_number(first.precedence, second.precedence, Rule::rank);
      if (by_precedence.rule != Rule::none) return by_precedence;
    } else {
      const Answer by_rank = by_number(first.rank, second.rank, Rule::rank);
      if (by_rank.rule != Rule::none) return by_rank;
    }
    const double from_right = std::remainder(heading(second) - heading(first), 2 * M_PI);
    const bool meet = std::abs(from_right) >= oncoming;
    const Answer by_turn = by_number(turning(first, meet), turning(second, meet), Rule::turn);
    if (by_turn.rule != Rule::none || meet) return by_turn;
    const Answer by_importance = by_number(first.importance, second.importance, Rule::importance);
    if (by_importance.rule != Rule::none) return by_importance;
    return std::abs(from_right) >= side_by_side ? Answer{Rule::right_before_left, from_right > 0}
                                                : Answer{};
  }

  // Who turns back waits for all; who turns across for those that it meets.
  int turning(const ConflictMovement& m, bool meets) const {
    return m.turn == Turn::u_turn ? 2 : meets && m.turn == across_ ? 1 : 0;
  }

  static double heading(const ConflictMovement& m) { return m.course.front().heading; }

  static std::uint64_t green(const ConflictMovement& m) {
    return m.protected_states | m.permitted_states;
  }
  static std::uint64_t together(const ConflictMovement& a, const ConflictMovement& b) {
    return green(a) & green(b);
  }

  // The rules in their order; who would close a circle goes by arrival.
  void order() {
    YieldOrder waits(count_);
    std::vector<Answer> answers;
    for (MovementConflict& found : found_) {
      const ConflictMovement &first = movements_[found.first], &second = movements_[found.second];
      const bool by_signal =
          green(first) != 0 && green(second) != 0 && together(first, second) == 0;
      if (by_signal) found.precedence = Precedence::by_signal;
      answers.push_back(by_signal ? Answer{} : answer(found.first, found.second));
    }
    for (const Rule rule :
         {Rule::protection, Rule::rank, Rule::turn, Rule::importance, Rule::right_before_left})
      for (std::size_t i = 0; i < found_.size(); ++i) {
        if (answers[i].rule != rule) continue;
        const bool first_waits = answers[i].first_waits;
        if (waits.add(first_waits ? found_[i].first : found_[i].second,
                      first_waits ? found_[i].second : found_[i].first))
          found_[i].precedence = first_waits ? Precedence::gives_way : Precedence::goes_first;
      }
  }

  const ConflictMovement* const movements_;
  const int count_;
  const Turn across_;
  std::vector<SweptGround> ground_;
  std::vector<MovementConflict> found_;
};

}  // namespace

std::vector<MovementConflict> link_conflicts(const std::vector<ConflictMovement>& movements,
                                             bool left_hand) {
  check(movements);
  std::vector<MovementConflict> all;
  const auto count = static_cast<int>(movements.size());
  for (int first = 0, last = 0; first < count; first = last) {
    while (last < count && movements[last].junction == movements[first].junction) ++last;
    MeetingPaths paths(movements.data() + first, last - first, left_hand);
    for (MovementConflict found : paths.conflicts()) {
      found.first += first;
      found.second += first;
      all.push_back(found);
    }
  }
  return all;
}

}  // namespace streetgen
