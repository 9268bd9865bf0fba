#!/usr/bin/env python3
"""Gathers what the documentation site is made of: copies of the repository's documents, and pages that are made from
the program and its sources (messages, settings, verbs, help of the window), in English and in Chinese.

Usage: packaging/site/pages.py PROGRAM FOLDER     writes FOLDER/en, FOLDER/zh_CN and the configurations beside them
"""
import glob
import html
import os
import re
import shutil
import subprocess
import sys

from interfaces import cpp_page, python_page
from sources import ROOT, errors_with_advice, finding_codes, read, read_messages

LANGUAGES = ["en", "zh_CN"]
DOCUMENTS = ["*.md", "LICENSE", "CITATION.cff", "docs/**/*.md", "docs/**/*.svg", "docs/**/*.png", "examples/*.cpp",
             "resources/formats/*.md", "resources/messages/README.md", "resources/screenshots/*.png"]
ASSETS = ["packaging/site/site.css", "packaging/site/equations.js"]
KATEX = "/usr/share/javascript/katex"
MADE_BY_HAND = "docs/zh_CN/"  # whole pages in Chinese, in folders like those of docs/

WORDS = {
    "en": {
        "messages": "Messages and remedies",
        "messages-of": "What Remount says of data and results. Each finding has a code, by which it stands in files.",
        "findings": "Findings", "means": "What it means", "remedy": "What to do", "errors": "Errors",
        "errors-of": "Sentences that end a command or refuse a file, and say what was expected or what to do. What stands "
                     "in ‹ › is filled in.",
        "settings": "Every setting", "settings-of": "As `remount-cli settings` prints them.", "setting": "setting",
        "default": "default", "meaning": "meaning, [range]", "verbs": "Every verb",
        "verbs-of": "As `remount-cli VERB --help` prints it. Exit codes and examples: "
                    "[the command line](../docs/manual/command-line.md).",
        "window": "Help of the window", "window-of": "What F1 shows of each panel.",
        "star": "any stream",
    },
    "zh_CN": {
        "messages": "消息与处理办法",
        "messages-of": "Remount 对数据和结果所说的话。每个发现有一个代码，文件中即以此代码记录。",
        "findings": "发现", "means": "含义", "remedy": "处理办法", "errors": "错误",
        "errors-of": "使命令结束或拒绝文件的语句，并说明应有什么或该怎么做。‹ › 中为填入的内容。",
        "settings": "全部设置", "settings-of": "与 `remount-cli settings --language zh_CN` 的输出相同。", "setting": "设置",
        "default": "默认值", "meaning": "含义，[范围]", "verbs": "全部命令",
        "verbs-of": "与 `remount-cli VERB --help --language zh_CN` 的输出相同。退出码和示例见"
                    "[命令行（英文）](../docs/manual/command-line.md)。",
        "window": "窗口帮助", "window-of": "在各面板上按 F1 所显示的内容。",
        "star": "任意数据流",
    },
}
ENGLISH_ONLY = '!!! note ""\n    本页只有英文。\n'


def with_blank_lines(text):
    """Lists that follow a paragraph without a blank line: the repository's view shows them, the site's would not."""
    lines, fenced, before = [], False, ""
    for line in text.split("\n"):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        item = re.match(r"([-*]|\d+\.) ", line)
        if item and not fenced and before.strip() and not re.match(r"([-*]|\d+\.) |\s", before):
            lines.append("")
        lines.append(line)
        before = line
    return "\n".join(lines)


def behind_title(text, words):
    title, rest = text.split("\n", 1)
    return f"{title}\n\n{words}\n{rest}"


def copy_documents(target, language):
    """Every document at its place in the repository; in the Chinese copy those without Chinese words say so."""
    for pattern in DOCUMENTS:
        for path in glob.glob(pattern, root_dir=ROOT, recursive=True):
            os.makedirs(os.path.dirname(os.path.join(target, path)), exist_ok=True)
            if not path.endswith(".md"):
                shutil.copy(os.path.join(ROOT, path), os.path.join(target, path))
                continue
            text = with_blank_lines(read(path))
            if language == "zh_CN" and not path.startswith(MADE_BY_HAND):
                text = chinese_start() if path == "README.md" else behind_title(text, ENGLISH_ONLY)
            write(target, path, text)


def chinese_start():
    """The first page: the Chinese list of documents, with links from where the README lies."""
    text = with_blank_lines(read(MADE_BY_HAND + "README.md"))
    return re.sub(r"\]\((?![a-z]+:|#)([^)]+)\)",
                  lambda link: f"]({os.path.normpath(os.path.join(MADE_BY_HAND, link[1]))})", text)


def copy_assets(target):
    for path in ASSETS:
        os.makedirs(os.path.join(target, "site"), exist_ok=True)
        shutil.copy(os.path.join(ROOT, path), os.path.join(target, "site"))
    shutil.copytree(KATEX, os.path.join(target, "site/katex"))


def write(target, path, text):
    path = os.path.join(target, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def as_text(words):
    """Words that Markdown must not take for its own."""
    return re.sub(r"([\\`*_\[\]<>|$])", r"\\\1", words)


def messages_page(messages, language):
    say, text = WORDS[language], []
    text += [f"# {say['messages']}\n\n{say['messages-of']}\n\n## {say['findings']}\n"]
    for room, kinds in finding_codes():
        for code, meaning, remedy in kinds:
            text.append(f"### `{code}`\n")
            if code.startswith("*"):
                text.append(f"`*`: {say['star']}.\n")
            if code in messages:
                text.append(f"*{as_text(messages[code].words[language])}*\n")
            text.append(f"**{say['means']}**: {as_text(messages[meaning].words[language])}\n")
            text.append(f"**{say['remedy']}**: {as_text(messages[remedy].words[language])}\n")
    text.append(f"## {say['errors']}\n\n{say['errors-of']}\n")
    for room, errors in errors_with_advice(messages):
        text.append(f"### `{room}`\n")
        text += [f"- {as_text(error.words[language])}" for error in errors]
        text.append("")
    return "\n".join(text)


def run(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def settings_page(program, language):
    """Sections and tables from the commented file that the program prints."""
    say = WORDS[language]
    text = [f"# {say['settings']}\n\n{say['settings-of']}"]
    section, comment, count = "", [], 0
    for line in run(program, "--language", language, "settings").split("\n"):
        if re.fullmatch(r"\w+:", line):
            section = line[:-1]
            text.append(f"\n## `{section}`\n\n| {say['setting']} | {say['default']} | {say['meaning']} |\n|---|---|---|")
        elif line.startswith("  #"):
            comment.append(line[3:].strip())
        elif found := re.fullmatch(r"  (\w+): ?(.*)", line):
            default = f"`{found[2]}`" if found[2] not in ("", '""') else ""
            text.append(f"| `{section}.{found[1]}` | {default} | {as_text(' '.join(comment))} |")
            comment, count = [], count + 1
        elif line.strip() and not line.startswith("#"):
            raise SystemExit(f"settings: this line is not understood: {line}")
    print(f"{language}: {count} settings")
    return "\n".join(text) + "\n"


def verbs_page(program, language):
    say = WORDS[language]
    text = [f"# {say['verbs']}\n\n{say['verbs-of']}\n"]
    help_text = run(program, "--language", language, "--help")
    verbs = re.findall(r"^  ([a-z]+) {2,}", help_text, re.MULTILINE)
    for verb in ["", *verbs]:
        shown = run(program, "--language", language, *filter(None, [verb]), "--help")
        text.append(f"## {('remount-cli ' + verb).strip()}\n\n```text\n{shown.rstrip()}\n```\n")
    print(f"{language}: {len(verbs)} verbs")
    return "\n".join(text)


def window_page(language):
    say = WORDS[language]
    text = [f"# {say['window']}\n\n{say['window-of']}\n"]
    for path in sorted(glob.glob(f"resources/help/{language}/*.html", root_dir=ROOT)):
        body = re.search(r"<body>(.*)</body>", read(path), re.DOTALL)[1]
        body = re.sub(r"<h2>(.*?)</h2>", lambda title: f"\n## {html.unescape(title[1])}\n", body, flags=re.DOTALL)
        # Pictures that the window draws itself.
        text.append(re.sub(r'<p><img src="image:[^>]*></p>|<img src="image:[^>]*>', "", body).strip() + "\n")
    return "\n".join(text)


def configuration(source):
    """The nav with its patterns filled in, README first wherever it is named before."""
    lines = []
    for line in read(source).split("\n"):
        pattern = re.fullmatch(r"( *- )(\S+/\*\.md)", line)
        if not pattern:
            lines.append(line)
            continue
        found = sorted(glob.glob(pattern[2], root_dir=ROOT))
        for path in found:
            if not path.endswith("/README.md"):
                title = read(path).split("\n", 1)[0].lstrip("# ").replace("`", "").replace('"', "'")
                lines.append(f'{pattern[1]}"{title}": {path}')
    return "\n".join(lines)


def main():
    program, folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    messages = read_messages()
    for language in LANGUAGES:
        target = os.path.join(folder, language)
        copy_documents(target, language)
        copy_assets(target)
        write(target, "reference/messages.md", messages_page(messages, language))
        write(target, "reference/settings.md", settings_page(program, language))
        write(target, "reference/verbs.md", verbs_page(program, language))
        write(target, "reference/window-help.md", window_page(language))
        write(target, "reference/cpp.md", cpp_page(language))
        write(target, "reference/python.md", python_page(language))
    shutil.copytree(os.path.join(ROOT, "packaging/site/theme"), os.path.join(folder, "theme"))
    write(folder, "en.yml", configuration("packaging/site/mkdocs.yml"))
    write(folder, "zh_CN.yml", configuration("packaging/site/mkdocs.zh_CN.yml"))


if __name__ == "__main__":
    main()
