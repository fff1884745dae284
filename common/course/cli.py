"""The ./course command, once its packages are there: finds the command's module and runs it.

Each command is a module with HELP, `add_arguments(parser)` and `run(arguments, rest) -> exit code`, where rest holds
unknown arguments; a module without PASSES_OPTIONS refuses it. One with `run_words(words)` parses for itself.
Of a module that says ALONE, two at once in one tree run one after the other; with SHARDS_APART, two shards do not wait.
Exit codes: 0; 1 it failed; 2 it was asked wrongly; 3 this machine cannot judge, or starts no more processes; 130 it was
interrupted, 143 it was ended.
"""

import argparse
import errno
import importlib
import os
import resource
import signal
import sys
import threading
from pathlib import Path

from build.build import alone
from commands import COMMANDS, MOVED, Parser, names, selected
from tree import BUILD, CLOSED, ROOT, Failure, Unjudged, UsageError, copy_words, keep_environment, nearest, warn


def main(words: list[str]) -> int:
    command = words[0] if words else ""
    if command in MOVED:
        raise UsageError(f"'{command}' is now ./course {MOVED[command]}")
    if command not in names():
        raise UsageError(f"there is no command '{command}'; {nearest(command, names())}; ./course --help lists all")
    if "" in words:  # as of a variable that is not set; without the word, a command may mean all there is
        raise UsageError(f"an argument is empty; see ./course {command} --help")
    key = selected(command, words[1:])
    module = importlib.import_module(COMMANDS[key])
    if hasattr(module, "run_words"):
        return module.run_words(words[1:])
    parser = Parser(prog=f"./course {command}", formatter_class=argparse.RawDescriptionHelpFormatter,
                    description=module.HELP, allow_abbrev=False)
    parser.see = f"; see ./course {key} --help"
    module.add_arguments(parser)
    arguments, rest = parser.parse_known_args(words[1:])
    if rest and not getattr(module, "PASSES_OPTIONS", False):
        parser.error(f"unrecognised argument '{rest[0]}'")
    if getattr(module, "ALONE", False):
        shard = getattr(module, "SHARDS_APART", False) and arguments.shard
        with alone(BUILD, COMMANDS[key] + (f".{shard.number}-of-{shard.of}" if shard else "")):
            return module.run(arguments, rest)
    return module.run(arguments, rest)


def on_one_line(message: str) -> str:
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in message)


def forget_output():
    """Where it cannot be written: Python would try once more at its end."""
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


THREADS = 16  # and processes, at once: a build with two compilers


def refuse_few_threads():
    """Raises RuntimeError where the machine starts fewer: whatever comes first would fail in its own words, or wait for ever."""
    go, started = threading.Event(), []
    try:
        for _ in range(THREADS):
            one = threading.Thread(target=go.wait)
            one.start()
            started.append(one)
    finally:
        go.set()
        for one in started:
            one.join()


def refused():
    warn(f"course: this machine starts no more processes and threads: raise ulimit -u ({resource.getrlimit(resource.RLIMIT_NPROC)[0]}), "
         "or the limit of the container's processes")
    sys.exit(3)


MISPLACED = (errno.ENAMETOOLONG, errno.ELOOP, errno.EISDIR, errno.ENOTDIR, errno.EEXIST)  # what a person named is something else


class Ended(BaseException):
    """SIGTERM: children are ended on the way out, as after Ctrl+C."""


def end(*_):
    raise Ended


if __name__ == "__main__":
    keep_environment()
    signal.signal(signal.SIGTERM, end)
    for stream in (sys.stdout, sys.stderr):  # a name on the command line need not be text
        stream.reconfigure(errors="backslashreplace")
    try:
        refuse_few_threads()
        sys.exit(main(sys.argv[1:]))
    except UsageError as error:
        if str(error):
            warn(f"course: {on_one_line(str(error))}")
        sys.exit(2)
    except Unjudged as error:
        warn(f"course: {on_one_line(str(error))}")
        sys.exit(3)
    except Failure as error:
        if str(error):
            warn(f"course: {error}")
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
    except Ended:
        sys.exit(143)
    except BrokenPipeError:
        forget_output()
        sys.exit(128 + signal.SIGPIPE)
    except RuntimeError as error:
        if "start new thread" not in str(error):
            raise
        refused()
    except OSError as error:  # a disk that is full, a folder that is another's: no fault of the course
        forget_output()
        if error.strerror == os.strerror(errno.EAGAIN):
            refused()
        where = f"{error.filename}: " if error.filename is not None else ""
        closed = error.errno in CLOSED
        advice = copy_words() if closed and Path(str(error.filename)).is_relative_to(ROOT) else ""
        warn(f"course: {where}{error.strerror or error}{advice}")
        sys.exit(2 if closed and error.errno != errno.ENOSPC or error.errno in MISPLACED else 1)
