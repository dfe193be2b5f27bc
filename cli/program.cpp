#include "cli/command.h"

namespace tactics {
int run_program(int, char**) { return 0; }
}  // namespace tactics
