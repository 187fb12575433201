#!/usr/bin/env python3
"""Prepares the pages for the generator of the site: docs_page.py FOLDER TAGFILE [VIEWS]

Copies the pages and their pictures into FOLDER. Links to pages stay, and examples become pages. Other files, which are
no part of the site, are named and not linked. Names of classes lead to Doxygen's pages, as TAGFILE tells. VIEWS is a
folder with viewer files, if there are any."""

import os
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[1]
# Where pages go that are not at their place in the repository
MOVED = {"docs/start.md": "index.md", "README.md": "overview.md"}


def pages():
    """All pages of the site, relative to the repository"""
    docs = sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").glob("*.md"))
    return ["README.md", "CHANGELOG.md", "benchmarks/README.md", *docs]


def examples():
    """Programs that get a page, by their paths; pages are called as these, with .md"""
    found = [*(ROOT / "demos").glob("[0-9]*.cpp"), *(ROOT / "python" / "examples").glob("[0-9]*.py")]
    return {path.relative_to(ROOT).as_posix() for path in found}


def classes(tagfile):
    """The API pages of the library's classes, by their names"""
    found = {}
    for compound in xml.etree.ElementTree.parse(tagfile).getroot().iter("compound"):
        name = compound.findtext("name", "")
        if compound.get("kind") in ("class", "struct") and name.count("::") == 1 and "<" not in name:
            found[name.split("::")[1]] = "api/" + compound.findtext("filename", "")
    return found


class Page:
    """One page, with the place it goes to"""

    def __init__(self, path, api):
        self.path, self.api = path, api
        self.place = MOVED.get(path, path)
        self.linked = set()

    def relative(self, place):
        return os.path.relpath(place, os.path.dirname(self.place) or ".")

    def link(self, match):
        mark, text, target = match.groups()
        if re.match(r"\w+:", target):
            return match[0]
        file, hash_mark, anchor = target.partition("#")
        if target.startswith("../api/"):
            return match[0]
        path = os.path.normpath(os.path.join(os.path.dirname(self.path), file)) if file else self.path
        if not (ROOT / path).exists():
            sys.exit(f"{self.path}: there is no {path}")
        if path in ALL or mark:
            return f"{mark}[{text}]({self.relative(MOVED.get(path, path))}{hash_mark}{anchor})"
        if path in EXAMPLES:
            return f"[{text}]({self.relative(path)}.md)"
        return text if text.strip("`/").endswith(path) else f"{text} (`{path}`)"

    def name(self, match):
        """The first mention of a class leads to its page"""
        name = match[1]
        if name not in self.api or name in self.linked:
            return match[0]
        self.linked.add(name)
        return f"[`{name}`]({self.relative(self.api[name])})"

    def names(self, line):
        return re.sub(r"(?<!\[)`(\w+)`(?!\])", self.name, line[0])

    def prepared(self):
        """The page's text; what stands in fences is left as it is"""
        text = (ROOT / self.path).read_text(encoding="utf-8")
        parts = re.split(r"(^```.*?^```$)", text, flags=re.DOTALL | re.MULTILINE)
        for i in range(0, len(parts), 2):
            part = re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", self.link, parts[i])
            part = re.sub(r"^(?!#|    ).*", self.names, part, flags=re.MULTILINE)
            # Lists need no empty line before them on GitHub.
            parts[i] = re.sub(r"^(?![-# ]|\s*$)(.*)\n(?=- )", r"\1\n\n", part, flags=re.MULTILINE)
        return "".join(parts)


ALL = pages()
EXAMPLES = examples()


def main():
    folder, api = pathlib.Path(sys.argv[1]), classes(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    for path in ALL:
        page = Page(path, api)
        text = page.prepared()
        if path == "docs/examples.md" and len(sys.argv) > 3:
            views = sorted(pathlib.Path(sys.argv[3]).glob("*.html"))
            text += "\n## Plans to look at from all sides\n\n"
            text += "".join(f"- [{view.stem.replace('_', ' ')}](../views/{view.name})\n" for view in views)
        target = folder / page.place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    for path in EXAMPLES:
        target = folder / f"{path}.md"
        target.parent.mkdir(parents=True, exist_ok=True)
        language = "python" if path.endswith(".py") else "cpp"
        code = (ROOT / path).read_text(encoding="utf-8")
        target.write_text(f"# {target.stem}\n\n```{language}\n{code}```\n", encoding="utf-8")
    for pictures in ("pictures", "experiments"):
        shutil.copytree(ROOT / "docs" / pictures, folder / "docs" / pictures, ignore=shutil.ignore_patterns("*.csv"))
    shutil.copy(ROOT / "docs" / "site.css", folder)


main()
