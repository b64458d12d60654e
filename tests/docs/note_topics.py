#!/usr/bin/env python3
"""Checks that the page on notes lists every topic of a note that the program has, in its order, and no other.

usage: note_topics.py TABLE PAGE      src/ringfilm/cycle/advice/note_topics.cpp, docs/manual/guide/notes.md
"""
import re
import sys
from pathlib import Path

table, page = (Path(name).read_text(encoding="utf-8") for name in sys.argv[1:])
topics = re.findall(r'^ +\{"([a-z-]+)", k(?:None|Limited|Full),', table, re.M)
rows = re.findall(r"^\| ((?:`[a-z-]+`(?:, )?)+) \|", page, re.M)
described = [topic for row in rows for topic in re.findall(r"`([a-z-]+)`", row)]
assert len(topics) > 40, topics
for topic in topics:
    if topic not in described:
        print(f"{sys.argv[2]} lacks {topic}")
for topic in described:
    if topic not in topics:
        print(f"{sys.argv[2]} describes {topic}, which the program does not have")
if sorted(topics) == sorted(described) and topics != described:
    print(f"{sys.argv[2]} has another order than the program: {', '.join(topics)}")
sys.exit(topics != described)
