// SPDX-License-Identifier: Apache-2.0
#include "studies/list.h"

#include <algorithm>

namespace tactics {

#define STUDY(name) extern const Study name##_study;
#include "studies/list.inc"
#undef STUDY

std::span<const Study* const> studies() {
    static const Study* const kStudies[] = {
#define STUDY(name) &name##_study,
#include "studies/list.inc"
#undef STUDY
    };
    return kStudies;
}

const Study* find_study(std::string_view name) {
    for (const Study* study : studies())
        if (study->name == name) return study;
    return nullptr;
}

std::vector<std::string_view> study_names() {
    std::vector<std::string_view> names;
    for (const Study* study : studies())
        if (!study->name.empty()) names.push_back(study->name);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace tactics
