"""A copy of the project to which a page's own changes are made, and programs of the build with the changed sources in.

A changed source is compiled by the command of the build and linked before the libraries, which takes seconds: a library
gives up its own copy of an object where the symbols are there already.
"""

import filecmp
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])


class Project:
    """The copy. Use with `with`."""

    def __init__(self, page):
        self.page = page
        self._scratch = tempfile.TemporaryDirectory(dir=BUILD)
        self.scratch = pathlib.Path(self._scratch.name)
        self.folder = self.scratch / "project"

    def __enter__(self):
        self.folder.mkdir()
        for entry in SOURCE.iterdir():
            if entry.name.startswith((".", "build")) or entry.name in ("shared", "fuzz"):
                continue
            if entry.is_dir():
                shutil.copytree(
                    entry, self.folder / entry.name, ignore=shutil.ignore_patterns("node_modules", "__pycache__")
                )
            else:
                shutil.copy(entry, self.folder / entry.name)
        return self

    def __exit__(self, *_):
        self._scratch.cleanup()

    def fail(self, words):
        sys.exit(f"{self.page}: {words}")

    def run(self, *command, expect=0, **options):
        """What a command printed, both streams; its exit code must be `expect`, or, if that is None, anything but 0."""
        done = subprocess.run(
            [str(word) for word in command],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
            **options,
        )
        if (done.returncode == 0) if expect is None else (done.returncode != expect):
            self.fail(f"{' '.join(map(str, command))[:200]} ended with {done.returncode}\n{done.stdout[-4000:]}")
        return done.stdout

    def changes(self):
        """The changes in the page's blocks of diff, by file; each is made to the copy."""
        made = {}
        for block in re.findall(r"^```diff\n(.*?)^```$", (SOURCE / self.page).read_text(encoding="utf-8"), re.M | re.S):
            for change in re.split(r"^(?=--- )", block, flags=re.M)[1:]:
                made[re.match(r"--- \S+\n\+\+\+ b/(\S+)\n", change)[1]] = change
                self.run("patch", "-p1", "--fuzz=0", "--no-backup-if-mismatch", cwd=self.folder, input=change)
        return made

    def files(self):
        """The whole files that the page shows after a comment `file: PATH`; each is written to the copy."""
        text = (SOURCE / self.page).read_text(encoding="utf-8")
        found = {}
        for name, block in re.findall(r"^<!-- file: ([^,\s]+)[^>]*-->\n```\w+\n(.*?)^```$", text, re.M | re.S):
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block, encoding="utf-8")
            found[name] = block
        return found

    def changed_files(self):
        """Files of the copy that are not those of the project."""
        files = (path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*") if path.is_file())
        return sorted(
            path
            for path in files
            if not (SOURCE / path).is_file() or not filecmp.cmp(self.folder / path, SOURCE / path, shallow=False)
        )

    def commands(self, target):
        """The commands of the build for a target, the last of which makes it."""
        return self.run("ninja", "-C", BUILD, "-t", "commands", target).splitlines()

    def compiled(self, source, target, like=None):
        """The object of a source of the copy, with the options that `target` gives it, or its neighbour `like`."""
        built = like or source
        for command in self.commands(target):
            found = re.search(r"-o (\S+\.o) -c (\S+)$", command.strip())
            if found and found[2] == str(SOURCE / built):
                out = pathlib.Path(tempfile.mkdtemp(dir=self.scratch)) / (pathlib.Path(source).name + ".o")
                command = command.replace(found[1], str(out)).replace(found[2], str(self.folder / source))
                # Headers of the copy come first.
                command = command.replace(f"-I{SOURCE}/src", f"-I{self.folder}/src", 1)
                self.run("bash", "-c", command, cwd=BUILD)
                return out
        return self.fail(f"the build has no command that compiles {built} for {target}")

    def linked(self, target, objects):
        """A program of the build with these objects in place of its own."""
        program = pathlib.Path(tempfile.mkdtemp(dir=self.scratch)) / pathlib.Path(target).name
        names = {pathlib.Path(built).name for built in objects}
        for command in self.commands(target)[-1].split(" && "):
            if f" -o {target} " in command:
                compiler, *words = command.split()
                words = [
                    str(program) if word == target else word for word in words if pathlib.Path(word).name not in names
                ]
                self.run("bash", "-c", " ".join([compiler, *map(str, objects), *words]), cwd=BUILD)
                return program
        return self.fail(f"the build has no command that links {target}")
