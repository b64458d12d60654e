"""Pages of the site in the order in which a reader needs them.

A name without an ending is a page of docs/manual. Pages of docs/manual that are not listed here are added at the end of
"Reference", so that no page is lost.
"""

# (caption, pages)
SECTIONS = [
    (
        "Begin here",
        ["five-minutes", "gallery", "install", "docs/manual/guide/platforms", "command-line", "case-file", "report"],
    ),
    (
        "A page for each job",
        [
            "docs/manual/jobs/first-pack",
            "docs/manual/jobs/lower-friction",
            "docs/manual/jobs/which-oil",
            "docs/manual/jobs/which-coating",
            "docs/manual/jobs/blow-by",
            "docs/manual/jobs/oil-consumption",
            "docs/manual/jobs/flutter",
            "docs/manual/jobs/scuffing-and-wear",
            "docs/manual/jobs/bore-distortion",
            "docs/manual/jobs/suppliers-surfaces",
            "docs/manual/jobs/floating-liner",
            "docs/manual/jobs/cylinder-deactivation",
        ],
    ),
    (
        "Judging a result",
        [
            "docs/manual/guide/validation",
            "docs/manual/guide/measured-trends",
            "docs/manual/guide/rig-trends",
            "docs/manual/guide/plausibility",
            "docs/manual/guide/notes",
            "docs/manual/guide/typical-inputs",
            "docs/manual/guide/from-drawing-to-case",
            "docs/manual/guide/faq",
            "docs/manual/guide/comparison",
        ],
    ),
    (
        "From scan to friction",
        [
            "measured-chain",
            "surfaces",
            "docs/manual/guide/contact-law",
            "docs/manual/guide/land",
            "surface-files",
            "face",
            "lateral-force",
            "measurement-files",
        ],
    ),
    ("Many cases", ["study", "fit", "optimise", "serve", "docs/manual/guide/life", "performance"]),
    (
        "Other films",
        [
            "docs/manual/guide/ring-pack-gas",
            "docs/manual/guide/gas-composition",
            "docs/manual/guide/oil-consumption",
            "unrolled",
            "pad",
            "docs/manual/guide/conformity",
        ],
    ),
    ("Tutorials", ["docs/tutorials/README", "docs/tutorials/reproduce-the-paper", "docs/tutorials/*"]),
    ("From programs", ["python", "matlab", "library", "examples/README", "result-file"]),
    (
        "Reference",
        [
            "case-keys",
            "docs/manual/guide/nomenclature",
            "docs/glossary",
            "docs/references",
            "docs/api/python",
            "docs/api/cpp",
        ],
    ),
    ("Theory", ["docs/theory/README", "docs/theory/*"]),
    ("Verification", ["verification", "robustness", "verification/*/README", "cases/measured/README"]),
    ("Development", ["CONTRIBUTING", "docs/manual/extending/*", "docs/decisions/*", "CHANGELOG"]),
]

# Shorter words for the list at the side than the page's own heading.
TITLES = {
    "docs/manual/five-minutes": "A cycle in five minutes",
    "docs/manual/case-keys": "Every key of a case",
    "docs/theory/README": "What is solved",
    "docs/tutorials/README": "All with a picture",
    "CHANGELOG": "Changes",
    "CONTRIBUTING": "Contributing",
    "cases/measured/README": "The synthetic measurements",
}
