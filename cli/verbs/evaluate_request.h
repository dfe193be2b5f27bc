// SPDX-License-Identifier: Apache-2.0
// The request of `evaluate`, complete and checked before the first picture is opened.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/evaluate_chart.h"
#include "studies/study.h"
#include "tactics/job/disk.h"

namespace tactics {

struct EvaluateRequest : StudyRequest {
    const Study* study = nullptr;        ///< the chosen study
    std::vector<ChartFile> chart_files;  ///< --chart
    std::string csv;                     ///< file, or empty
    bool json = false;
};

/// Throws Error(usage); Error(failed) for a folder or a recipe file that cannot be read.
EvaluateRequest plan_evaluation(const Given& given, const Disk& disk);

}  // namespace tactics
