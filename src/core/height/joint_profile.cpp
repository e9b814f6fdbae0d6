#include "height/joint_profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/tolerance.hpp"
#include "height/height_line.hpp"
#include "height/least_height.hpp"

namespace streetgen {

namespace {

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

HeightLine upside_down(HeightLine heights) {
  for (HeightPoint& point : heights) point.z = -point.z;
  return heights;
}

class Builder {
 public:
  Builder(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts,
          const std::vector<ProfileHeight>& by_hand)
      : edges_(edges), lifts_(lifts), by_hand_(by_hand) {
    for (const ProfileEdge& edge : edges) {
      ground_.push_back(heights_of(edge.line));
      grades_.push_back(std::max(edge.grade, steepest(ground_.back())));
    }
    heights_ = ground_;
  }

  Profiles build() {
    for (const ProfileLift& lift : lifts_)
      losses_.push_back(crest_loss(edges_[lift.sinks ? lift.below : lift.above]));
    for (const ProfileHeight& height : by_hand_) losses_.push_back(crest_loss(edges_[height.edge]));
    // An arc that ends at the next bend takes less than a whole one: the road need not lie so high.
    for (int round = 0; round < most_rounds; ++round) {
      heights_ = ground_;
      lift();
      sink();
      const std::vector<HeightLine> straight = heights_;
      bend();
      if (!take_losses(straight)) break;
    }
    Profiles out;
    for (std::size_t e = 0; e < edges_.size(); ++e) out.edges.push_back(profile(e));
    for (const ProfileLift& lift : lifts_) out.unmet.push_back(is_unmet(lift));
    return out;
  }

 private:
  std::vector<GradedRoad> roads(bool mirrored) const {
    std::vector<GradedRoad> roads;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      roads.push_back({edges_[e].from_node, edges_[e].to_node,
                       mirrored ? upside_down(heights_[e]) : heights_[e], grades_[e]});
    return roads;
  }

  void set_heights(std::vector<HeightLine> solved, bool mirrored) {
    for (std::size_t e = 0; e < solved.size(); ++e)
      heights_[e] = mirrored ? upside_down(std::move(solved[e])) : std::move(solved[e]);
  }

  bool is_off_ground(const ProfileHeight& height) const {
    return height.height > height_at(ground_[height.edge], height.abscissa) + same_place;
  }

  void lift() {
    std::vector<Lift> lifts;
    for (std::size_t l = 0; l < lifts_.size(); ++l)
      if (const ProfileLift& lift = lifts_[l]; !lift.sinks)
        lifts.push_back(
            {lift.below, lift.at_below, lift.above, lift.at_above, lift.clearance + losses_[l]});
    std::vector<LeastHeight> least;
    for (std::size_t h = 0; h < by_hand_.size(); ++h)
      if (const ProfileHeight& height = by_hand_[h]; is_off_ground(height))
        least.push_back({height.edge, height.abscissa, height.height + losses_[lifts_.size() + h]});
    set_heights(least_heights(roads(false), lifts, least), false);
  }

  // A road that sinks takes those along that it passes over.
  void sink() {
    if (std::none_of(lifts_.begin(), lifts_.end(), [](const ProfileLift& l) { return l.sinks; }))
      return;
    std::vector<Lift> lifts;
    for (std::size_t l = 0; l < lifts_.size(); ++l)
      lifts.push_back({lifts_[l].above, lifts_[l].at_above, lifts_[l].below, lifts_[l].at_below,
                       lifts_[l].clearance + (lifts_[l].sinks ? losses_[l] : 0)});
    set_heights(least_heights(roads(true), lifts, {}), true);
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
        bounds[height.edge].lowered.push_back({height.abscissa, losses_[lifts_.size() + h]});
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      bounds[e].ground = ground_[e];
      bounds[e].radius = edges_[e].radius;
      heights_[e] = without_kinks(heights_[e], bounds[e]);
    }
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
      take(&losses_[lifts_.size() + h], by_hand_[h].edge, by_hand_[h].abscissa);
    return less;
  }

  ProfileMethod method_of(std::size_t e) const {
    bool lifted = false, sunk = false;
    for (const HeightPoint& point : heights_[e]) {
      const double over = point.z - height_at(ground_[e], point.at);
      lifted = lifted || over > same_place;
      sunk = sunk || over < -same_place;
    }
    return sunk ? ProfileMethod::sunk : lifted ? ProfileMethod::lifted : ProfileMethod::ground;
  }

  Profile profile(std::size_t e) const {
    const ProfileMethod method = method_of(e);
    return {method == ProfileMethod::ground ? edges_[e].line
                                            : with_heights(edges_[e].line, heights_[e]),
            method, grades_[e]};
  }

  bool is_unmet(const ProfileLift& lift) const {
    return height_at(heights_[lift.above], lift.at_above) <
           height_at(heights_[lift.below], lift.at_below) + lift.clearance - same_place;
  }

  // Each round leaves a quarter of what is too high on flat ground.
  static constexpr int most_rounds = 20;
  static constexpr double rounding_of_losses = 1e-8;  // metres

  const std::vector<ProfileEdge>& edges_;
  const std::vector<ProfileLift>& lifts_;
  const std::vector<ProfileHeight>& by_hand_;
  std::vector<HeightLine> ground_, heights_;
  std::vector<double> grades_;
  // Metres that the arc over each lift, and at each height by hand, may take.
  std::vector<double> losses_;
};

}  // namespace

Profiles joint_profiles(const std::vector<ProfileEdge>& edges,
                        const std::vector<ProfileLift>& lifts,
                        const std::vector<ProfileHeight>& by_hand) {
  return Builder(edges, lifts, by_hand).build();
}

}  // namespace streetgen
