// SPDX-License-Identifier: Apache-2.0
// What `evaluate` was asked to do: complete and checked before the first picture is opened.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/verbs/evaluate_chart.h"
#include "studies/study.h"
#include "tactics/job/disk.h"

namespace tactics {

struct EvaluateRequest : StudyRequest {
    const Study* study = nullptr;        ///< which of them is asked
    std::vector<ChartFile> chart_files;  ///< --chart
    std::string csv;                     ///< file, or empty
    bool json = false;
};

/// Throws Error(usage); Error(failed) for a folder or a recipe file that cannot be read.
EvaluateRequest plan_evaluation(const Given& given, const Disk& disk);

}  // namespace tactics
