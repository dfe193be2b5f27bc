// SPDX-License-Identifier: Apache-2.0
// The program's choice of a recipe for many pictures: reads their names, a line each, and writes for each the name, the recipe,
// the traits that it was chosen by and the seconds that the look took, tab-separated. tests/bench/choice makes the pictures and
// counts.
#include <chrono>
#include <exception>
#include <iostream>
#include <string>

#include "filters/choose.h"
#include "filters/traits.h"
#include "tactics/readers/read.h"

namespace {

using namespace tactics;

constexpr ReadRequest kLook{500, true};  // as tactics/job/reading.cpp looks at a picture

void tell(const std::string& name) {
    Source source = open_source(name);
    const Image picture = read_picture(source, kLook);
    const auto start = std::chrono::steady_clock::now();
    const Choice choice = choose_recipe(picture);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const Traits traits = traits_of(picture);
    std::cout << name << '\t' << choice.recipe << '\t' << choice.reason.english() << '\t' << traits.noise << '\t' << traits.flat
              << '\t' << traits.soft << '\t' << traits.clear << '\t' << traits.few << '\t' << traits.ground << '\t' << traits.rim
              << '\t' << traits.paper << '\t' << traits.colourful << '\t' << traits.thick << '\t' << traits.range << '\t'
              << traits.lightest << '\t' << traits.darkest << '\t' << seconds.count() << '\n';
}

}  // namespace

int main() {
    std::cout << "name\trecipe\treason\tnoise\tflat\tsoft\tclear\tfew\tground\trim\tpaper\tcolourful\tthick\trange\tlightest\tdar"
                 "kest\tseconds\n";
    int failed = 0;
    for (std::string name; std::getline(std::cin, name);) try {
            tell(name);
        } catch (const std::exception& error) {
            std::cerr << name << ": " << error.what() << '\n';
            failed = 2;
        }
    return failed;
}
