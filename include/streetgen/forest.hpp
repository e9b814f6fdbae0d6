// A regression forest: a number that is learnt from samples of several features.  StreetGen paper,
// section 3.1.
#pragma once

#include <vector>

namespace streetgen {

struct ForestSample {
  std::vector<double> features;  // of each sample as many; what is unknown is a number, too
  double value = 0;
};

// The forest as plain numbers: features, trees, and of each tree its nodes, the count first.  A
// node is feature, threshold, and the nodes for values below it and others; a leaf has feature -1,
// and its value for a threshold.
using Forest = std::vector<double>;

// Trees of samples that are drawn with replacement; each node parts the ranks of the values best,
// by one of the features that are drawn for it, and a leaf has the median of its samples.  How few
// samples a leaf may have is what errs least, on the mean, for samples that a tree was not grown
// of.  Trees that do not err less than the median of all samples, by more than the standard error
// and in the median too, are none: the forest is that one number.  The order of the samples does
// not matter, and the same samples grow the same forest.  No sample, or samples of different
// lengths: Error{invalid_input}.
Forest grow_forest(std::vector<ForestSample> samples);

// The median of what the trees say.  Numbers that are no forest, or other features than it has:
// Error{invalid_input}.
double forest_value(const Forest& forest, const std::vector<double>& features);

}  // namespace streetgen
