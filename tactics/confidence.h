// SPDX-License-Identifier: Apache-2.0
// How sure something is that somebody else found.
#pragma once

#include <string_view>

namespace tactics {

/// `good` stands in a published guideline, standard or manual, or several tools agree on it; `medium` is known at second hand;
/// `uncertain` is one tool's or this project's own.
enum class Confidence { good, medium, uncertain };

constexpr std::string_view name_of(Confidence confidence) {
    return confidence == Confidence::good ? "good" : confidence == Confidence::medium ? "medium" : "uncertain";
}

}  // namespace tactics
