"""Which programs a shell script calls, by reading it: commands(text)."""
import re
import subprocess

# Words after which a command stands; words that run the command named after them; words with none after them.
OPENERS = set("if then else elif while until do ! { time".split())
RUNNERS = set("exec command env xargs nice sudo supervise".split())
LOOPS = set("for select function case [ [[".split())
NAME = re.compile(r"[A-Za-z_][\w.+-]*$")
ASSIGNMENT = re.compile(r"\w+(\[[^]]*\])?\+?=")


class Piece:
    """The script, or what stands in one $(…): its characters and where they stand; each quoted text is a Q."""

    def __init__(self):
        self.text, self.places, self.depth = "", [], 0

    def add(self, char, place):
        self.text += char
        self.places.append(place)


class Reader:
    """Cuts a script into pieces. kinds: what surrounds the next character, innermost last."""

    def __init__(self, text):
        self.text, self.at = text, 0
        self.pieces, self.open, self.kinds, self.here = [Piece()], [], ["code"], []
        self.open.append(self.pieces[0])
        while self.at < len(text):
            self.step()

    def step(self):
        char, kind = self.text[self.at], self.kinds[-1]
        if char == "\\":
            self.skip(2, "\\" if kind == "code" and self.text[self.at + 1:self.at + 2] == "\n" else "x")
        elif self.text.startswith("$(", self.at) and not self.text.startswith("$((", self.at):
            self.substitution()
        elif self.text.startswith("${", self.at):
            self.skip(2, "Q")
            self.kinds.append("brace")
        elif char == '"' and kind != "here":
            self.quote()
        elif kind == "code":
            self.code(char)
        elif kind == "brace" and char == "}":
            self.kinds.pop()
            self.skip(1)
        elif kind == "here" and self.text.startswith("\n" + self.here[0] + "\n", self.at):
            self.kinds.pop()
            self.skip(len(self.here.pop(0)) + 1)
        else:
            self.skip(1)

    def skip(self, length, shown=""):
        if shown and self.kinds[-1] == "code":
            self.open[-1].add(" " if shown == "\\" else shown, self.at)
        self.at += length

    def quote(self):
        if self.kinds[-1] == "quoted":
            self.kinds.pop()
            self.at += 1
        else:
            self.skip(1, "Q")
            self.kinds.append("quoted")

    def substitution(self):
        self.skip(2, "Q")
        self.kinds.append("code")
        self.pieces.append(Piece())
        self.open.append(self.pieces[-1])

    def code(self, char):
        here = re.compile(r"<<-?\s*['\"]?(\w+)['\"]?").match(self.text, self.at)
        if char == "'":
            self.skip(self.text.index("'", self.at + 1) + 1 - self.at, "Q")
        elif char == "#" and self.text[self.at - 1:self.at] in ("", " ", "\n", "\t", ";", "("):
            self.at = (self.text + "\n").index("\n", self.at)
        elif here and self.text[self.at - 1:self.at] != "<":
            self.here.append(here[1])
            self.skip(len(here[0]))
        elif char == "\n" and self.here:
            self.skip(0, "\n")
            self.kinds.append("here")
        elif char == ")" and self.open[-1].depth == 0 and len(self.open) > 1:
            self.open.pop()
            self.kinds.pop()
            self.at += 1
        else:
            self.open[-1].depth += {"(": 1, ")": -1}.get(char, 0) if len(self.open) > 1 else 0
            self.skip(1, char)


def blank(pattern, text, flags=0):
    """The text with as many blanks in place of what the pattern finds, or of its first group."""
    def cover(found):
        whole, start, end = found[0], found.start(found.lastindex or 0) - found.start(), found.end(found.lastindex or 0) - found.start()
        return whole[:start] + " " * (end - start) + whole[end:]
    return re.sub(pattern, cover, text, flags=flags)


def simplified(text):
    """The piece without arrays, conditions, arithmetic, patterns of case, redirections and heads of functions."""
    text = blank(r"\w\+?=(\([^()]*\))", text)
    text = blank(r"(?:\s|^)(\[\[.*?\]\])", text, re.DOTALL)
    text = blank(r"\$?\(\(.*?\)\)", text)
    text = blank(r"\bin((?:\s|^)\s*[^\n)(]*\))", text)
    text = blank(r";;(\s*(?!esac)[^\s()][^()\n]*\))", text)
    text = blank(r"[\w-]+\(\)", text)
    return blank(r"\d*[<>]+(?:&\s*[\w-]+|[ \t]*(?!\()[^\s;|&)]+)", text)


def commands_of(piece):
    """(place, name) of each command of a piece that names its program itself."""
    for found in re.finditer(r"[^\n;|&()`]+", simplified(piece.text)):
        run = False
        for word in re.finditer(r"\S+", found[0]):
            if ASSIGNMENT.match(word[0]) or word[0] in OPENERS:
                continue
            if word[0] in RUNNERS:
                run = True
                yield piece.places[found.start() + word.start()], word[0]
            elif NAME.match(word[0]) and word[0] not in LOOPS:
                if "Q" not in word[0]:
                    yield piece.places[found.start() + word.start()], word[0]
                break
            elif not run or word[0] in LOOPS:
                break


def own_words(text):
    """Bash's own commands, and the functions of the script."""
    said = subprocess.run(["bash", "-c", "compgen -b -k"], stdout=subprocess.PIPE, text=True).stdout
    return set(said.split()) | set(re.findall(r"^[ \t]*([\w-]+)\(\)", text, re.MULTILINE))


def commands(text):
    """(line, program) for each program that the script calls by its name."""
    own = own_words(text)
    for piece in Reader(text).pieces:
        for place, name in commands_of(piece):
            if name not in own:
                yield text.count("\n", 0, place) + 1, name
