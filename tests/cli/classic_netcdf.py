"""Writes small NetCDF files of the classic kind (its format specification, CDF-1), without a library."""

import struct


def _name(text):
    return struct.pack(">i", len(text)) + _padded(text.encode())


def _padded(data):
    return data + b"\0" * (-len(data) % 4)


def _attributes(texts):
    if not texts:
        return struct.pack(">ii", 0, 0)
    out = struct.pack(">ii", 0x0C, len(texts))
    for name, value in texts.items():
        if isinstance(value, str):
            out += _name(name) + struct.pack(">ii", 2, len(value)) + _padded(value.encode())
        else:
            out += _name(name) + struct.pack(">iid", 6, 1, value)
    return out


def classic(dimensions, variables):
    """Bytes of a file with dimensions {name: length} and variables {name: (dimensions, attributes, values)}."""
    numbers = {name: i for i, name in enumerate(dimensions)}
    head = b"CDF\x01" + struct.pack(">i", 0)
    head += struct.pack(">ii", 0x0A, len(dimensions))
    head += b"".join(_name(name) + struct.pack(">i", length) for name, length in dimensions.items())
    head += _attributes({}) + struct.pack(">ii", 0x0B, len(variables))

    def listed(begin):
        out = b""
        for name, (over, attributes, values) in variables.items():
            size = 8 * len(values)
            out += (
                _name(name) + struct.pack(">i", len(over)) + struct.pack(f">{len(over)}i", *(numbers[d] for d in over))
            )
            out += _attributes(attributes) + struct.pack(">iii", 6, size, begin)
            begin += size
        return out

    begin = len(head) + len(listed(0))
    data = b"".join(struct.pack(f">{len(values)}d", *values) for _, _, values in variables.values())
    return head + listed(begin) + data


def gap_map(x, y, heights, over=("y", "x"), attributes=None):
    """A gap as the program reads it: x and y in mm, h in um."""
    attributes = {"units": "um"} if attributes is None else attributes
    return classic(
        {"y": len(y), "x": len(x)},
        {"x": (("x",), {"units": "mm"}, x), "y": (("y",), {"units": "mm"}, y), "h": (over, attributes, heights)},
    )
