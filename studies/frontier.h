// SPDX-License-Identifier: Apache-2.0
// What the charts of studies have alike: marks, and those that none beats.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studies/study.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// What has a name on a chart: the recipes, and the simplest person after them.
std::vector<std::string> recipes_alone(std::span<const Candidate> candidates);
std::vector<std::string> recipes_and_person(std::span<const Candidate> candidates);

/// Whether each point is one that no other beats: none is at most as far right and at least as high, and not the same.
std::vector<bool> on_frontier(const std::vector<PlotPoint>& points);

/// Sorts the marks by x, a time; fills those that none beats in both, and joins these with a curve.
void join_frontier(Plot& plot);

/// A level line through all marks: what people reach, who take no time that could be told.
void add_level(Plot& plot, const std::string& name, double y);

/// F against the time of a picture: a disc for each recipe that none beats in both, joined by a curve, rings for the others.
Plot frontier_plot(const Evaluation& evaluation);

/// "page.pdf" and "dpi" make "page-dpi.pdf".
std::string with_word(const std::string& path, const std::string& word);

}  // namespace tactics
