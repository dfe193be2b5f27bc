// SPDX-License-Identifier: Apache-2.0
// Dots and dashes of lines that are drawn, which are no marks of the print that they pass.
#pragma once

#include "tactics/image.h"

namespace tactics {

/// The picture without dots and dashes of rows: five or more of one length, as far apart from each other, on a course that bends
/// little, and dashes along it. Points of numbers in a column stand farther apart, and letters across their row. A link of a
/// diagram that passes by its name would become marks of it.
Image without_dotted_rows(Image grey);

}  // namespace tactics
