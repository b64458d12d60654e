#include "run_program.hpp"

int main(int argc, char** argv) { return ringfilm::app::run_program(argc, argv); }
