"""The page of all case keys, from the list that `ringfilm fields` prints."""

import re


def cell(text):
    """A text as a cell of a table."""
    return text.replace("|", "\\|").replace("<", "&lt;")


def page(listing):
    """docs/manual/case-keys.txt as Markdown: a table for each section, with the columns of that list."""
    out = [
        "# Every key of a case",
        "",
        "What `ringfilm fields` prints, and the [case file](case-file.md) explains. A key without default is omitted "
        "or stated; a required one must be stated where it is used.",
        "",
    ]
    columns = None
    for line in listing.split("\n"):
        if not line.strip():
            columns = None
        elif not line.startswith("  "):
            title = line.strip()
            if title.startswith("["):
                out += [f"## {title.strip('[]')}", ""]
            elif title.startswith("before"):
                out += ["## Before the first section", ""]
            else:
                out += [title.replace('include = ["fragment.toml"]', '`include = ["fragment.toml"]`'), ""]
        elif columns is None:
            columns = [match.start() for match in re.finditer(r"\S+", line)] + [None]
            names = line.split()
            out += ["| " + " | ".join(names) + " |", "|" + "---|" * len(names)]
        else:
            cells = [line[a:b].strip() for a, b in zip(columns, columns[1:])]
            cells = ["" if text == "-" else cell(text) for text in cells]
            cells[0] = f"`{cells[0]}`"
            out.append("| " + " | ".join(cells) + " |")
            continue
        if not line.strip() and out[-1]:
            out.append("")
    return "\n".join(out) + "\n"
