"""Values of case keys."""


class SI:
    """A value in SI, for a key whose unit would otherwise have to be stated.

    case["operating.speed"] = ringfilm.SI(209.4) is 209.4 rad/s. `value` is anything that reading a key returns: a
    number, a list of pairs (temperature [K], value), None, a text; case[key] = ringfilm.SI(case[key]) changes nothing.
    `ringfilm.fields()` lists the SI unit of each key.
    """

    __slots__ = {"value": "As it was given."}

    # By __new__, so that there is no SI without its value.
    def __new__(cls, value: object):
        self = super().__new__(cls)
        self.value = value
        return self

    def __reduce__(self):
        """For pickle and copy."""
        return type(self), (self.value,)

    def __repr__(self) -> str:
        """As it is written."""
        return f"SI({self.value!r})"
