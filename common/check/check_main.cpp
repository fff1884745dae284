// Program check_NN_name: checks a chapter's exercises, printing one JSON object each.
#include "common/check/run_checks.h"

int main(int argc, char** argv) { return lightwalk::run_checks(argc, argv); }
