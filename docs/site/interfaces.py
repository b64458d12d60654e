"""The pages of the interfaces: of Python from its stubs and sources, of C++ from the public headers by way of doxygen.

usage: interfaces.py STAGE STUBS HEADER...      (from the checkout; STUBS: the folder of stubs that the build wrote)
"""

import ast
import pathlib
import re
import sys

PACKAGE = pathlib.Path("python/ringfilm")


def escaped(text):
    """Words of a docstring as Markdown that shows just these words."""
    parts = re.split(r"(`[^`]+`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([\\`*<$|\[\]])", r"\\\1", part) for part in parts)


def prose(docstring):
    """A docstring as Markdown: paragraphs, and a list where lines name arguments."""
    out, lines = [], (docstring or "").split("\n")
    indents = [len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()]
    shift = min(indents, default=0)
    lines = [lines[0], *(line[shift:] for line in lines[1:])]
    code = []
    for line in lines:
        if line.startswith("    ") and (code or not out or out[-1] == ""):
            code.append(line[4:])
            continue
        if code:
            out += ["```python", *code, "```", ""]
            code = []
        words = line.strip()
        argument = re.match(r"^([a-z_]\w*(?:, [a-z_]\w*)*): (.*)$", words)
        if argument:
            out.append(f"- *{argument.group(1)}*: {escaped(argument.group(2))}")
        elif re.match(r"^(Raises|Returns|Source|Throws)\b", words):
            out += ["", escaped(words)]
        elif words and out and out[-1].startswith("- ") and line.startswith(" "):
            out.append(f"  {escaped(words)}")
        elif words and out and (out[-1].startswith("- ") or out[-1].startswith("  ")):
            out += ["", escaped(words)]
        else:
            out.append(escaped(words))
    if code:
        out += ["```python", *code, "```"]
    return out


def signature(function, inside):
    """Arguments and return type."""
    arguments = ast.unparse(function.args)
    if inside:
        arguments = re.sub(r"^self(, )?", "", arguments)
    returned = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"({arguments}){returned}"


def decorators(function):
    return {ast.unparse(decorator) for decorator in function.decorator_list}


def block(kind, name, content, options=(), fence="```"):
    return [f"{fence}{{py:{kind}}} {name}", *options, "", *content, fence, ""]


def of_function(function, prefix, inside=False):
    """One function, method or property."""
    kind = "method" if inside else "function"
    content = prose(ast.get_docstring(function, clean=False))
    marks = decorators(function)
    if "property" in marks:
        return block("property", function.name, content)
    options = [":staticmethod:"] if "staticmethod" in marks else [":classmethod:"] if "classmethod" in marks else []
    name = function.name if inside else f"{prefix}.{function.name}"
    return block(kind, name + signature(function, inside), content, options)


def of_class(node, prefix):
    """A class with all its public members."""
    content = prose(ast.get_docstring(node, clean=False)) + [""]
    for member in node.body:
        if isinstance(member, ast.FunctionDef) and not member.name.startswith("_"):
            content += of_function(member, prefix, inside=True)
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    return block(
        "class",
        f"{prefix}.{node.name}" + (f"({bases})" if bases and "Exception" not in bases else ""),
        content,
        fence="````",
    )


def public_names(path):
    """Names in __all__ of a module."""
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            return ast.literal_eval(node.value)
    return []


def definitions(*paths):
    """{name: node} of the public definitions of some files; the first file that has a name wins."""
    found = {}
    for path in paths:
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                found.setdefault(node.name, node)
    return found


def python_page(stubs):
    """Every public name of the module, of its compiled part from the stubs."""
    out = [
        "# The Python module, name by name",
        "",
        "[From Python](../manual/python.md) shows how these are used. Numbers are in SI, crank angles in degrees.",
        "",
    ]
    modules = [
        ("ringfilm", PACKAGE / "__init__.py", [PACKAGE / "_batch.py", PACKAGE / "errors.py", stubs / "__init__.pyi"])
    ]
    for name in ("surface", "face", "lateral_force", "laws"):
        modules.append((f"ringfilm.{name}", PACKAGE / f"{name}.py", [PACKAGE / f"{name}.py", stubs / f"{name}.pyi"]))
    for module, source, files in modules:
        known = definitions(*files)
        out += [
            f"## {module}",
            "",
            *prose(ast.get_docstring(ast.parse(source.read_text(encoding="utf-8")), clean=False)),
            "",
        ]
        for name in public_names(source):
            node = known.get(name)
            if isinstance(node, ast.ClassDef):
                out += of_class(node, module)
            elif node is not None:
                out += of_function(node, module)
    return "\n".join(out) + "\n"


MODULES = {
    "ringfilm": ("Errors", "base"),
    "ringfilm::surface": ("Surfaces, faces, friction loops", "surface"),
    "ringfilm::models": ("Laws: oil, contact, crank, gas, ring", "models"),
    "ringfilm::cycle": ("The case, the cycle and its result", "cycle"),
    "ringfilm::gas_path": ("Gas between the rings", "gas_path"),
    "ringfilm::pad": ("Pads", "pad"),
    "ringfilm::life": ("The life of a ring", "life"),
    "ringfilm::run": ("The driver: a case to its result", "run"),
    "ringfilm::study": ("Batches and studies", "study"),
    "ringfilm::io": ("Files and units", "io"),
    "ringfilm::instrument": ("Instrument files", "instrument"),
    "ringfilm::report": ("The page", "report"),
}


def page_of(header):
    """The module whose page has a public header: `case` has the namespace of `cycle`."""
    folder = header.split("/")[2]
    return "cycle" if folder == "case" else folder


def folder_page(namespace, headers):
    """One module: its namespace with all that the public headers of the module declare."""
    title, folder = MODULES[namespace]
    headers = [header for header in headers if page_of(header) == folder]
    listed = ", ".join(f"`{header.removeprefix('src/')}`" for header in headers)
    directive = f"```{{doxygennamespace}} {namespace}\n:project: ringfilm\n:members:\n```\n"
    if folder == "base":  # the namespace ringfilm itself holds all others
        directive = "".join(
            f"```{{doxygenfile}} {header.removeprefix('src/')}\n:project: ringfilm\n```\n\n" for header in headers
        )
    return f"# {title}\n\nFrom {listed}.\n\n{directive}"


def main(stage, stubs, headers):
    api = stage / "docs" / "api"
    (api / "cpp").mkdir(parents=True, exist_ok=True)
    (api / "python.md").write_text(python_page(stubs), encoding="utf-8")
    folders = {page_of(header) for header in headers}
    left = folders - {folder for _, folder in MODULES.values()}
    if left:
        raise SystemExit(
            f"docs: the public headers of {', '.join(sorted(left))} have no page in docs/site/interfaces.py"
        )
    out = [
        "# The C++ library, name by name",
        "",
        "What `ringfilm/ringfilm.hpp` includes is public. [The library](../manual/library.md) shows how it is used.",
        "",
        "```{toctree}",
        ":maxdepth: 1",
        "",
    ]
    for namespace, (_, folder) in MODULES.items():
        if folder in folders:
            (api / "cpp" / f"{folder}.md").write_text(folder_page(namespace, headers), encoding="utf-8")
            out.append(f"cpp/{folder}")
    (api / "cpp.md").write_text("\n".join([*out, "```", ""]), encoding="utf-8")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:])
