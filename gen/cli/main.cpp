#include "cli/program.h"

int main(int argc, char** argv) { return wold::cli::run(argc, argv); }
