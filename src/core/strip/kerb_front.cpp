#include "strip/kerb_front.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "strip/bend.hpp"

namespace streetgen {

namespace {

constexpr double fastest = 1e8;  // of the corner between two sides that face each other
constexpr double beyond = 250;   // metres from kerbs: farther than any strip goes
constexpr double uneven = 1e-9;  // metres between two widths
// Sharper bends to a kerb without strip end square.
const double square_cosine = std::cos(M_PI / 3 + same_angle);
// The end of a chain bounds no side that it leads along, within 10 degrees.
const double nearly_along_sine = std::sin(M_PI / 18 + same_angle);

// A corner of the front. Times are distances from the kerbs.
struct Joint {
  Point at;
  Point speed;
  double time = 0;

  Point place(double when) const { return at + speed * (when - time); }
};

Point bisecting_speed(const Point& normal, const Point& other) {
  const Point sum = normal + other;
  const double share = 1 + dot(normal, other);
  return share * fastest > norm(sum) ? sum * (1 / share) : left_normal(normal) * fastest;
}

class Front {
 public:
  Front(const std::vector<KerbSegment>& segments, bool is_closed, const Point& before,
        const Point& after)
      : segments_(segments), sides_(segments.size()) {
    passed_.grounds.resize(segments.back().kerb + 1);
    strips_.resize(passed_.grounds.size());
    passed_.bounds_back.assign(segments.size(), true);
    for (int i = 0; i < count(); ++i) {
      Side& side = sides_[i];
      side.along = segments_[i].along;
      side.normal = left_normal(side.along);
      side.start = {segments_[i].from, side.normal, 0};
      side.end = {segments_[i].to, side.normal, 0};
      ++strip(i).sides;
      widest_ = std::max({widest_, segments_[i].width_from, segments_[i].width_to});
    }
    tell_reach(is_closed);
    for (int i = 1; i < count(); ++i) join(i - 1, i, segments_[i].from, 0);
    if (is_closed) {
      join(count() - 1, 0, segments_[0].from, 0);
    } else {
      if (ends_aslant(before, sides_.front().along))
        sides_.front().start.speed = bisecting_speed(left_normal(before), sides_.front().normal);
      if (ends_aslant(sides_.back().along, after))
        sides_.back().end.speed = bisecting_speed(sides_.back().normal, left_normal(after));
    }
    for (int i = 0; i < count(); ++i) expect(i);
  }

  FrontPassed pass() {
    while (!meetings_.empty() && !met_all_) {
      const auto [time, side, version] = meetings_.top();
      meetings_.pop();
      if (sides_[side].there && sides_[side].version == version) meet(side, time);
    }
    for (int i = 0; i < count() && !met_all_; ++i)
      if (sides_[i].there) leave_open(i);
    for (std::size_t k = 0; k < strips_.size(); ++k)
      passed_.grounds[k].is_open = strips_[k].sides > 0;
    return std::move(passed_);
  }

 private:
  struct Side {
    Point along, normal;
    Joint start, end;
    int previous = -1, next = -1;
    bool goes_round = false;  // about an outer bend at its start
    bool there = true;
    int version = 0;
  };
  // What the front passes beyond the widths of a strip and its neighbours tells nothing of it, so
  // that a strip is the same whichever kerbs are given farther off.
  struct Strip {
    double reach = 0;
    int sides = 0;  // that the front does not lose within it
    bool start_told = false, end_told = false;
  };
  // A side with its neighbours before it met others.
  struct Met {
    int side, previous, next;
    bool goes_round;
  };
  using Meeting = std::tuple<double, int, int>;  // time, side, its version

  static bool ends_aslant(const Point& before, const Point& after) {
    return dot(before, after) > square_cosine && !is_outer_bend(before, after);
  }
  int count() const { return static_cast<int>(sides_.size()); }
  KerbGround& ground(int side) { return passed_.grounds[segments_[side].kerb]; }
  Strip& strip(int side) { return strips_[segments_[side].kerb]; }
  void tell_reach(bool is_closed) {
    const std::size_t many = strips_.size();
    std::vector<double> widest(many);
    for (const KerbSegment& segment : segments_)
      widest[segment.kerb] = std::max({widest[segment.kerb], segment.width_from, segment.width_to});
    for (std::size_t k = 0; k < many; ++k) {
      const std::size_t next = k + 1 < many ? k + 1 : is_closed ? 0 : k;
      strips_[k].reach = std::max({strips_[k].reach, widest[k], widest[next]});
      strips_[next].reach = std::max({strips_[next].reach, widest[k], widest[next]});
    }
  }
  void cannot_tell(int side, double time) {
    if (time < strip(side).reach) ground(side).whole = false;
  }
  bool goes_round(int side) const { return side >= 0 && sides_[side].goes_round; }
  // That the side goes round at its start.
  Point middle_of_bend_at(int i) const {
    const Point& before = sides_[(i + count() - 1) % count()].along;
    return segments_[i].from + middle_of_bend(before, sides_[i].along) * beyond;
  }
  bool of_one_kerb(int side, int other) const {
    return side >= 0 && other >= 0 && segments_[side].kerb == segments_[other].kerb;
  }

  double width_at(int i, const Point& at) const {
    const auto& [from, to, width_from, width_to, kerb, along] = segments_[i];
    const double share = dot(at - from, along) / distance(from, to);
    return width_from + (width_to - width_from) * std::clamp(share, 0.0, 1.0);
  }

  void join(int before, int after, const Point& at, double time) {
    Side &a = sides_[before], &b = sides_[after];
    const bool bends = is_outer_bend(a.along, b.along);
    b.goes_round = bends && time == 0;
    if (bends) {
      a.end = {at, a.normal, time};
      b.start = {at, b.normal, time};
      if (time > 0)  // What lies between them has been passed before.
        for (const int each : {before, after}) cannot_tell(each, time);
    } else {
      a.end = b.start = {at, bisecting_speed(a.normal, b.normal), time};
    }
    a.next = after;
    b.previous = before;
  }

  // When the side shrinks to nothing.
  void expect(int i) {
    Side& side = sides_[i];
    ++side.version;
    const double start_speed = dot(side.along, side.start.speed);
    const double end_speed = dot(side.along, side.end.speed);
    const double closing = start_speed - end_speed;
    const double size = dot(side.along, side.end.at - side.start.at) - end_speed * side.end.time +
                        start_speed * side.start.time;
    if (size >= closing * widest_) return;
    meetings_.push({std::max({size / closing, side.start.time, side.end.time}), i, side.version});
  }

  // The side shrinks to a place where its neighbours meet.
  void meet(int i, double time) {
    Side& side = sides_[i];
    const int l = side.previous, r = side.next;
    const Joint& slower = norm(side.start.speed) < norm(side.end.speed) ? side.start : side.end;
    const Point at = slower.place(time);
    note_meeting(l, i, r, at, time);
    if (!of_one_kerb(l, i)) {
      if (l >= 0) tell_end(l, at, time);
      tell_start(i, at, time);
    }
    if (!of_one_kerb(i, r)) {
      tell_end(i, at, time);
      if (r >= 0) tell_start(r, at, time);
    }
    side.there = false;
    if (time < strip(i).reach) --strip(i).sides;
    passed_.bounds_back[i] = time >= width_at(i, at);
    if (l >= 0 && r >= 0) {
      met_all_ = l == sides_[r].next && !goes_round(l);
      if (met_all_) {  // Which of the last three is looked at means nothing.
        for (const int last : {l, r}) {
          passed_.bounds_back[last] = time >= width_at(last, at);
          if (time < strip(last).reach) --strip(last).sides;
        }
        return;
      }
      join(l, r, at, time);
    } else if (l >= 0) {
      sides_[l].next = -1;
      sides_[l].end = {at, go_on(side.end.speed, l, time), time};
    } else if (r >= 0) {
      sides_[r].previous = -1;
      sides_[r].goes_round = false;
      sides_[r].start = {at, go_on(side.start.speed, r, time), time};
    }
    if (l >= 0) expect(l);
    if (r >= 0) expect(r);
  }

  // What it means for strips that are so wide. Sides that shrink to one place at one time meet
  // there together, in whatever order they are looked at.
  void note_meeting(int l, int i, int r, const Point& at, double time) {
    if (time - met_time_ > same_place || distance(at, met_at_) > same_place) {
      met_.clear();
      met_at_ = at;
      met_time_ = time;
    }
    for (const int each : {l, i, r})
      if (each >= 0 &&
          std::none_of(met_.begin(), met_.end(), [&](const Met& met) { return met.side == each; }))
        met_.push_back({each, sides_[each].previous, sides_[each].next, goes_round(each)});
    const bool is_last = l >= 0 && r >= 0 && sides_[r].next == l;
    double least = width_at(i, at), most = least;
    bool is_narrow = false, is_round = false;
    for (const Met& met : met_) {
      least = std::min(least, width_at(met.side, at));
      most = std::max(most, width_at(met.side, at));
      for (const Met& other : met_) {
        const bool follows = met.next == other.side || met.previous == other.side;
        is_round = is_round || (met.next == other.side && other.goes_round);
        is_narrow =
            is_narrow || ((is_last || !follows) &&
                          dot(sides_[met.side].normal, sides_[other.side].normal) < facing_cosine);
      }
    }
    if (time >= most) return;
    // Ground that the kerb across does not want goes to this one.
    const bool is_whole = !is_round && (!is_narrow || most - least <= uneven);
    for (const Met& met : met_) {
      ground(met.side).whole = ground(met.side).whole && is_whole;
      ground(met.side).narrow = ground(met.side).narrow || is_narrow;
    }
  }

  // Along the end of the chain.
  Point go_on(const Point& speed, int side, double time) {
    const double away = dot(speed, sides_[side].normal);
    if (away > nearly_along_sine * norm(speed)) return speed * (1 / away);
    cannot_tell(side, time);
    return sides_[side].normal;
  }

  // The ways that bound the ground of a kerb lead to where the front meets, or beyond its strip.
  void tell_start(int i, const Point& at, double time) {
    if (strip(i).start_told) return;
    strip(i).start_told = time >= strip(i).reach || goes_round(i);
    ground(i).start.push_back(goes_round(i)         ? middle_of_bend_at(i)
                              : strip(i).start_told ? sides_[i].start.place(beyond)
                                                    : at);
  }
  void tell_end(int i, const Point& at, double time) {
    if (strip(i).end_told) return;
    const int next = sides_[i].next;
    strip(i).end_told = time >= strip(i).reach || goes_round(next);
    ground(i).end.push_back(goes_round(next)    ? middle_of_bend_at(next)
                            : strip(i).end_told ? sides_[i].end.place(beyond)
                                                : at);
  }
  void leave_open(int i) {
    if (!of_one_kerb(sides_[i].previous, i)) tell_start(i, {}, beyond);
    if (!of_one_kerb(i, sides_[i].next)) tell_end(i, {}, beyond);
  }

  const std::vector<KerbSegment>& segments_;
  std::vector<Side> sides_;
  std::vector<Strip> strips_;  // of kerbs
  FrontPassed passed_;
  double widest_ = 0;
  bool met_all_ = false;  // nothing is left before a closed front
  std::vector<Met> met_;  // the last ones, in one place at one time
  Point met_at_;
  double met_time_ = -1;
  std::priority_queue<Meeting, std::vector<Meeting>, std::greater<Meeting>> meetings_;
};

}  // namespace

FrontPassed pass_front(const std::vector<KerbSegment>& segments, bool is_closed,
                       const Point& before, const Point& after) {
  return Front(segments, is_closed, before, after).pass();
}

}  // namespace streetgen
