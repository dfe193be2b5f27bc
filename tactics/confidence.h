// SPDX-License-Identifier: Apache-2.0
// How reliable a fact from somebody else is.
#pragma once

#include <string_view>

namespace tactics {

/// `good`: a published guideline, standard or manual says so, or several tools agree; `medium`: known at second hand;
/// `uncertain`: one tool's or this project's own choice.
enum class Confidence { good, medium, uncertain };

constexpr std::string_view name_of(Confidence confidence) {
    return confidence == Confidence::good ? "good" : confidence == Confidence::medium ? "medium" : "uncertain";
}

}  // namespace tactics
