#include "block/kerb_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// Ends of two kerbs may have been cut at two vertices of one place each.
constexpr double joined = same_site;

bool before(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// The turn to the right from the way back, radians in (0, 2 pi].
double turn_from_back(const Point& came, const Point& goes) {
  const Point back = came * -1;
  const double turn = std::atan2(-cross(back, goes), dot(back, goes));
  return turn > 0 ? turn : turn + 2 * M_PI;
}

class KerbJoiner {
 public:
  explicit KerbJoiner(const std::vector<Kerb>& kerbs) : kerbs_(kerbs), next_(kerbs.size(), -1) {
    for (int k = 0; k < count(); ++k) starts_.push_back({kerbs[k].line.front(), k});
    std::sort(starts_.begin(), starts_.end(), [](const Start& a, const Start& b) {
      return a.point.x != b.point.x ? a.point.x < b.point.x : a.kerb < b.kerb;
    });
    for (int k = 0; k < count(); ++k) {
      poll_cancel();
      next_[k] = next_of(kerbs[k].line);
    }
  }

  KerbLoops join() const {
    KerbLoops found;
    std::vector<bool> seen(kerbs_.size());
    for (int first = 0; first < count(); ++first) {
      if (seen[first]) continue;
      std::vector<int> chain;
      int k = first;
      for (; k >= 0 && !seen[k]; k = next_[k]) {
        seen[k] = true;
        chain.push_back(k);
      }
      if (k == first)
        found.loops.push_back(loop_of(std::move(chain)));
      else
        found.loose.insert(found.loose.end(), chain.begin(), chain.end());
    }
    std::sort(found.loops.begin(), found.loops.end(), [](const KerbLoop& a, const KerbLoop& b) {
      return before(a.ring.front(), b.ring.front());
    });
    return found;
  }

 private:
  struct Start {
    Point point;
    int kerb;
  };

  int count() const { return static_cast<int>(kerbs_.size()); }

  // The nearest; of those in one place the one that turns most to the left.
  int next_of(const Line& line) const {
    const Point& end = line.back();
    const Point came = end - line[line.size() - 2];
    int next = -1;
    double nearest = 0, least = 0;
    auto start = std::lower_bound(starts_.begin(), starts_.end(), end.x - joined,
                                  [](const Start& s, double x) { return s.point.x < x; });
    for (; start != starts_.end() && start->point.x <= end.x + joined; ++start) {
      const double apart = distance(start->point, end);
      if (apart > joined || (next >= 0 && apart > nearest + rounding)) continue;
      const Line& other = kerbs_[start->kerb].line;
      const double turn = turn_from_back(came, other[1] - other[0]);
      if (next >= 0 && apart > nearest - rounding && turn >= least) continue;
      next = start->kerb;
      nearest = apart;
      least = turn;
    }
    return next;
  }

  // The same whatever numbers the kerbs have: the way begins at its least vertex, and of two ends
  // in one place that of the kerb before stays.
  KerbLoop loop_of(std::vector<int> chain) const {
    const auto first = std::min_element(chain.begin(), chain.end(), [&](int a, int b) {
      return before(kerbs_[a].line.front(), kerbs_[b].line.front());
    });
    std::rotate(chain.begin(), first, chain.end());
    Ring ring;
    Box box;
    for (const int k : chain)
      for (const Point& p : kerbs_[k].line)
        if (ring.empty() || distance(ring.back(), p) > joined) {
          ring.push_back(p);
          box.add(p);
        }
    while (ring.size() > 1 && distance(ring.front(), ring.back()) <= joined) ring.pop_back();
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
    ring.push_back(ring.front());
    return {std::move(ring), box, std::move(chain)};
  }

  const std::vector<Kerb>& kerbs_;
  std::vector<Start> starts_;  // by x
  std::vector<int> next_;
};

}  // namespace

KerbLoops kerb_loops(const std::vector<Kerb>& kerbs) { return KerbJoiner(kerbs).join(); }

}  // namespace streetgen
