"""Runs the tutorials, Python files with `# %%` cells, as notebooks, and makes pages of what came out.

usage: tutorials.py TUTORIALS STAGE      pages and notebooks into STAGE, and a comparison with the stored pages
       tutorials.py --store TUTORIALS    writes the stored pages next to the tutorials
(environment: PYTHONPATH with the module, RINGFILM_DATA)

A stored page shows the pictures of a tutorial to readers of the files. Its words and numbers must be those of a run.
"""

import pathlib
import re
import sys
import time

import nbformat
from nbclient import NotebookClient
from nbconvert import MarkdownExporter
from tutorial_cells import cells

SECONDS_A_CELL = 300
TOLERANCE = 0.01  # of a number, and of the last digit at least: another processor rounds differently
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def notebook(text):
    """A notebook from the text of a tutorial."""
    made = nbformat.v4.new_notebook(
        cells=[
            nbformat.v4.new_markdown_cell(body) if is_text else nbformat.v4.new_code_cell(body)
            for is_text, body in cells(text)
        ]
    )
    for number, cell in enumerate(made.cells):
        cell["id"] = f"cell-{number}"  # not drawn by chance: the same tutorial gives the same notebook
    made.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return made


def run(source):
    """The tutorial as a notebook with all outputs; a cell that fails ends it with the cell and its traceback."""
    made = notebook(source.read_text(encoding="utf-8"))
    root = source.resolve().parents[2]
    client = NotebookClient(
        made, timeout=SECONDS_A_CELL, kernel_name="python3", resources={"metadata": {"path": str(root)}}
    )
    client.execute()
    for cell in made.cells:
        cell.metadata.pop("execution", None)
    return made


def page(made, name):
    """The notebook as Markdown, and the contents of its figures by their paths."""
    text, resources = MarkdownExporter().from_notebook_node(made, {"unique_key": name, "output_files_dir": "figures"})
    text = re.sub(r"<style scoped>.*?</style>", "", text, flags=re.S)
    text = re.sub(r"\n\s*!\[png\]\(([^)]*)\)\s*\n", r"\n\n![png](\1)\n\n", text)
    # Words for readers who do not see the figure: the first sentence of its caption.
    parts = re.split(r"!\[png\]\(", text)
    for i, part in enumerate(parts[1:], 1):
        caption = re.search(r"^\*([^*]+?)[.:;]", part, re.M)
        parts[i] = f"![{caption.group(1) if caption else name}]({part}"
    return "".join(parts).strip() + "\n", resources["outputs"]


def write(folder, name, text, figures):
    """The page and its figures below `folder`."""
    for file, content in figures.items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(content)
    (folder / f"{name}.md").write_text(text, encoding="utf-8")


def stored_page(text, name):
    return f"{text}\n*Made by a run of [{name}.py]({name}.py).*\n"


def same(one, other):
    """Are words the same, and numbers up to rounding?"""
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return False
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        last = 10.0 ** -len(a.partition(".")[2].partition("e")[0])
        if abs(float(a) - float(b)) > max(TOLERANCE * abs(float(a)), last):
            return False
    return True


def store(sources):
    """Writes the stored pages."""
    for old in (sources / "figures").glob("*.png"):
        old.unlink()
    for source in sorted(sources.glob("*.py")):
        text, figures = page(run(source), source.stem)
        write(sources, source.stem, stored_page(text, source.stem), figures)
    return 0


def main(sources, stage):
    """Runs every tutorial into the stage; ends with 1 where a stored page is out of date."""
    folder = stage / "docs" / "tutorials"
    folder.mkdir(parents=True, exist_ok=True)
    faults = 0
    for source in sorted(sources.glob("*.py")):
        started = time.monotonic()
        name, made = source.stem, run(source)
        (folder / f"{name}.ipynb").write_text(nbformat.writes(made) + "\n", encoding="utf-8")
        text, figures = page(made, name)
        kept = sources / f"{name}.md"
        if not kept.is_file() or not same(kept.read_text(encoding="utf-8"), stored_page(text, name)):
            print(f"docs: docs/tutorials/{name}.md is not what its tutorial gives; tutorials.py --store writes it")
            faults = 1
        text += f"\n*This page is a notebook that was run when the site was made: [{name}.ipynb]({name}.ipynb). "
        text += f"Its source is `docs/tutorials/{name}.py`.*\n"
        write(folder, name, text, figures)
        print(f"docs: tutorial {name} in {time.monotonic() - started:.0f} s")
    return faults


if __name__ == "__main__":
    if sys.argv[1] == "--store":
        sys.exit(store(pathlib.Path(sys.argv[2]).resolve()))
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
