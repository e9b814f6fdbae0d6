#include "streetgen/mean_line.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace {

// Shares of one length that differ by less are one.
constexpr double same_share = 1e-9;

struct Vertex {
  double share;
  Point place;
};

std::vector<Vertex> by_share(const Line& line) {
  const double total = length(line);
  std::vector<Vertex> vertices;
  double before = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) before += distance(line[i - 1], line[i]);
    vertices.push_back({total > 0 ? before / total : 0, planar(line[i])});
  }
  vertices.back().share = 1;
  return vertices;
}

// `at` is the first vertex that is not before the share, and moves on with it.
Point place_at(const std::vector<Vertex>& vertices, double share, std::size_t& at) {
  while (at + 1 < vertices.size() && vertices[at].share < share) ++at;
  const Vertex& after = vertices[at];
  if (at == 0 || after.share <= share) return after.place;
  const Vertex& before = vertices[at - 1];
  return before.place +
         (after.place - before.place) * ((share - before.share) / (after.share - before.share));
}

std::vector<double> all_shares(const std::vector<std::vector<Vertex>>& lines) {
  std::vector<double> shares;
  for (const auto& line : lines)
    for (const Vertex& vertex : line) shares.push_back(vertex.share);
  std::sort(shares.begin(), shares.end());
  const auto repeats = [](double a, double b) { return b - a < same_share; };
  shares.erase(std::unique(shares.begin(), shares.end(), repeats), shares.end());
  shares.back() = 1;
  return shares;
}

}  // namespace

Line mean_line(const std::vector<Line>& lines) {
  std::vector<std::vector<Vertex>> vertices;
  for (const Line& line : lines)
    if (!line.empty()) vertices.push_back(by_share(line));
  if (vertices.empty()) return {};
  std::vector<std::size_t> at(vertices.size(), 0);
  Line mean;
  for (const double share : all_shares(vertices)) {
    Point sum;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      sum = sum + place_at(vertices[i], share, at[i]);
    mean.push_back(sum * (1.0 / static_cast<double>(vertices.size())));
  }
  mean = distinct(std::move(mean));
  return mean.size() < 2 ? Line{} : mean;
}

}  // namespace streetgen
