#!/usr/bin/env python3
"""Parts the Chinese letters in the search index of a site: MkDocs looks for words, which Chinese does not part by blanks.
Usage: packaging/site/by_letters.py SITE/search/search_index.json"""
import json
import re
import sys

BREAK = "\u200b"  # without width: excerpts look as before


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        index = json.load(file)
    for part in index["docs"]:
        for key in ("title", "text"):
            part[key] = re.sub(r"[\u2e80-\u9fff]", lambda letter: BREAK + letter[0] + BREAK, part[key])
    with open(path, "w", encoding="utf-8") as file:
        json.dump(index, file, ensure_ascii=False)


if __name__ == "__main__":
    main()
