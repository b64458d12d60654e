"""Lists the public names of the C++ library without a description. Doxygen's own warnings omit enumerators
and everything in a namespace without a description.

usage: undocumented.py XML_FOLDER      (of doxygen); ends with 1 if there are any
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def is_described(element):
    words = (element.find("briefdescription"), element.find("detaileddescription"))
    return any("".join(one.itertext()).strip() for one in words if one is not None)


def is_destructor(member):
    return member.findtext("name").startswith("~")


def undescribed(compound):
    """Names of one class, struct or namespace, itself first."""
    own = compound.findtext("compoundname")
    if not is_described(compound):
        yield own
    for member in compound.iter("memberdef"):
        if member.get("prot") == "private" or is_destructor(member):
            continue
        name = f"{own}::{member.findtext('name')}"
        if not is_described(member):
            yield name
        yield from (
            f"{name}::{value.findtext('name')}" for value in member.findall("enumvalue") if not is_described(value)
        )


def main(folder):
    seen, missing = 0, []
    for path in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            is_ours = compound.findtext("compoundname").split("::")[0] == "ringfilm"
            if (
                compound.get("kind") not in ("class", "struct", "namespace")
                or compound.get("prot") == "private"
                or not is_ours
            ):
                continue
            seen += 1
            missing += undescribed(compound)
    for name in missing:
        print(f"docs: {name} has no description", file=sys.stderr)
    if not seen:
        print(f"docs: no public name in {folder}", file=sys.stderr)
    return 0 if seen and not missing else 1


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
