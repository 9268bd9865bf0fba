#!/usr/bin/env python3
"""Every link, picture, style and script of the site leads to a file of it, and to a place that is there; nothing is
loaded from elsewhere. Usage: packaging/site/check_links.py FOLDER"""
import os
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

LOADED = {("link", "href"), ("script", "src"), ("img", "src")}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.places = set(), set(), set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if values.get("id"):
            self.places.add(values["id"])
        if tag == "a" and values.get("href"):
            self.links.add(values["href"])
        if values.get("rel") not in ("prev", "next", "canonical"):
            self.loads |= {values[name] for of, name in LOADED if of == tag and values.get(name)}


def main():
    folder = os.path.abspath(sys.argv[1])
    paths = [os.path.join(at, name) for at, _, names in os.walk(folder) for name in names if name.endswith(".html")]
    pages = {path: Page(path) for path in paths}
    checked, faults = 0, []
    for path, page in pages.items():
        for link in sorted(page.links | page.loads):
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loads and parts.scheme != "data":
                    faults.append((path, link + " is loaded from elsewhere"))
                continue
            checked += 1
            # The page of what is not found is shown at any address, and counts from the root.
            base = folder if link.startswith("/") else os.path.dirname(path)
            target = os.path.normpath(os.path.join(base, unquote(parts.path).lstrip("/"))) if parts.path else path
            if os.path.isdir(target):
                target = os.path.join(target, "index.html")
            if not os.path.exists(target):
                faults.append((path, link))
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                faults.append((path, link))
    for path, fault in faults:
        print(f"{os.path.relpath(path, folder)}: {fault}", file=sys.stderr)
    if faults or not pages:
        raise SystemExit(f"{len(faults)} links of {len(pages)} pages lead nowhere")
    print(f"{checked} links of {len(pages)} pages lead somewhere")


if __name__ == "__main__":
    main()
