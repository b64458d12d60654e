#!/usr/bin/env python3
"""Checks that documents, comments and messages use the terms of the field (docs/glossary.md) and plain verbs.

usage: wording.py FOLDER      the folder of the project

Prints each place as file:line with the words found and their replacement; exit code 1 if there is one.
"""
import re
import subprocess
import sys
from pathlib import Path

# (regular expression, replacement). Letters of both cases match where the expression has no capital.
RULES = [
    (r"//[/!]?<? ?(of|that of|the same|likewise|as above)\b", "a phrase that stands alone"),
    (r"\b(told|tells?|telling)\b", "report, print, list"),
    (r"\b(said|says|saying)\b|(?<!, )(?<!to )\bsay\b(?!,)|\bto say\b", "state, report, print"),
    (r"\b(wants?|wanted)\b", "require, expect; requested, target"),
    (r"\bknows\b|\bnot know\b|\bknow (nothing|what|how|which|whether)\b", "depend on, contain, read, support"),
    (r"\b(stands?|stood)\b(?! (out|off|for|still)\b)", "is defined in, is next to, is at"),
    (r"\b(go|goes|went) on\b(?! (the|a)\b)", "continue"),
    (r"\b(left|leaves?|leaving) out\b", "omitted, omit"),
    (r"\b(taken?|takes) off\b", "removed, remove, subtract"),
    (r"\b(made|makes?) ready\b", "set up"),
    (
        r"(?<!\bthere )(?<!\bnothing )\b(is|are|was|were) no (?!longer|more|less|other|further|one|later|finer|better|"
        r"larger|smaller|greater|wider|worse|such|obstacle)[a-z]",
        "is not a ...",
    ),
    (r"(?<!\bthere )\b(is|are|was|were) (?-i:none)\b", "is not ..."),
    (r"\bhangs? together\b", "are correlated"),
    (r"\bhouse\b", "architecture"),
    (r"\brooms\b|\b(a|an|the|this|one|its|own) room\b", "module; space"),
    (r"\bdoors?\b", "entry point"),
    (r"\branks? (below|above|up to|of the (modules|folders))\b|\b(lower|higher) ranks?\b|\branks? \d", "layer"),
    (r"(?<!\bdata )(?<!\bstyle )\bsheets?\b", "two-dimensional (unrolled) film"),
    (r"\bmarch(es|ed|ing)?\b", "time integration; integrate, step"),
    (r"\bfilm parameters?\b", "lambda ratio"),
    (r"(?<!\bpiston )(?<!\bsecond )\bland\b(?! on\b| \d| \\?\")", "running surface; core"),
    (r"\bdrive of wear\b", "Archard wear load"),
    (r"\bmade surfaces?\b", "synthetic surface"),
    (r"\bbearing curves?\b", "material ratio curve"),
    (r"\btabor\b(?! 1951)", "roughness parameter"),
    (r"\bspoil(s|t|ed)?\b|\bchunks?\b", "corrupted; block"),
    (r"\b(to blame|sureness)\b", "variance-based sensitivity; width of the interval"),
    (r"\b(swings?|swung)\b(?!\.)", "one-at-a-time sensitivity; oscillate"),
    (r"\bMind:", "Warning:"),
]

# Where an expression may stand: (path, text of the line). Names of earlier versions, quotations, other programs.
EXCEPTIONS = [
    (r"^(tests|benchmarks|cases|examples)/", r"(?i)//[/!]?<? ?(of|that of|the same|likewise|as above)\b"),
    (r"^tests/docs/wording\.py$", r""),
    (r"^(verification|tests/unit/(pad|film))/", r"(?i)\bland\b"),  # of a step bearing
    (r"(^|/)\w*land\w*\.\w+$", r"(?i)\bland\b"),  # the flat land of an oil ring, and its lift
    (r"", r"(?i)\bland\b.*(lift|hon)|(lift|hon).*\bland\b|`land\b|land\.(md|nc)|ringfilm land\b"),
    (r"", r"\bland-(law|width|load)|guide/land|\bflat land\b|\bno land\b|\bland (that was|as wide)|\"land\""),
    (r"^docs/glossary\.md$", r"^\| (`lambda_ratio`|running surface) \|"),  # synonyms
    (r"^tests/cli/face_test\.py$", r"--land-height|--levelling"),  # names of an earlier version
    (r"^src/ringfilm/base/renamed\.hpp$", r"^ +\{\""),
    (r"^verification/.*\.py$", r"--swing"),
    (r"^tests/cli/verify_test\.py$", r"--swing"),
]

SKIPPED = re.compile(r"^(fuzz/(corpus|beside)/|docs/renamed\.csv|LICENSE|docs/references\.bib)")
HASH = re.compile(r"""(?P<text>'''.*?'''|\"\"\".*?\"\"\"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|\#[^\n]*)""", re.S)
SLASH = re.compile(
    r"""(?P<text>//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\2"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|`[^`]*`)""", re.S
)
MARK = "\x01"
# End of a line, and the mark of a comment that continues in the next one.
JOINT = re.compile(r"\"?[ \t]*\n[ \t]*(?:///?<?|#|%|\")?[ \t]*")
LANGUAGES = {
    ".py": HASH,
    ".pyi": HASH,
    ".toml": HASH,
    ".cmake": HASH,
    ".cpp": SLASH,
    ".hpp": SLASH,
    ".js": SLASH,
    ".mjs": SLASH,
    ".css": SLASH,
}


def files(root):
    listed = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        return [name for name in listed.stdout.splitlines() if (root / name).is_file()]
    return [str(path.relative_to(root)) for path in root.rglob("*") if path.is_file() and "build" not in str(path)]


def prose(path, text):
    """The text with its code replaced by a mark for each character; lines are kept."""
    ending = Path(path).suffix
    if path.endswith("CMakeLists.txt") or (ending == "" and text.startswith("#!")):
        ending = ".cmake"  # comments and texts of a script of the shell are written alike
    if ending == ".md":
        return re.sub(r"`[^`\n]+`|\]\([^)\n]*\)", blank, text)
    if ending == ".m":
        return "\n".join(line if line.lstrip().startswith("%") else MARK for line in text.split("\n"))
    if ending not in LANGUAGES:
        return ""
    kept, end = [], 0
    for hit in LANGUAGES[ending].finditer(text):
        kept += [blank(text[end : hit.start()]), hit.group()]
        end = hit.end()
    return "".join(kept) + blank(text[end:])


def blank(code):
    """Blanks stay, so that a comment or a text literal can continue in the next line."""
    return re.sub(r"\S", MARK, code if isinstance(code, str) else code.group())


def joined(text):
    """Lines of one comment or literal joined with a blank, and the number of the line of each character."""
    parts, lines, end, line = [], [], 0, 1
    for hit in [*JOINT.finditer(text), None]:
        part = text[end : hit.start()] if hit else text[end:]
        parts.append(part)
        lines += [line] * len(part)
        if hit:
            parts.append(" ")
            lines.append(line)
            line += 1
            end = hit.end()
    return "".join(parts), lines


def findings(root):
    rules = [(re.compile(rule, 0 if re.search(r"(?<!\\)[A-Z]", rule) else re.I), better) for rule, better in RULES]
    allowed = [(re.compile(path), re.compile(line)) for path, line in EXCEPTIONS]
    for path in files(root):
        if SKIPPED.match(path):
            continue
        try:
            text = (root / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        written = text.split("\n")
        flat, lines = joined(prose(path, text))
        for rule, better in rules:
            for hit in rule.finditer(flat):
                line = lines[hit.start()]
                if not any(a.search(path) and b.search(written[line - 1]) for a, b in allowed):
                    yield f'{path}:{line}: "{hit.group()}": write {better}: {written[line - 1].strip()[:160]}'


def check_itself():
    """The rules find their words in code of each kind, and over the end of a line."""
    for path, text, hits in (
        ("a.cpp", 'int told = 1;  // what is told\nfail("x is none");', 2),
        ("a.md", "`says` says", 1),
        ("a.py", '# a part that is left\n# out of it\nsaid = "a house"', 2),
        ("script/a", "#!/bin/sh\n# what it tells\ntold=1", 1),
    ):
        flat = joined(prose(path, text))[0]
        assert sum(bool(re.search(rule, flat)) for rule, _ in RULES) == hits, (path, flat)


def main():
    check_itself()
    found = list(findings(Path(sys.argv[1])))
    print("\n".join(found))
    print(f"{len(found)} places" if found else "no place")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
