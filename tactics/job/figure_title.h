// SPDX-License-Identifier: Apache-2.0
// The title at the top of a figure.
#pragma once

#include <string>
#include <vector>

#include "filters/first_ink.h"
#include "tactics/job/axis_names.h"
#include "tactics/job/told_words.h"

namespace tactics {

/// The topmost words are the page's title if they stand above all that is drawn, in one line or several, with no words beside
/// them, and are larger than others, say more than a name, or stand free. They are marked, because no name represents them then.
/// A word by itself to which a line leads from below is the first thing of a graph. Empty: there is no title. `places` are those
/// of `told`; `first` is where the drawing begins.
std::string take_title(std::vector<ToldWords>& told, const std::vector<PrintPlace>& places, const FirstInk& first);

}  // namespace tactics
