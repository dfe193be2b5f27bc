// SPDX-License-Identifier: Apache-2.0
// What a person calls a thing whose name a modelling program has marked.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// Without the marks of exporters: "OB_Chair_002" and "Chair.001" are a "Chair". A name that is nothing but marks stays.
std::string plain_name(std::string_view name);

/// `inner` names the shape of the thing around it that is called `outer`, and so no thing of its own: ME_Chair within OB_Chair,
/// planche1-FACES within planche1, pCubeShape1 within pCube1, Table within Table.
bool names_shape_of(std::string_view inner, std::string_view outer);

/// A name as words, for braille and speech. An underscore is a blank: names in VRML have none (ISO/IEC 14772-1:1997, annex A,
/// Id). Words that a capital within parts, as in "TableTop", stand apart, where all have three letters or more, so that McDonald
/// and iPhone stay, and a name with blanks of its own stays, too. No letter changes. UTF-8.
std::string name_as_words(std::string_view name);

}  // namespace tactics
