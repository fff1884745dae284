"""CMakeLists.txt: what it asks of ccache, in a small project with a precompiled header."""
# Builds: nothing

import os
import shutil
import subprocess
from pathlib import Path

from folder_case import FolderCase

REAL = Path(__file__).parents[2]


class Ccache(FolderCase):
    def test_a_header_changed_after_another_build_is_compiled(self):
        """The same precompiled header was changed in another way before: ccache once took that one."""
        launcher = (REAL / "CMakeLists.txt").read_text().partition("find_program(CCACHE")[2].partition("find_program(MOLD")[0]
        (self.folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.22)\nproject(small LANGUAGES CXX)\n"
                                                    f"find_program(CCACHE{launcher}add_executable(small main.cpp)\n"
                                                    "target_precompile_headers(small PRIVATE <string> ${PROJECT_SOURCE_DIR}/value.h)\n")
        (self.folder / "main.cpp").write_text("int main() { return value(); }\n")
        environment = {**os.environ, "CCACHE_DIR": str(self.folder / "cache")}
        header = self.folder / "value.h"

        def built(value: int) -> int:
            header.write_text(f"inline int value() {{ return {value}; }}\n")
            subprocess.run(["cmake", "--build", self.folder / "build"], env=environment, check=True, stdout=subprocess.DEVNULL)
            return subprocess.run([self.folder / "build/small"]).returncode
        for other in (2, 3):
            header.write_text("inline int value() { return 1; }\n")
            shutil.rmtree(self.folder / "build", ignore_errors=True)
            subprocess.run(["cmake", "-S", self.folder, "-B", self.folder / "build", "-G", "Ninja"], check=True, stdout=subprocess.DEVNULL)
            self.assertEqual([built(1), built(other)], [1, other])


class Sources(FolderCase):
    def test_what_lies_beside_a_source_is_none(self):
        """An editor's lock, a copy, a backup: CMake's patterns match them, and a link to nothing ends it."""
        functions = (REAL / "common/build.cmake").read_text().partition("# common: the library of all programs")[0]
        (self.folder / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.22)\nproject(small LANGUAGES CXX)\n{functions}\n"
                                                    "lightwalk_library(small base)\nget_target_property(found small SOURCES)\nmessage(\"found ${found}\")\n")
        base = self.folder / "common/base"
        for name in ("one.cpp", "one (copy).cpp", "._one.cpp", "one.cpp~"):
            self.write(f"common/base/{name}", "int one;")
        (base / ".#one.cpp").symlink_to("me@host.1:17")
        done = subprocess.run(["cmake", "-S", self.folder, "-B", self.folder / "build", "-G", "Ninja"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual((done.returncode, f"found {base}/one.cpp\n" in done.stdout), (0, True), done.stdout)
