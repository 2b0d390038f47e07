# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Looks up every internal link of a folder of HTML pages: the file must exist, and so must the anchor."""
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, text: str):
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if value is None:
                continue
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src"):
                self.links.append(value)


def check(root: Path) -> tuple[int, int, list[str]]:
    """Pages, internal links, and a line for each dead one."""
    root = root.resolve()
    pages = {file: Page(file.read_text()) for file in root.rglob("*.html")}
    count, dead = 0, []
    for file, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            target = file if not parts.path else (file.parent / unquote(parts.path)).resolve()
            anchor = unquote(parts.fragment)
            if not target.exists():
                dead.append(f"{file.relative_to(root)}: {link}")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                dead.append(f"{file.relative_to(root)}: {link} (no such anchor)")
    return len(pages), count, sorted(set(dead))


if __name__ == "__main__":
    found = check(Path(sys.argv[1]))
    print(*found[2], sep="\n")
    print(f"{found[0]} pages, {found[1]} internal links, {len(found[2])} dead")
    sys.exit(1 if found[2] else 0)
