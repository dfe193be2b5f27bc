// SPDX-License-Identifier: Apache-2.0
// The embossers as a printer application offers them: one driver for each entry of the list, and one for each model by its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/verbs/print_options.h"
#include "print/embosser.h"
#include "tactics/medium.h"

namespace tactics {

struct MachineDriver {
    std::string name;    ///< "index-v4", "everest-d-v5"
    std::string people;  ///< what people read: "TACTICS everest-d-v5, tactile graphics"
    const Format* format = nullptr;
};

/// In the order of `tactics list embossers`, each entry before its models.
const std::vector<MachineDriver>& machine_drivers();
const MachineDriver* find_driver(std::string_view name);  ///< nullptr: none

/// The driver for a device that describes itself so (IEEE 1284 id); nullptr: it is no embosser, or one of several.
const MachineDriver* driver_of_device(std::string_view id);

/// What the embosser's PPD file offers, so that a queue of either kind takes the same options; the defaults are those of the
/// model.
PpdWords words_of(const MachineDriver& driver);

/// The papers that the model takes, its default first.
std::vector<Paper> papers_of(const MachineDriver& driver);

/// "tactics-recipe" for TacticsRecipe: names of IPP attributes are in lower case (RFC 8011, 5.1.4). TacticsLabels is
/// tactics-label, as messages about labels spell it.
std::string attribute_of(std::string_view option);

/// Those options of a PPD file that are ours ("TacticsRecipe"), with their defaults, in its order; labels are not among them.
PrintOptions own_options(const PpdWords& words);

/// A message with the names of IPP in the place of those of a PPD file.
std::string in_attributes(std::string message, const PpdWords& words);

/// Title and labels of a print job take any words, whatever choices are listed.
bool takes_any_words(std::string_view option);

}  // namespace tactics
