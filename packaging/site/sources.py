"""What the program says, read from its sources: the catalogue of messages, and the codes of findings with meaning and
remedy (model/checks). Where something there is not as expected this ends with its place: no page is half."""
import glob
import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


class Sentence:
    def __init__(self, code, room, advises):
        self.code, self.room, self.advises, self.words = code, room, advises, {}


def shown(text):
    """Places as ‹name›; of words that depend on a count those for several; braces and line ends as they are read."""
    text = text.replace("\\n", " ").replace("{{", "\0").replace("}}", "\1")
    text = re.sub(r"\{\w+\?([^|}]*)\|([^}]*)\}", r"\2", text)
    text = re.sub(r"\{(\w+)[^}]*\}", lambda place: "‹" + place[1].replace("_", " ") + "›", text)
    return text.replace("\0", "{").replace("\1", "}")


def read_messages():
    """All messages by their codes, as resources/messages/README.md has the files."""
    messages = {}
    for path in sorted(glob.glob("resources/messages/*.txt", root_dir=ROOT)):
        room, sentence, language = os.path.basename(path)[:-4], None, None
        for number, line in enumerate(read(path).split("\n"), 1):
            if not line.strip() or line.startswith("#"):
                continue
            if head := re.fullmatch(r"([a-z][a-z0-9-]*)( advises)?", line):
                sentence = messages[head[1]] = Sentence(head[1], room, bool(head[2]))
            elif words := re.match(r"  (en|zh_CN): ?(.*)", line):
                language = words[1]
                sentence.words[language] = words[2]
            elif line.startswith("  ") and language:
                # Between Chinese characters no blank is missing.
                joint = "" if language == "zh_CN" and ord(sentence.words[language][-1]) > 0x2E80 else " "
                sentence.words[language] += joint + line.strip()
            else:
                raise SystemExit(f"{path}:{number}: expected a code, a language or more of a sentence: {line}")
    for sentence in messages.values():
        sentence.words = {language: shown(words) for language, words in sentence.words.items()}
    return messages


def finding_codes():
    """(file of model/checks, [(code, message of its meaning, message of its remedy)]), in the order of data_checks()."""
    makers, kinds_of = {}, {}
    for path in sorted(glob.glob("model/checks/*.cpp", root_dir=ROOT)):
        text = read(path)
        if maker := re.search(r"^DataCheck (\w+)\(\) \{", text, re.MULTILINE):
            makers[maker[1]] = path
            kinds = re.findall(r'\{"([*\w-]+)",\s*say::(\w+),\s*say::(\w+)\}', text[maker.start():])
            kinds_of[path] = [(code, message_code(meaning), message_code(remedy)) for code, meaning, remedy in kinds]
            if len(kinds) != len(re.findall(r'\{"', text[maker.start():])):
                raise SystemExit(f"{path}: a code of a finding is written in another way than those that are known")
    listed = re.findall(r"(\w+_check)\(\)", read("model/checks/data_checks.cpp"))
    if sorted(listed) != sorted(makers):
        raise SystemExit(f"model/checks: data_checks() lists {listed}, files make {sorted(makers)}")
    return [(makers[maker], kinds_of[makers[maker]]) for maker in listed]


def message_code(function):
    return function.replace("_", "-")


def errors_with_advice(messages):
    """(room, [sentence]) of sentences that say what was expected or what to do, rooms by name."""
    rooms = {}
    for sentence in messages.values():
        if sentence.advises:
            rooms.setdefault(sentence.room, []).append(sentence)
    return sorted(rooms.items())
