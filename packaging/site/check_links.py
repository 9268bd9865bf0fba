#!/usr/bin/env python3
"""Every link, picture, style and script of the site leads to a file of it, and to a place that is there; no page and no
style loads anything from elsewhere. What scripts load as they run is not looked at.
Usage: packaging/site/check_links.py FOLDER"""
import os
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

LOADED = {("link", "href"), ("script", "src"), ("img", "src"), ("source", "src"), ("audio", "src"), ("video", "src"),
          ("video", "poster"), ("track", "src"), ("iframe", "src"), ("embed", "src"), ("object", "data"),
          ("image", "href"), ("image", "xlink:href"), ("use", "href"), ("use", "xlink:href"), ("input", "src")}
STYLE_LOADS = re.compile(r"""url\(\s*(?:"([^"]*)"|'([^']*)'|([^)"']*?))\s*\)|@import\s+(?:"([^"]*)"|'([^']*)')""")


def loads_of_style(text):
    """What a style names as url(…) and by @import."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    return {next(filter(None, found)) for found in STYLE_LOADS.findall(text) if any(found)}


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.places, self.in_style = set(), set(), set(), False
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
        for candidates in (values.get("srcset"), values.get("imagesrcset")):
            # A comma inside of an address is followed by no blank.
            self.loads |= {one.split()[0] for one in re.split(r",\s+|,$", candidates or "") if one.strip()}
        self.loads |= loads_of_style(values.get("style") or "")
        self.in_style = tag == "style"

    def handle_endtag(self, tag):
        self.in_style = self.in_style and tag != "style"

    def handle_data(self, data):
        if self.in_style:
            self.loads |= loads_of_style(data)


class Style:
    """A file of CSS, in the form of a page."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.links, self.loads, self.places = set(), loads_of_style(file.read()), set()


def files_ending(folder, ending):
    return [os.path.join(at, name) for at, _, names in os.walk(folder) for name in names if name.endswith(ending)]


def main():
    folder = os.path.abspath(sys.argv[1])
    pages = {path: Page(path) for path in files_ending(folder, ".html")}
    styles = {path: Style(path) for path in files_ending(folder, ".css")}
    checked, faults = 0, []
    for path, page in [*pages.items(), *styles.items()]:
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
        raise SystemExit(f"{len(faults)} links of {len(pages)} pages and {len(styles)} styles lead nowhere")
    print(f"{checked} links of {len(pages)} pages and {len(styles)} styles lead somewhere")


if __name__ == "__main__":
    main()
