#!/usr/bin/env python3
"""Checks that links and pictures of a static site lead to files and ids that are there: check_links.py FOLDER"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The links and the ids of a page"""

    def __init__(self, file):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        for key, value in attrs:
            if key == "id" or (key == "name" and tag == "a"):
                self.ids.add(value)
            elif key in ("href", "src") and value:
                self.links.append(value)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    # 404.html is for addresses of a server.
    pages = {file: Page(file) for file in root.rglob("*.html") if file != root / "404.html"}
    broken, count = [], 0
    for file, page in pages.items():
        for link in page.links:
            address = urllib.parse.urlsplit(link)
            # Doxygen names a list of nested classes even where it leaves them out.
            if address.scheme or address.netloc or link == "#nested-classes":
                continue
            count += 1
            target = (file.parent / urllib.parse.unquote(address.path)).resolve() if address.path else file
            if target.is_dir():
                target = target / "index.html"
            anchor = urllib.parse.unquote(address.fragment)
            if not target.exists():
                broken.append(f"{file.relative_to(root)}: there is no {link}")
            elif anchor and target in pages and anchor not in pages[target].ids and not anchor.startswith("__"):
                broken.append(f"{file.relative_to(root)}: nothing is called {link}")
    print(*sorted(set(broken)), sep="\n", file=sys.stderr, end="\n" if broken else "")
    print(f"{count} links of {len(pages)} pages, {len(set(broken))} broken")
    sys.exit(bool(broken))


main()
