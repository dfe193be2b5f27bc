// SPDX-License-Identifier: Apache-2.0
// The plain name of a thing whose name a modelling program has marked.
#pragma once

#include <string>
#include <string_view>

namespace tactics {

/// Without the marks of exporters: "OB_Chair_002" and "Chair.001" are a "Chair". A name that consists only of marks is unchanged.
std::string plain_name(std::string_view name);

/// Whether `inner` names the shape of the enclosing thing `outer`, and thus no separate thing: ME_Chair within OB_Chair,
/// planche1-FACES within planche1, pCubeShape1 within pCube1, Table within Table.
bool names_shape_of(std::string_view inner, std::string_view outer);

/// A name as words, for braille and speech. An underscore becomes a blank, because names in VRML cannot have blanks (ISO/IEC
/// 14772-1:1997, annex A, Id). Words joined by an inner capital, as in "TableTop", are separated if all have three letters or
/// more, so that McDonald and iPhone are unchanged; so is a name with blanks of its own. No letter changes. UTF-8.
std::string name_as_words(std::string_view name);

}  // namespace tactics
