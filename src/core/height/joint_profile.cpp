#include "height/joint_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/tolerance.hpp"
#include "height/bridge_ground.hpp"
#include "height/height_line.hpp"
#include "height/least_height.hpp"
#include "height/plateau.hpp"

namespace streetgen {

namespace {

constexpr double dip = 0.01;       // metres by which a road may leave a plateau
constexpr double grade_base = 20;  // metres over which the grade of the ground is measured

// The greatest grade of the ground between points so far apart.
double steepest(const HeightLine& ground) {
  double most = 0;
  for (std::size_t i = 0, j = 0; i + 1 < ground.size(); ++i) {
    while (j + 1 < ground.size() && ground[j].at - ground[i].at < grade_base) ++j;
    const double apart = ground[j].at - ground[i].at;
    if (apart >= grade_base || i == 0)
      most = std::max(most, std::abs(ground[j].z - ground[i].z) / apart);
  }
  return most;
}

// The height that a vertical arc between the two greatest grades takes from its crest.
double crest_loss(const ProfileEdge& edge) { return edge.radius * edge.grade * edge.grade / 2; }

bool dips_below(const HeightLine& road, const HeightLine& bound) {
  const auto dips = [&](double at) { return height_at(road, at) < height_at(bound, at) - dip; };
  const double from = bound.front().at, to = bound.back().at;
  return dips(from) || dips(to) || std::any_of(road.begin(), road.end(), [&](const HeightPoint& p) {
           return p.at > from && p.at < to && dips(p.at);
         });
}

class Builder {
 public:
  Builder(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts,
          const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules)
      : edges_(edges), lifts_(lifts), by_hand_(by_hand), rules_(rules), through_(edges) {
    BridgeGround ground = ground_with_bridges(edges, lifts, rules.level_length);
    ground_ = std::move(ground.ground);
    clear_ = std::move(ground.clear);
    for (std::size_t e = 0; e < edges.size(); ++e)
      grades_.push_back(std::max(edges[e].grade, steepest(ground_[e])));
    heights_ = ground_;
    kept_ = {grades_, grades_};
  }

  Profiles build(Rounds rounds) {
    for (const ProfileLift& lift : lifts_)
      losses_.push_back(crest_loss(edges_[lift.sinks ? lift.below : lift.above]));
    for (const ProfileHeight& height : by_hand_) losses_.push_back(crest_loss(edges_[height.edge]));
    for (const ClearStretch& clear : clear_) {
      const double loss = crest_loss(edges_[clear.edge]);
      losses_.push_back(clear.falls_from ? loss : 0);
      losses_.push_back(clear.falls_to ? loss : 0);
    }
    if (rounds == Rounds::rough) {
      lift();
      sink();
    } else {
      find_heights(most_rounds);
      stays_up_ = rules_.plateau > 0;
      if (stays_up_) find_heights(most_rounds_up);
    }
    Profiles out;
    for (std::size_t e = 0; e < edges_.size(); ++e) out.edges.push_back(profile(e));
    for (const ProfileLift& lift : lifts_) out.unmet.push_back(is_unmet(lift));
    return out;
  }

 private:
  // An arc that ends at the next bend takes less than a whole one: the road need not lie so high.
  void find_heights(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      heights_ = ground_;
      lift();
      sink();
      const std::vector<HeightLine> straight = heights_;
      bend();
      if (!take_losses(straight)) break;
    }
  }

  HeightLine turned(const HeightLine& heights, bool mirrored) const {
    return mirrored ? upside_down(heights) : heights;
  }

  std::size_t hand_loss(std::size_t height) const { return lifts_.size() + height; }
  // The loss at the beginning of a clear stretch; the next one is that at its end.
  std::size_t clear_loss(std::size_t stretch) const {
    return lifts_.size() + by_hand_.size() + 2 * stretch;
  }

  bool is_off_ground(const ProfileHeight& height) const {
    return height.height > height_at(ground_[height.edge], height.abscissa) + same_place;
  }

  void lift() {
    std::vector<Lift> lifts;
    std::vector<LiftedPlace> places;
    for (std::size_t l = 0; l < lifts_.size(); ++l)
      if (const ProfileLift& lift = lifts_[l]; !lift.sinks) {
        lifts.push_back(
            {lift.below, lift.at_below, lift.above, lift.at_above, lift.clearance + losses_[l]});
        places.push_back({lift.above, lift.at_above});
      }
    std::vector<LeastHeight> least;
    for (std::size_t h = 0; h < by_hand_.size(); ++h)
      if (const ProfileHeight& height = by_hand_[h]; is_off_ground(height))
        least.push_back({height.edge, height.abscissa, height.height + losses_[hand_loss(h)]});
    solve(lifts, least, places, false);
  }

  // A road that sinks takes those along that it passes over.
  void sink() {
    const auto sinks = [](const auto& part) { return part.sinks; };
    if (std::none_of(lifts_.begin(), lifts_.end(), sinks) &&
        std::none_of(clear_.begin(), clear_.end(), sinks))
      return;
    std::vector<Lift> lifts;
    std::vector<LiftedPlace> places;
    for (std::size_t l = 0; l < lifts_.size(); ++l) {
      const ProfileLift& lift = lifts_[l];
      lifts.push_back({lift.above, lift.at_above, lift.below, lift.at_below,
                       lift.clearance + (lift.sinks ? losses_[l] : 0)});
      if (lift.sinks) places.push_back({lift.below, lift.at_below});
    }
    solve(lifts, {}, places, true);
  }

  // The least heights over those that are there, mirrored: the greatest under them.
  void solve(const std::vector<Lift>& lifts, const std::vector<LeastHeight>& least,
             const std::vector<LiftedPlace>& places, bool mirrored) {
    std::vector<GradedRoad> roads;
    std::vector<HeightLine> ground;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      roads.push_back({edges_[e].from_node, edges_[e].to_node, turned(heights_[e], mirrored),
                       kept_[mirrored][e], std::max(grades_[e], edges_[e].grade_greatest),
                       mirrored ? upside_down(ground_[e]) : HeightLine{}});
      ground.push_back(turned(ground_[e], mirrored));
    }
    for (std::size_t c = 0; c < clear_.size(); ++c)
      if (const ClearStretch& clear = clear_[c]; clear.sinks == mirrored) {
        GradedRoad& road = roads[clear.edge];
        road.ground = raised_to(road.ground, with_losses(c), road.grade);
      }
    LeastHeights solved = least_heights(roads, lifts, least);
    // A road that stays up lifts what passes over it.
    for (int round = 0; round < most_plateau_rounds && stays_up_; ++round) {
      bool higher = false;
      std::vector<GradedRoad> raised = roads;
      for (std::size_t e = 0; e < roads.size(); ++e) raised[e].grade = solved.grades[e];
      for (const Plateau& plateau :
           through_.plateaus(places, solved.roads, ground, rules_.plateau)) {
        higher = higher || dips_below(solved.roads[plateau.edge], plateau.bound);
        GradedRoad& road = raised[plateau.edge];
        road.ground = raised_to(road.ground, plateau.bound, road.grade);
      }
      if (!higher) break;
      solved = least_heights(raised, lifts, least);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      heights_[e] = kinks_of(turned(solved.roads[e], mirrored));
      kept_[mirrored][e] = solved.grades[e];
    }
  }

  // The bound of a stretch, mirrored where it sinks, with what arcs at its ends may take.
  HeightLine with_losses(std::size_t stretch) const {
    HeightLine bound = turned(clear_[stretch].bound, clear_[stretch].sinks);
    const double from = bound.front().at, metres = bound.back().at - from;
    const double first = losses_[clear_loss(stretch)], last = losses_[clear_loss(stretch) + 1];
    for (HeightPoint& point : bound) point.z += first + (last - first) * (point.at - from) / metres;
    return bound;
  }

  void bend() {
    std::vector<KinkBounds> bounds(edges_.size());
    for (std::size_t l = 0; l < lifts_.size(); ++l) {
      const ProfileLift& lift = lifts_[l];
      bounds[lift.above].fixed.push_back(lift.at_above);
      bounds[lift.below].fixed.push_back(lift.at_below);
      if (lift.sinks)
        bounds[lift.below].raised.push_back({lift.at_below, losses_[l]});
      else
        bounds[lift.above].lowered.push_back({lift.at_above, losses_[l]});
    }
    for (std::size_t h = 0; h < by_hand_.size(); ++h) {
      const ProfileHeight& height = by_hand_[h];
      bounds[height.edge].fixed.push_back(height.abscissa);
      if (is_off_ground(height))
        bounds[height.edge].lowered.push_back({height.abscissa, losses_[hand_loss(h)]});
    }
    for (std::size_t c = 0; c < clear_.size(); ++c) {
      const ClearStretch& clear = clear_[c];
      KinkBounds& bound = bounds[clear.edge];
      for (const auto& [at, falls, loss] : ends_of(c)) {
        if (!falls) continue;
        bound.fixed.push_back(at);
        (clear.sinks ? bound.raised : bound.lowered).push_back({at, losses_[loss]});
      }
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      bounds[e].ground = ground_[e];
      bounds[e].radius = edges_[e].radius;
      heights_[e] = without_kinks(heights_[e], bounds[e]);
    }
  }

  struct StretchEnd {
    double at;
    bool falls;
    std::size_t loss;
  };
  std::array<StretchEnd, 2> ends_of(std::size_t stretch) const {
    const ClearStretch& clear = clear_[stretch];
    return {{{clear.bound.front().at, clear.falls_from, clear_loss(stretch)},
             {clear.bound.back().at, clear.falls_to, clear_loss(stretch) + 1}}};
  }

  // Takes what the arcs took; is that less than the roads were lifted or sunk by for them?
  bool take_losses(const std::vector<HeightLine>& straight) {
    bool less = false;
    const auto take = [&](double* loss, int edge, double at) {
      const double taken = std::abs(height_at(straight[edge], at) - height_at(heights_[edge], at));
      if (taken <= same_place || taken >= *loss - rounding_of_losses) return;
      *loss = taken;
      less = true;
    };
    for (std::size_t l = 0; l < lifts_.size(); ++l)
      take(&losses_[l], lifts_[l].sinks ? lifts_[l].below : lifts_[l].above,
           lifts_[l].sinks ? lifts_[l].at_below : lifts_[l].at_above);
    for (std::size_t h = 0; h < by_hand_.size(); ++h)
      take(&losses_[hand_loss(h)], by_hand_[h].edge, by_hand_[h].abscissa);
    for (std::size_t c = 0; c < clear_.size(); ++c)
      for (const StretchEnd& end : ends_of(c))
        if (end.falls) take(&losses_[end.loss], clear_[c].edge, end.at);
    return less;
  }

  ProfileMethod method_of(std::size_t e) const {
    bool lifted = false, sunk = false;
    const HeightLine ground = heights_of(edges_[e].line);
    for (const HeightPoint& point : heights_[e]) {
      const double over = point.z - height_at(ground, point.at);
      lifted = lifted || over > same_place;
      sunk = sunk || over < -same_place;
    }
    return sunk ? ProfileMethod::sunk : lifted ? ProfileMethod::lifted : ProfileMethod::ground;
  }

  Profile profile(std::size_t e) const {
    const ProfileMethod method = method_of(e);
    const bool as_line = method == ProfileMethod::ground && edges_[e].rise == 0;
    return {as_line ? edges_[e].line : with_heights(edges_[e].line, heights_[e]), method,
            std::max(kept_[0][e], kept_[1][e])};
  }

  bool is_unmet(const ProfileLift& lift) const {
    return height_at(heights_[lift.above], lift.at_above) <
           height_at(heights_[lift.below], lift.at_below) + lift.clearance - same_place;
  }

  // Each round leaves a quarter of what is too high on flat ground.
  static constexpr int most_rounds = 20;
  // The bend at the end of a plateau is small from the beginning.
  static constexpr int most_rounds_up = 2;
  static constexpr int most_plateau_rounds = 2;
  static constexpr double rounding_of_losses = 1e-6;  // metres

  const std::vector<ProfileEdge>& edges_;
  const std::vector<ProfileLift>& lifts_;
  const std::vector<ProfileHeight>& by_hand_;
  const ProfileRules& rules_;
  const ThroughRoads through_;
  std::vector<ClearStretch> clear_;
  std::vector<HeightLine> ground_, heights_;
  std::vector<double> grades_;  // usual
  // The greatest that were needed by what is lifted, and by what is sunk.
  std::array<std::vector<double>, 2> kept_;
  bool stays_up_ = false;  // do roads stay up between crossings?
  // Metres that the arc over each lift, at each height by hand, and at both ends of each clear
  // stretch may take.
  std::vector<double> losses_;
};

}  // namespace

Profiles joint_profiles(const std::vector<ProfileEdge>& edges,
                        const std::vector<ProfileLift>& lifts,
                        const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules,
                        Rounds rounds) {
  return Builder(edges, lifts, by_hand, rules).build(rounds);
}

}  // namespace streetgen
