#include "streetgen/forest.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr int trees = 31;
constexpr int deepest = 8;
constexpr std::size_t leaf_sizes[] = {40, 20, 10, 5};
constexpr std::size_t node_numbers = 4;

using Samples = std::vector<ForestSample>;
using Places = std::vector<std::size_t>;

double median(std::vector<double> values) {
  const std::size_t half = (values.size() - 1) / 2;
  std::nth_element(values.begin(), values.begin() + half, values.end());
  return values[half];
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / values.size();
}

// The rank of each value, equal ones with the mean of theirs: splits that look at ranks do not
// follow a few wild values.
std::vector<double> ranks_of(const Samples& samples) {
  Places order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(samples[a].value, a) < std::tuple(samples[b].value, b);
  });
  std::vector<double> ranks(samples.size());
  for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
    while (j < order.size() && samples[order[j]].value == samples[order[i]].value) ++j;
    for (std::size_t k = i; k < j; ++k) ranks[order[k]] = (i + j - 1) / 2.0;
  }
  return ranks;
}

struct Split {
  std::size_t feature = 0;
  double threshold = 0;
  double gain = 0;  // of squares of ranks
};

class Grower {
 public:
  Grower(const Samples& samples, std::size_t leaf_size)
      : samples_(samples), ranks_(ranks_of(samples)), leaf_size_(leaf_size) {}

  // The nodes of one tree.
  std::vector<double> tree(Places drawn, std::mt19937_64& random) {
    nodes_.clear();
    grow(drawn, 0, random);
    return nodes_;
  }

 private:
  std::size_t grow(Places& places, int depth, std::mt19937_64& random) {
    poll_cancel();
    const std::size_t node = nodes_.size() / node_numbers;
    nodes_.resize(nodes_.size() + node_numbers, 0);
    const Split split = depth < deepest ? best_split(places, random) : Split{};
    double* numbers = &nodes_[node * node_numbers];
    if (!(split.gain > 0)) {
      std::vector<double> values;
      for (const std::size_t p : places) values.push_back(samples_[p].value);
      numbers[0] = -1;
      numbers[1] = median(std::move(values));
      return node;
    }
    numbers[0] = static_cast<double>(split.feature);
    numbers[1] = split.threshold;
    const auto middle = std::partition(places.begin(), places.end(), [&](std::size_t p) {
      return samples_[p].features[split.feature] < split.threshold;
    });
    Places below(places.begin(), middle), others(middle, places.end());
    std::sort(below.begin(), below.end());
    std::sort(others.begin(), others.end());
    const std::size_t left = grow(below, depth + 1, random);
    const std::size_t right = grow(others, depth + 1, random);
    nodes_[node * node_numbers + 2] = static_cast<double>(left);
    nodes_[node * node_numbers + 3] = static_cast<double>(right);
    return node;
  }

  Split best_split(Places& places, std::mt19937_64& random) const {
    const std::size_t features = samples_.front().features.size();
    std::vector<std::size_t> drawn(features);
    std::iota(drawn.begin(), drawn.end(), 0);
    for (std::size_t i = 0; i + 1 < features; ++i)
      std::swap(drawn[i], drawn[i + random() % (features - i)]);
    drawn.resize((2 * features + 2) / 3);
    std::sort(drawn.begin(), drawn.end());
    Split best;
    for (const std::size_t feature : drawn) look_along(feature, places, best);
    return best;
  }

  void look_along(std::size_t feature, Places& places, Split& best) const {
    const auto at = [&](std::size_t i) { return samples_[places[i]].features[feature]; };
    std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(samples_[a].features[feature], a) <
             std::tuple(samples_[b].features[feature], b);
    });
    double all = 0, before = 0;
    for (const std::size_t p : places) all += ranks_[p];
    const double count = static_cast<double>(places.size());
    for (std::size_t i = 1; i < places.size(); ++i) {
      before += ranks_[places[i - 1]];
      if (i < leaf_size_ || places.size() - i < leaf_size_ || !(at(i - 1) < at(i))) continue;
      const double n = static_cast<double>(i), behind = all - before;
      const double gain = before * before / n + behind * behind / (count - n) - all * all / count;
      if (gain > best.gain + 1e-9 * std::abs(best.gain))
        best = {feature, at(i - 1) + (at(i) - at(i - 1)) / 2, gain};
    }
  }

  const Samples& samples_;
  const std::vector<double> ranks_;
  const std::size_t leaf_size_;
  std::vector<double> nodes_;
};

[[noreturn]] void no_forest(const char* why) {
  throw Error(ErrorKind::invalid_input, std::string("the forest ") + why);
}

// What a tree of so many nodes says.  Each node on the way leads to one behind itself.
double tree_value(const double* nodes, std::size_t count, const std::vector<double>& features) {
  std::size_t at = 0;
  for (const double* node = nodes; node[0] != -1; node = nodes + at * node_numbers) {
    const double feature = node[0];
    if (!(feature >= 0 && feature < static_cast<double>(features.size()) &&
          feature == std::floor(feature)))
      no_forest("asks for a feature that is none");
    const double to = node[features[static_cast<std::size_t>(feature)] < node[1] ? 2 : 3];
    if (!(to > static_cast<double>(at) && to < static_cast<double>(count) && to == std::floor(to)))
      no_forest("has a node that leads nowhere");
    at = static_cast<std::size_t>(to);
  }
  return nodes[at * node_numbers + 1];
}

// The error of each sample by trees that were not grown of it, and by one number for all.
struct Tried {
  Forest forest;
  std::vector<double> errors, of_one_number;
};

Tried try_leaf_size(const Samples& samples, std::size_t leaf_size, double one_number) {
  std::mt19937_64 random(1);
  Grower grower(samples, leaf_size);
  Tried tried;
  tried.forest = {static_cast<double>(samples.front().features.size()), trees};
  std::vector<std::vector<double>> said(samples.size());
  for (int t = 0; t < trees; ++t) {
    Places drawn(samples.size());
    std::vector<bool> within(samples.size());
    for (std::size_t& place : drawn) within[place = random() % samples.size()] = true;
    std::sort(drawn.begin(), drawn.end());
    const std::vector<double> nodes = grower.tree(drawn, random);
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!within[i])
        said[i].push_back(
            tree_value(nodes.data(), nodes.size() / node_numbers, samples[i].features));
    tried.forest.push_back(static_cast<double>(nodes.size() / node_numbers));
    tried.forest.insert(tried.forest.end(), nodes.begin(), nodes.end());
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (said[i].empty()) continue;
    tried.errors.push_back(std::abs(median(said[i]) - samples[i].value));
    tried.of_one_number.push_back(std::abs(one_number - samples[i].value));
  }
  return tried;
}

// Whether trees err less than one number on the mean, by more than what chance makes of so many
// samples (the standard error), and no more in the median.
bool better_than_one_number(const Tried& tried) {
  const double count = static_cast<double>(tried.errors.size());
  if (count < 2) return false;
  std::vector<double> gains(tried.errors.size()), squares(tried.errors.size());
  std::transform(tried.of_one_number.begin(), tried.of_one_number.end(), tried.errors.begin(),
                 gains.begin(), std::minus<>());
  const double gain = mean(gains);
  std::transform(gains.begin(), gains.end(), squares.begin(),
                 [&](double g) { return (g - gain) * (g - gain); });
  return gain > std::sqrt(mean(squares) / (count - 1)) &&
         median(tried.errors) <= median(tried.of_one_number);
}

double median_of(const Samples& samples) {
  std::vector<double> values;
  for (const ForestSample& sample : samples) values.push_back(sample.value);
  return median(std::move(values));
}

}  // namespace

Forest grow_forest(Samples samples) {
  if (samples.empty()) throw Error(ErrorKind::invalid_input, "there is no sample to learn from");
  for (const ForestSample& sample : samples)
    if (sample.features.empty() || sample.features.size() != samples.front().features.size())
      throw Error(ErrorKind::invalid_input, "samples have different numbers of features");
  std::sort(samples.begin(), samples.end(), [](const ForestSample& a, const ForestSample& b) {
    return std::tie(a.features, a.value) < std::tie(b.features, b.value);
  });
  const double one_number = median_of(samples);
  Forest best = {static_cast<double>(samples.front().features.size()), 1, 1, -1, one_number, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t size : leaf_sizes) {
    Tried tried = try_leaf_size(samples, size, one_number);
    if (!better_than_one_number(tried) || !(mean(tried.errors) < least)) continue;
    least = mean(tried.errors);
    best = std::move(tried.forest);
  }
  return best;
}

double forest_value(const Forest& forest, const std::vector<double>& features) {
  if (forest.size() < 2 || !(forest[1] >= 1 && forest[1] <= 1000)) no_forest("has no trees");
  if (forest[0] != static_cast<double>(features.size()))
    no_forest("is one of another number of features");
  std::vector<double> said;
  std::size_t at = 2;
  for (int t = 0; t < forest[1]; ++t) {
    if (at >= forest.size() || !(forest[at] >= 1) ||
        !(forest[at] * node_numbers <= forest.size() - at - 1))
      no_forest("ends within a tree");
    const auto count = static_cast<std::size_t>(forest[at]);
    said.push_back(tree_value(&forest[at + 1], count, features));
    at += 1 + count * node_numbers;
  }
  return median(std::move(said));
}

}  // namespace streetgen
