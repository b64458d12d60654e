"""A figure of matplotlib that shows itself; apart, since it can only be defined where matplotlib is loaded."""

import io

from matplotlib.figure import Figure


class ShownFigure(Figure):
    """A figure that a notebook shows, without pyplot and without `%matplotlib inline`."""

    def _repr_png_(self):
        picture = io.BytesIO()
        self.savefig(picture, format="png")
        return picture.getvalue()
