// SPDX-License-Identifier: Apache-2.0
// The common part of the charts of studies: marks, and the marks on the frontier.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studies/study.h"
#include "tactics/measure/evaluation.h"

namespace tactics {

/// The named items on a chart: the recipes, then the simplest person.
std::vector<std::string> recipes_alone(std::span<const Candidate> candidates);
std::vector<std::string> recipes_and_person(std::span<const Candidate> candidates);

/// Whether each point is on the frontier: no different point is both at most as far right and at least as high.
std::vector<bool> on_frontier(const std::vector<PlotPoint>& points);

/// Sorts the marks by x, a time; fills those on the frontier, and joins them with a curve.
void join_frontier(Plot& plot);

/// A horizontal line for the score of people, whose time is unknown.
void add_level(Plot& plot, const std::string& name, double y);

/// F against the time of a picture: discs joined by a curve for the recipes on the frontier, rings for the others.
Plot frontier_plot(const Evaluation& evaluation);

/// "page.pdf" and "dpi" make "page-dpi.pdf".
std::string with_word(const std::string& path, const std::string& word);

}  // namespace tactics
