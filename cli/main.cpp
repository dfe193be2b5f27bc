#include "cli/command.h"

int main(int count, char** words) { return tactics::run_program(count, words); }
