"""Runs a module of a package as a program, which ctest and CMake do: python3 common/course test.results check 05_shadow_maps."""

import importlib.util
import runpy
import sys

from tree import Failure

if __name__ == "__main__":
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    package, _, module = name.partition(".")
    if not module or not importlib.util.find_spec(package) or not importlib.util.find_spec(name):
        print(f"common/course: there is no module '{name}'; usage: python3 common/course PACKAGE.MODULE [ARGUMENTS]",
              file=sys.stderr)
        sys.exit(2)
    del sys.argv[0]
    try:
        runpy.run_module(name, run_name="__main__", alter_sys=True)
    except Failure as error:
        sys.exit(str(error))
