#!/usr/bin/env python3
"""Prints a page of Markdown as Doxygen needs it: headings have ids, links to pages and their headings name these ids, and
other files, which are not part of the site, are named and not linked. Doxygen's filter for *.md; see docs/Doxyfile."""

import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def page_id(path):
    """The id of the page at `path`, relative to the repository, or None if it is no page of the site."""
    if path == "README.md":
        return "mainpage"
    if path == "CHANGELOG.md" or path == "benchmarks/README.md" or re.fullmatch(r"docs/[^/]+\.md", path):
        return "page_" + re.sub(r"\W", "_", path[: -len(".md")])
    return None


def heading_id(page, heading):
    """GitHub's anchor of a heading, made unique over all pages."""
    slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
    return f"{page}_{slug}"


def link(page, folder, text, target):
    """A link of `page` in Doxygen's words."""
    if re.match(r"\w+:", target):
        return f"[{text}]({target})"
    file, _, anchor = target.partition("#")
    path = os.path.relpath(os.path.join(ROOT, folder, file), ROOT) if file else None
    other = page_id(path) if file else page
    if other is None:
        if not os.path.exists(os.path.join(ROOT, path)):
            return f"[{text}](@ref no_file_{target})"  # Doxygen warns of it.
        return text if text.strip("`/").endswith(path) else f"{text} (`{path}`)"
    name = heading_id(other, anchor) if anchor else "index" if other == "mainpage" else other
    return f"[{text}](@ref {name})"


def main():
    path = os.path.relpath(os.path.abspath(sys.argv[1]), ROOT)
    folder, page = os.path.dirname(path), page_id(path)
    fenced = False
    first = True
    for line in open(sys.argv[1], encoding="utf-8"):
        line = line.rstrip("\n")
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced:
            if heading := re.fullmatch(r"(#+) (.*)", line):
                name = page if first else heading_id(page, heading[2])
                line, first = f"{line} {{#{name}}}", False
            else:
                line = re.sub(r"(?<!!)\[([^\]]+)\]\(([^)\s]+)\)", lambda m: link(page, folder, m[1], m[2]), line)
        print(line)


main()
