"""Cells of a tutorial, a Python file in which `# %%` begins a cell and `# %% [markdown]` one of text."""

import re


def cells(text):
    """(is it text?, what it holds) for each cell that is not empty."""
    for kind, body in re.findall(r"^# %%( \[markdown\])?[^\n]*\n(.*?)(?=^# %%|\Z)", text, re.M | re.S):
        if kind:
            yield True, "\n".join(re.sub(r"^# ?", "", line) for line in body.strip().split("\n"))
        elif body.strip():
            yield False, body.strip()
