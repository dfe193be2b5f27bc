#include "print/format.h"

namespace tactics {

namespace {
std::string encode(const Page&, const Settings&) { return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n"; }
}  // namespace

extern const Format svg_format;
const Format svg_format{
    .name = "svg", .summary = "scalable vector graphics", .extensions = "svg", .media_type = "image/svg+xml",
    .medium = "swell", .paper = "a4", .options = {}, .encode = encode,
};

}  // namespace tactics
