"""cxx.py: C++ with its words told apart, and names in it that lead to the header that declares them."""
import functools
import re
from pathlib import Path

from tex import escaped

DECLARATION = re.compile(
    r"^(?:template.*>\s*)?(?:(?:inline|constexpr|static|const|virtual|explicit)\s+|\[\[nodiscard\]\]\s*)*"
    r"[\w:<>,&* ]*?[\w>&*]\s+&?\*?(\w+)\(|"
    r"^(?:struct|class|enum class|using) (\w+)")
WORDS = re.compile(
    r"""(?P<c>//[^\n]*|/\*.*?\*/)|(?P<s>R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])')|(?P<p>^[ \t]*\#\w+)|
    (?P<n>\b\d[\w.']*(?:(?<=e)-\d+)?)|(?P<k>\b(?:auto|bool|break|case|catch|char|class|const|constexpr|continue|default|double|else|enum|
    explicit|false|for|friend|if|inline|int|mutable|namespace|noexcept|nullptr|operator|override|private|protected|public|return|static|
    static_cast|struct|switch|template|this|throw|true|try|typename|using|virtual|void|while)\b)|
    (?P<i>\b[A-Za-z_]\w+)""", re.X | re.M | re.S)

# Before a member or a variable, whose type comes first; after return and its like a function is called.
NAMED_HERE = re.compile(r"\s.*(?<!\breturn)(?<!\belse)(?<!\bthrow)(?<!\bcase)(?<=[\w>&*])(?<!\s[&*])\s$")


def highlighted(code, language, link=lambda name, before, after: None):
    """Code as HTML; `link` says where a name leads, from what stands before it in its line, and the sign after it."""
    if language not in ("cpp", "c++"):
        return escaped(code)

    def one(m):
        kind, said = m.lastgroup, escaped(m[0])
        if kind != "i":
            return "\n".join('<span class="%s">%s</span>' % (kind, line) for line in said.split("\n"))
        to = link(m[0], code[code.rfind("\n", 0, m.start()) + 1:m.start()], code[m.end():m.end() + 1])
        return '<a href="%s">%s</a>' % (to, said) if to else said

    out, at = [], 0
    for m in WORDS.finditer(code):
        out += [escaped(code[at:m.start()]), one(m)]
        at = m.end()
    return "".join(out) + escaped(code[at:])


def declared(line):
    """The function or the type that a line at the left edge declares, or None."""
    m = DECLARATION.match(line)
    return (m[1] or m[2]) if m and not line.startswith(("return", "else", "#", "namespace")) else None


@functools.lru_cache(None)
def declarations(path):
    """name -> (contract, declaration) of a file, as its comments and code say."""
    lines, found, contract = Path(path).read_text(encoding="utf-8").split("\n"), {}, []
    for k, line in enumerate(lines):
        if line.startswith("///"):
            contract.append(line[4:])
            continue
        name = declared(line)
        if name and name not in found:
            end = next((j for j in range(k, min(k + 10, len(lines))) if re.search(r"[;{]\s*(?://.*)?$", lines[j])), k)
            found[name] = ("\n".join(contract), "\n".join(lines[k:end + 1]))
        if not re.match(r"\[\[nodiscard\]\]\s*$|template", line):
            contract = []
    return found


@functools.lru_cache(None)
def index(root):
    """name -> header; what several headers or a chapter declare leads nowhere."""
    where = {}
    for path in sorted(Path(root).glob("src/**/*.hpp")):
        for name in declarations(path):
            if len(name) > 3:
                where.setdefault(name, set()).add(str(path.relative_to(root)))
    for path in Path(root).glob("chapters/ch*/*.[ch]pp"):
        for name in declarations(path):
            where.pop(name, None)
    return {name: paths.pop() for name, paths in where.items() if len(paths) == 1}


def place(book, path, name):
    """Where a file declares A::name: at name, or at A, or at its begin."""
    known = declarations(book.root / path)
    anchor = next((part for part in reversed(name.split("::")) if part in known), "")
    return book.source_page(path) + ".html" + ("#" + anchor if anchor else "")


def linker(book, own=None):
    """Where a name in a listing leads: types, and functions that are called, not what a local variable happens to be named."""
    where = index(book.root)

    def link(word, before="", after=""):
        called = after in ("(", "<") and not before.endswith((".", "->", "std::")) and not NAMED_HERE.match(before)
        to = where.get(word) if word != "Eigen" and (word[0].isupper() or called) else None
        return "%s#%s" % ("" if to == own else book.source_page(to) + ".html", word) if to else None
    return link
