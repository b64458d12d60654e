#!/usr/bin/env python3
"""Runs every command and every snippet of the manual, page by page, in the order of the page, in a folder of its own.

usage: snippets.py PROGRAM MODULE_FOLDER [PAGE...]
       snippets.py --commands PAGE        print the commands of a page that are run, to be run elsewhere

The folder has cases/, data/ and build/ringfilm of the checkout, and `ringfilm` is in PATH. What a page takes for
granted
or is written in comments of Markdown before a block, which no reader sees:

    <!-- given: COMMANDS -->       run before the block (or before the page's next one): files that the reader
                                  would have
    <!-- file: NAME -->            the block is this file; written before anything of the page is run
    <!-- file: NAME, checked -->   the same, and `ringfilm check` or Study.read must accept it
    <!-- printed -->               each line of the block was printed by the commands before it; "..." stands for
                                  any text
    <!-- not run: REASON -->       the block is shown only

Blocks of sh and python are run, those of matlab where Octave is installed; toml, json and yaml must at least be that.
Every other block is text. A page with a test of its own, tests/docs/NAME_OF_THE_PAGE.py, is left to that. Exit
code 1 if
anything fails.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", *sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs" / "manual").rglob("*.md"))]
SECONDS_A_BLOCK = 300
PYTHON = "/usr/bin/python3"

# Runs what comes as a line of JSON each, and answers what was printed and whether it failed.
INTERPRETER = """
import contextlib, io, json, sys, traceback
answers, names = sys.stdout, {"__name__": "__main__"}
for line in sys.stdin:
    words, failed = io.StringIO(), False
    with contextlib.redirect_stdout(words):
        try:
            exec(compile(json.loads(line), "<snippet>", "exec"), names)
        except BaseException:
            failed = True
            words.write(traceback.format_exc())
    print(json.dumps([words.getvalue(), failed]), file=answers, flush=True)
"""


class Failure(Exception):
    """A block that does not do what the page states."""


class Block:
    """One block of code and what the comments before it state."""

    def __init__(self, page, line, language, text, marks):
        self.place, self.language, self.text = f"{page}:{line}", language, text
        self.given = [words for kind, words in marks if kind == "given"]
        self.not_run = next((words for kind, words in marks if kind == "not run"), None)
        self.printed = any(kind == "printed" for kind, _ in marks)
        file = next((words for kind, words in marks if kind == "file"), "")
        self.file, _, rest = file.partition(",")
        self.checked = rest.strip() == "checked"


def blocks_of(page):
    """All blocks of a page. A comment counts for the block that follows it."""
    text = (ROOT / page).read_text(encoding="utf-8")
    pattern = re.compile(
        r"^<!-- (given|file|printed|not run)(?:: (.*?))? ?-->$|^( *)```(\w*)[^\n]*\n(.*?)^ *```$", re.M | re.S
    )
    marks, found = [], []
    for match in pattern.finditer(text):
        if match.group(1):
            marks.append((match.group(1), (match.group(2) or "").strip()))
            continue
        body = re.sub(rf"^{match.group(3)}", "", match.group(5), flags=re.M)
        found.append(Block(page, text.count("\n", 0, match.start()) + 1, match.group(4), body, marks))
        marks = []
    return found


class Page:
    """The blocks of one page, run in one folder."""

    def __init__(self, folder, environment, count):
        self.folder, self.environment, self.count = folder, environment, count
        self.output, self.interpreter = "", None

    def command(self, words, what, **more):
        """Runs a command; its output is kept for what follows."""
        done = subprocess.run(
            words,
            cwd=self.folder,
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=SECONDS_A_BLOCK,
            stdin=subprocess.DEVNULL,
            **more,
        )
        self.output = done.stdout + done.stderr
        if done.returncode != 0:
            raise Failure(f"{what} ended with {done.returncode}:\n{self.output[-3000:]}")

    def shell(self, text, what):
        self.command(["bash", "-euo", "pipefail", "-c", text], what)

    def run(self, block):
        """One block."""
        for commands in block.given:
            self.shell(commands, "what is given")
        if block.not_run is not None:
            self.count["not run"].append(f"{block.place}: {block.not_run}")
        elif block.file:
            if block.checked:
                self.check(block)
            self.count["files"] += 1
        elif block.printed:
            for line in filter(str.strip, block.text.split("\n")):
                pattern = ".*".join(map(re.escape, line.strip().split("...")))
                if not re.search(pattern, self.output):
                    raise Failure(f"this was not printed: {line.strip()}\nbut:\n{self.output[-3000:]}")
            self.count["printed"] += 1
        elif block.language in ("sh", "bash"):
            self.shell(block.text, "the command")
            self.count["run"] += 1
        elif block.language == "python":
            self.script(block.text)
            self.count["run"] += 1
        elif block.language == "matlab":
            self.octave(block)
        elif block.language == "toml":
            tomllib.loads(block.text)
            self.count["read"] += 1
        elif block.language == "json":
            json.loads(block.text)
            self.count["read"] += 1
        elif block.language in ("", "text", "csv"):
            self.count["text"] += 1
        else:
            raise Failure(f"nothing is known of blocks in {block.language}; state <!-- not run: why -->")

    def script(self, text):
        """Python, in one interpreter for the whole page: names continue from block to block."""
        if self.interpreter is None:
            self.interpreter = subprocess.Popen(
                [PYTHON, "-c", INTERPRETER],
                cwd=self.folder,
                env=self.environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
        self.interpreter.stdin.write(json.dumps(text) + "\n")
        self.interpreter.stdin.flush()
        answer = self.interpreter.stdout.readline()
        self.output, failed = json.loads(answer) if answer else ("Python ended", True)
        if failed:
            raise Failure(f"the script ended with:\n{self.output[-3000:]}")

    def end(self):
        """Nothing of the page continues."""
        if self.interpreter is not None:
            self.interpreter.stdin.close()
            self.interpreter.wait(60)
            self.interpreter.stdout.close()

    def check(self, block):
        """A whole case or a whole study."""
        if re.search(r"^\[\[base\]\]", block.text, re.M):
            self.command([PYTHON, "-c", f"import ringfilm; ringfilm.Study.read({block.file!r})"], "reading the study")
        else:
            self.shell(f"ringfilm check '{block.file}'", "the check")
        self.count["checked"] += 1

    def octave(self, block):
        octave = shutil.which("octave-cli")
        if not octave:
            self.count["not run"].append(f"{block.place}: Octave is not installed")
            return
        # Without a display there is nothing to draw on: what draws is there, and does nothing.
        for name in ("plot", "hist", "xlabel", "ylabel", "figure"):
            (self.folder / f"{name}.m").write_text(f"function varargout = {name} (varargin)\nend\n")
        (self.folder / "block.m").write_text(f"pkg load netcdf; addpath ('{ROOT / 'matlab'}');\n{block.text}")
        self.command([octave, "--no-gui", "--quiet", "block.m"], "Octave")
        self.count["run"] += 1


def main(program, module, pages):
    count = {"run": 0, "files": 0, "checked": 0, "printed": 0, "read": 0, "text": 0, "elsewhere": 0, "not run": []}
    failures = []
    for page in pages or PAGES:
        started = time.monotonic()
        blocks = blocks_of(page)
        if not blocks:
            continue
        own = ROOT / "tests" / "docs" / (pathlib.Path(page).stem.replace("-", "_") + ".py")
        if own.exists():
            count["elsewhere"] += len(blocks)
            print(f"{page}: {len(blocks)} blocks, left to {own.relative_to(ROOT)}", flush=True)
            continue
        with tempfile.TemporaryDirectory(prefix="snippets-") as name:
            folder = pathlib.Path(name)
            for part in ("cases", "data"):
                shutil.copytree(ROOT / part, folder / part)
            (folder / "build").mkdir()
            (folder / "build" / "ringfilm").symlink_to(program)
            environment = {
                **os.environ,
                "PATH": f"{folder / 'build'}:{os.environ['PATH']}",
                "RINGFILM_DATA": str(ROOT),
                "PYTHONPATH": str(module),
                "MPLBACKEND": "Agg",
                "PYTHONDONTWRITEBYTECODE": "1",
                "HOME": name,
            }
            here = Page(folder, environment, count)
            for block in blocks:
                if block.file:
                    (folder / block.file).write_text(block.text, encoding="utf-8")
            for block in blocks:
                try:
                    here.run(block)
                except (Failure, subprocess.TimeoutExpired, ValueError) as error:
                    failures.append(f"{block.place}: {error}")
                    print(f"FAILED {failures[-1]}", flush=True)
            here.end()
        print(f"{page}: {len(blocks)} blocks, {time.monotonic() - started:.0f} s", flush=True)
    print(
        f"snippets: {count['run']} run, {count['checked']} files of cases and studies checked of {count['files']}, "
        f"{count['printed']} outputs compared, {count['read']} parts of files read, {count['text']} are text, "
        f"{count['elsewhere']} have a test of their own; "
        f"{len(count['not run'])} not run:"
    )
    for line in count["not run"]:
        print(f"  {line}")
    print(f"snippets: {len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    if sys.argv[1] == "--commands":
        for block in blocks_of(sys.argv[2]):
            if block.language == "sh" and block.not_run is None:
                print(block.text, end="")
        sys.exit(0)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]))
