// check_NN_name: runs the checks of a chapter's exercises and prints one JSON object for each.
#include "common/check/run_checks.h"

int main(int argc, char** argv) { return lightwalk::run_checks(argc, argv); }
