"""Lays out what Sphinx reads: the Markdown of the checkout, with its links made into those of the site.

The pages in docs/ stay plain Markdown that reads well by itself, so they contain no markup of Sphinx. Here each
link to a
place in a page gets a label, each link to a file beside the pages a copy of that file, and the pages that are made
(keys
of a case, sources, decisions, navigation) are written.

usage: stage.py CHECKOUT FOLDER
"""

import pathlib
import posixpath
import re
import shutil
import sys

import cases
import navigation

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
ANCHOR = re.compile(r'<a id="([^"]+)"></a>')
HEADING = re.compile(r"^(#{1,6}) +(.*)$")


def pages_of(root):
    """Names of all pages of the checkout that belong to the site, as paths from its root."""
    patterns = [
        "docs/**/*.md",
        "verification/*/README.md",
        "cases/measured/README.md",
        "examples/README.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
    ]
    found = {path.relative_to(root).as_posix() for pattern in patterns for path in root.glob(pattern)}
    return sorted(page for page in found - {"docs/manual/README.md"} if not page.startswith("docs/site/"))


def slug(heading):
    """The name by which a link finds a heading, as GitHub makes it."""
    words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def label(page, place):
    """A name for a place that no other page has. Labels of Sphinx do not distinguish capitals."""
    return re.sub(r"[^a-z0-9]+", "-", f"{page.removesuffix('.md')}--{place}".lower()).strip("-")


def outside_code(text):
    """(line, is it prose?) for each line: blocks of code are left as they are."""
    fence = None
    for line in text.split("\n"):
        mark = re.match(r"^\s*(```+|~~~+)", line)
        if mark:
            fence = None if fence and line.strip() == fence else fence or mark.group(1)
            yield line, False
        else:
            yield line, fence is None and not line.startswith("    ")


class Stage:
    """The folder that Sphinx reads, while it is filled."""

    def __init__(self, root, folder):
        self.root, self.folder = root, folder
        self.pages = pages_of(root)
        self.made = {}
        self.required = set()
        self.faults = []

    def target(self, page, link):
        """(page or file, place) of a link; no page where it leads out of the site."""
        if re.match(r"^[a-z]+:", link):
            return None, None
        path, _, place = link.partition("#")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(page), path)) if path else page
        for name in (path, posixpath.join(path, "README.md")):
            if name in self.pages or name in self.made:
                return name, place
        return {
            "docs/manual/case-keys.txt": "docs/manual/case-keys.md",
            "docs/references.bib": "docs/references.md",
            "docs/manual/README.md": "index.md",
            "README.md": "index.md",
        }.get(path, path), place

    def links(self, page, text):
        """The links of a page are those of the site."""

        def rewritten(match):
            picture, words, link = match.groups()
            path, place = self.target(page, link)
            if path is None:
                return match.group(0)
            if path in self.pages or path in self.made or path == "index.md":
                if place:
                    self.required.add((path, place))
                    return f"[{words}]({label(path, place)})"
                return f"[{words}]({posixpath.relpath(path, posixpath.dirname(page) or '.')})"
            source = self.root / path
            if source.is_dir():
                return words
            if not source.is_file():
                self.faults.append(f"{page}: {link} leads nowhere")
                return words
            copy = self.folder / path
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, copy)
            return match.group(0)

        return "\n".join(LINK.sub(rewritten, line) if prose else line for line, prose in outside_code(text))

    def labels(self, page, text):
        """Labels before the headings and anchors that some link leads to."""
        places = {place.lower() for path, place in self.required if path == page}
        lines, found, seen = [], set(), {}
        for line, prose in outside_code(text):
            heading = HEADING.match(line) if prose else None
            names = ANCHOR.findall(line) if prose else []
            if heading:
                name = slug(heading.group(2))
                seen[name] = seen.get(name, -1) + 1
                names.append(f"{name}-{seen[name]}" if seen[name] else name)
            for name in names:
                if name.lower() in places - found:
                    lines += ["", f"({label(page, name)})=", ""]
                    found.add(name.lower())
            lines.append(line)
        for place in places - found:
            self.faults.append(f"{page} has no place #{place}, though a link leads there")
        return "\n".join(lines)

    def write(self):
        """All pages, read and made."""
        texts = {page: (self.root / page).read_text(encoding="utf-8") for page in self.pages}
        texts |= self.made
        texts = {page: self.links(page, text) for page, text in texts.items()}
        texts = {page: self.labels(page, text) for page, text in texts.items()}
        for page, text in texts.items():
            path = self.folder / page
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")


def expanded(stage, entry):
    """Pages that an entry of the navigation means, without their ending."""
    name = entry if "/" in entry or entry.isupper() else f"docs/manual/{entry}"
    known = [page.removesuffix(".md") for page in [*stage.pages, *stage.made]]
    return sorted(page for page in known if pathlib.PurePosixPath(page).match(name))


def index(stage, others):
    """The first page: what there is, and the navigation. `others` are pages that Sphinx gets from elsewhere."""
    taken, sections = set(), {}
    order = re.findall(r"\]\(([\w-]+)\.md\)", (stage.root / "docs/theory/README.md").read_text(encoding="utf-8"))
    for caption, entries in navigation.SECTIONS:
        pages = []
        for entry in entries:
            found = [entry] if entry in others else expanded(stage, entry)
            found += [page for page in others if pathlib.PurePosixPath(page).match(entry) and page not in found]
            if entry == "docs/theory/*":
                found.sort(key=lambda page: order.index(page.split("/")[-1]) if page.split("/")[-1] in order else 99)
            pages += [page for page in found if page not in taken]
            taken |= set(found)
        sections[caption] = pages
    for page in stage.pages:
        name = page.removesuffix(".md")
        if name not in taken:
            sections["Reference"].append(name)
    welcome = (stage.root / "docs/site/welcome.md").read_text(encoding="utf-8")
    # It becomes the page above all others.
    text = [welcome.replace("](../../", "](").replace("](../", "](docs/")]
    for caption, pages in sections.items():
        if pages:
            lines = [f"{navigation.TITLES[page]} <{page}>" if page in navigation.TITLES else page for page in pages]
            text += ["```{toctree}", ":hidden:", f":caption: {caption}", "", *lines, "```", ""]
    return "\n".join(text)


def references(root):
    """The bibliography as a page, an anchor for each key."""
    lines = [
        "# Sources",
        "",
        "Keys are author and year. The list is [references.bib](references.bib) of the sources.",
        "",
    ]
    text = (root / "docs/references.bib").read_text(encoding="utf-8")
    for key, body in sorted(re.findall(r"^@\w+\{(\w+),\n(.*?)^\}", text, re.M | re.S)):
        fields = {
            name.lower(): re.sub(r"[{}]", "", value).replace("--", "–").replace("\\&", "&")
            for name, value in re.findall(r"^\s*(\w+)\s*=\s*\{(.*)\},?\s*$", body, re.M)
        }
        where = ", ".join(
            fields[name]
            for name in (
                "journal",
                "booktitle",
                "publisher",
                "institution",
                "edition",
                "volume",
                "number",
                "pages",
                "note",
                "howpublished",
            )
            if name in fields
        )
        doi = f" [doi:{fields['doi']}](https://doi.org/{fields['doi']})" if "doi" in fields else ""
        lines += [
            f"**{key}** {fields.get('author', '').replace(' and ', ', ')} ({fields.get('year', 'no year')}): "
            f"*{fields.get('title', '')}*. {where}.{doi}",
            "",
        ]
    return "\n".join(lines)


def main(root, folder, others):
    """Fills `folder`; ends with 1 and all faults if there are any."""
    stage = Stage(root, folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    stage.made["docs/manual/case-keys.md"] = cases.page(
        (root / "docs/manual/case-keys.txt").read_text(encoding="utf-8")
    )
    stage.made["docs/references.md"] = references(root).replace("(references.bib)", "(references-file)")
    stage.made["docs/references.md"] = stage.made["docs/references.md"].replace(
        "[references.bib](references-file)", "`docs/references.bib`"
    )
    stage.made["index.md"] = index(stage, others)
    stage.write()
    for fault in stage.faults:
        print(f"docs: {fault}", file=sys.stderr)
    return 1 if stage.faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3:]))
