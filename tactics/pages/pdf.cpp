#include "tactics/pages/pdf.h"

#include "tactics/error.h"
#include "tactics/pages/xml.h"
#include "tactics/transport/child.h"

namespace tactics {

std::string pdf_as_svg(const std::string& path) {
    // The second page, too, only to know that there is one. Without -noshrink and -nocenter it fits the page to a paper of
    // whole points, 0.1 % smaller. A name must not look like an option.
    const ChildAnswer answer = run_child(
        {"pdftocairo", "-svg", "-noshrink", "-nocenter", "-l", "2", path.starts_with('-') ? "./" + path : path, "-"}, "",
        {std::chrono::seconds(60), kMostXmlBytes});
    using End = ChildAnswer::End;
    if (answer.end == End::missing)
        throw Error(Fault::failed, path,
                    "to look at a PDF the program pdftocairo is needed and missing; install poppler-utils, or check the SVG");
    if (!answer.fault.empty())
        throw Error(Fault::failed, path, "pdftocairo cannot be started: " + answer.fault + "; check the SVG instead");
    if (answer.end == End::too_long || answer.end == End::too_much)
        throw Error(Fault::failed, path, "this PDF takes over a minute or 64 MB to be looked at; simplify its drawing");
    if (answer.end != End::done || answer.out.empty())
        throw Error(Fault::failed, path, "pdftocairo cannot read this PDF; open it in a viewer to see what is wrong");
    return answer.out;
}

}  // namespace tactics
