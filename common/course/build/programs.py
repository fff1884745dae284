"""Builds the chapters' programs one after the other and says how far each is, so that each can be used once it is there."""

import re
import shutil
import subprocess
import threading
from dataclasses import dataclass

from build.build import build
from tree import ROOT, Failure, chapters, warn

LINKED = re.compile(r"Linking CXX executable (?:\S*/)?chapters/(\S+)$", re.M)


@dataclass
class State:
    """waiting, building, ready or failed; of a chapter that is being built, how many of its steps are done."""

    name: str = "waiting"
    done: int = 0
    total: int = 0


def unbuilt() -> list[str]:
    """The chapters without an up-to-date program. The build folder is configured."""
    # Asked by a copy: a dry run of build.ninja itself ends where it would configure again, because of CONFIGURE_DEPENDS.
    folder, asked = ROOT / "build", "asked.ninja"
    shutil.copy(folder / "build.ninja", folder / asked)
    done = subprocess.run(["ninja", "-C", folder, "-f", asked, "-n", "programs"], stdin=subprocess.DEVNULL, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    linked = set(LINKED.findall(done.stdout))
    return [chapter for chapter in chapters() if chapter in linked]


class Programs:
    """All chapters' programs, built in a thread of its own: start(), then stop(). `changed` is called, from that thread, with
    each step; `wanted` names the chapter that a person waits for, or none."""

    def __init__(self, changed=lambda: None, wanted=lambda: None):
        self.states = {chapter: State("ready") for chapter in chapters()}
        for chapter in unbuilt():
            self.states[chapter].name = "waiting"
        self.changed, self.wanted, self.stopping = changed, wanted, threading.Event()
        self.ninja = None
        self.thread = threading.Thread(target=self.build_all, daemon=True)

    def start(self):
        self.thread.start()

    def stop(self):
        self.stopping.set()
        if self.ninja:
            self.ninja.terminate()
        if self.thread.is_alive():
            self.thread.join()

    def ready(self) -> list[str]:
        return [chapter for chapter, state in self.states.items() if state.name == "ready"]

    def build_all(self):
        while not self.stopping.is_set() and (chapter := self.next()):
            self.build_one(chapter)

    def next(self) -> str | None:
        wanted = self.wanted()
        if wanted in self.states and self.states[wanted].name == "waiting":  # one that failed is tried by the next ./course run
            return wanted
        return next((chapter for chapter, state in self.states.items() if state.name == "waiting"), None)

    def build_one(self, chapter: str):
        state = self.states[chapter]
        state.name, state.done, state.total = "building", 0, 0

        def show(done, total, _note):
            state.done, state.total = done, total
            self.changed()

        def give_way() -> bool:
            wanted = self.wanted()
            return self.stopping.is_set() or (wanted != chapter and wanted in self.states and
                                              self.states[wanted].name == "waiting")
        def started(ninja):
            self.ninja = ninja
            if self.stopping.is_set():
                ninja.terminate()
        self.changed()
        try:
            ended = build([chapter], show=show, give_way=give_way, started=started)
            state.name = "ready" if ended else "waiting"
        except Failure as failure:
            state.name = "failed"
            warn(getattr(failure, "said", "") or str(failure))
        self.changed()
