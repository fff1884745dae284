"""Starts a sandbox and ends it with its caller: supervise.py LIFELINE TOLD COMMAND...

LIFELINE is the end of a pipe; the grader alone has the other end, which closes when the grader ends, even by SIGKILL. Then
bubblewrap's child is killed before bubblewrap itself, which alone has it: one that is on its way into its own world has not
asked yet to die with its parent. At its end the processor time of all in it is written to TOLD. Nothing is imported that takes time.
"""

import os
import resource
import select
import signal
import sys


def main(lifeline: int, told: int, words: list[str]) -> int:
    os.set_inheritable(lifeline, False)
    child = os.fork()
    if child == 0:
        os.execvp(words[0], words)
    ended = os.pidfd_open(child)
    poll = select.poll()
    poll.register(ended, select.POLLIN)
    poll.register(lifeline, select.POLLIN | select.POLLHUP)
    while ended not in (ready := [number for number, _ in poll.poll()]):
        if lifeline in ready:
            end(child)
            break
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    os.write(told, b'\n{"processor-s": %f}\n' % (used.ru_utime + used.ru_stime))
    return code if code >= 0 else 128 - code


def end(child: int):
    os.kill(child, signal.SIGSTOP)  # it has no more children than it has
    try:
        with open(f"/proc/{child}/task/{child}/children", encoding="utf-8") as listed:
            inside = [int(word) for word in listed.read().split()]
    except OSError:
        inside = []
    for one in [*inside, child]:
        try:
            os.kill(one, signal.SIGKILL)
        except OSError:
            pass


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]))
