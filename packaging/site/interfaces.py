"""Pages that show the interfaces for programs of one's own as they stand in the sources, where their words are."""
import glob
import os
import re

from sources import ROOT, read

WORDS = {
    "en": {"cpp": "Reference of the C++ library", "python": "Reference of the Python module",
           "cpp-of": "The headers that are installed, as they stand. How they are used: [the library](../docs/library.md).",
           "python-of": "The types that the module states, as they stand. How they are used: "
                        "[the Python module](../docs/python.md)."},
    "zh_CN": {"cpp": "C++ 库参考", "python": "Python 模块参考",
              "cpp-of": "所安装的头文件原文。用法见[C++ 库（英文）](../docs/library.md)。",
              "python-of": "模块声明的类型原文。用法见[Python 模块（英文）](../docs/python.md)。"},
}


def cpp_page(language):
    """Each header: the sentence at its head, and what stands in namespace remount::api."""
    text = [f"# {WORDS[language]['cpp']}\n\n{WORDS[language]['cpp-of']}\n"]
    for path in sorted(glob.glob("api/remount/*.h", root_dir=ROOT)):
        header = read(path)
        head = re.match(r"((?://[^\n]*\n)+)", header)
        interface = re.search(r"namespace remount::api \{\n(.*)\n\}  // namespace remount::api", header, re.DOTALL)
        text.append(f"## `{os.path.relpath(path, 'api')}`\n")
        if head:
            text.append(" ".join(line.lstrip("/ ") for line in head[1].splitlines()) + "\n")
        if interface:
            text.append(f"```cpp\n{interface[1].strip()}\n```\n")
    return "\n".join(text)


def python_page(language):
    """Each class and the functions of the module, from the stubs."""
    text = [f"# {WORDS[language]['python']}\n\n{WORDS[language]['python-of']}\n"]
    stubs = read("api/python/remount/__init__.pyi")
    functions = []
    for block in re.split(r"\n(?=(?:class|def|@|[A-Za-z_]\w*\s*[:=]))", stubs):
        if found := re.match(r"class (\w+)", block):
            text.append(f"## `{found[1]}`\n\n```python\n{block.strip()}\n```\n")
        elif found := re.match(r"def (\w+)", block):
            functions.append(f"## `{found[1]}`\n\n```python\n{block.strip()}\n```\n")
    return "\n".join(text + functions)
