// What embossers of Index Braille have in common.
#pragma once

#include <span>
#include <string>

#include "print/embosser.h"
#include "print/format.h"

namespace tactics {

/// ESC D key,key,...; for this job only (firmware 10.30 and newer; an older one would emboss it as text, so "setup=no" leaves it
/// out): no margins of its own, single-sided, these keys besides.
std::string index_set_up(const Settings& settings, const std::string& keys);

/// The pages in 4-dot graphics: each byte @ to O is a column of four dots, the topmost its lowest bit.
std::string four_dot_job(std::span<const Page> pages, const std::string& set_up);

/// Braille and raster for a graphic pitch of "1.6", "2.0" or "2.5" mm.
DotSetting four_dot_setting(std::string_view pitch, Point first);

}  // namespace tactics
