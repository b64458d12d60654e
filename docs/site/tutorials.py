"""Turns the tutorials, Python files with `# %%` cells, into notebooks, runs them, and makes pages of what came out.

usage: tutorials.py TUTORIALS STAGE      (environment: PYTHONPATH with the module, RINGFILM_DATA)
"""

import pathlib
import re
import sys
import time

import nbformat
from nbclient import NotebookClient
from nbconvert import MarkdownExporter

SECONDS_A_CELL = 300


def notebook(text):
    """A notebook from the text of a tutorial."""
    cells = []
    for kind, body in re.findall(r"^# %%( \[markdown\])?[^\n]*\n(.*?)(?=^# %%|\Z)", text, re.M | re.S):
        if kind:
            body = "\n".join(re.sub(r"^# ?", "", line) for line in body.strip().split("\n"))
            cells.append(nbformat.v4.new_markdown_cell(body))
        elif body.strip():
            cells.append(nbformat.v4.new_code_cell(body.strip()))
    for number, cell in enumerate(cells):
        cell["id"] = f"cell-{number}"  # not drawn by chance: the same tutorial gives the same notebook
    made = nbformat.v4.new_notebook(cells=cells)
    made.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return made


def page(made, name, folder):
    """The notebook as Markdown with its figures beside it; returns the page's path."""
    text, resources = MarkdownExporter().from_notebook_node(
        made, {"unique_key": name, "output_files_dir": f"{name}_figures"}
    )
    for file, content in resources["outputs"].items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(content)
    # The figure itself is described by the caption in it and by the words around it.
    text = re.sub(r"!\[png\]\(", "![figure](", text)
    text = re.sub(r"<style scoped>.*?</style>", "", text, flags=re.S)
    text += f"\n\n*This page is a notebook that was run when the site was made: [{name}.ipynb]({name}.ipynb). "
    text += f"Its source is `docs/tutorials/{name}.py`.*\n"
    path = folder / f"{name}.md"
    path.write_text(text, encoding="utf-8")
    return path


def main(sources, stage):
    """Runs every tutorial; a cell that fails ends it with the cell and its traceback."""
    folder = stage / "docs" / "tutorials"
    folder.mkdir(parents=True, exist_ok=True)
    for source in sorted(sources.glob("*.py")):
        started = time.monotonic()
        made = notebook(source.read_text(encoding="utf-8"))
        client = NotebookClient(
            made,
            timeout=SECONDS_A_CELL,
            kernel_name="python3",
            resources={"metadata": {"path": str(sources.parent.parent)}},
        )
        client.execute()
        for cell in made.cells:
            cell.metadata.pop("execution", None)
        name = source.stem
        (folder / f"{name}.ipynb").write_text(nbformat.writes(made) + "\n", encoding="utf-8")
        page(made, name, folder)
        print(f"docs: tutorial {name} in {time.monotonic() - started:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
