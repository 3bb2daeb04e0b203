"""tex.py: the part of TeX that the book uses, as MathML, which browsers show without a script.

formula(TEX, display) gives the MathML and the words of its \\tag.  A command that is not known, and a formula that ends too early,
are a FormulaError.
"""
import functools
import html
import re


class FormulaError(ValueError):
    """A formula that cannot be read."""


def escaped(text):
    """Text for a page: only what would be markup is written otherwise."""
    return html.escape(text, quote=False)


GREEK = dict(zip("alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta kappa lambda mu nu xi pi rho sigma tau phi varphi "
                 "chi psi omega ell partial infty nabla Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega".split(),
                 "αβγδϵεζηθϑκλμνξπρστϕφχψωℓ∂∞∇ΓΔΘΛΞΠΣΦΨΩ"))
UPRIGHT = "ΓΔΘΛΞΠΣΦΨΩ∇∞"
SIGNS = dict(zip("le leq ge geq ne neq approx sim simeq equiv propto in notin subset subseteq cup cap emptyset pm mp cdot times circ "
                 "setminus to mapsto leftarrow rightarrow Rightarrow Leftrightarrow iff forall exists perp parallel mid ll gg int sum prod "
                 "dots ldots cdots vdots ddots langle rangle lvert rvert lVert rVert | { } lfloor rfloor lceil rceil".split(),
                 "≤≤≥≥≠≠≈∼≃≡∝∈∉⊂⊆∪∩∅±∓⋅×∘∖→↦←→⇒⇔⇔∀∃⊥∥∣≪≫∫∑∏…"
                 "…⋯⋮⋱⟨⟩||‖‖‖{}⌊⌋⌈⌉"))
SPACES = {",": .1667, ":": .2222, ";": .2778, "quad": 1, "qquad": 2, " ": .28, "!": -.1667}
ACCENTS = {"bar": "¯", "hat": "^", "tilde": "~", "dot": "˙", "ddot": "¨", "overline": "¯"}
LIMITS = ("min", "max", "arg", "sup", "inf", "lim")
NAMES = ("cos", "sin", "tan", "cot", "log", "ln", "cosh", "sinh", "tanh", "arctan", "arcsin", "arccos", "exp", "det", "dim", "deg")
TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\s+|.", re.S)
THIN = '<mspace width=".17em"/>'


def operator(sign, kind="mo"):
    """A sign that stays as small as it is."""
    still = ' stretchy="false"' if sign in "{}|‖⟨⟩()[]⌊⌋⌈⌉" else ""
    still += ' lspace="0" rspace="0"' if sign in "|‖" else ""    # which of the two begins a norm is not known
    return kind, "<mo%s>%s</mo>" % (still, escaped(sign))


class Formula:
    """A formula that is read from left to right: each part is a pair of its kind, which decides on space, and its MathML."""

    def __init__(self, tex):
        self.raw, self.at, self.tag = tex, 0, None
        self.texts = iter(re.findall(r"\\text\{([^}]*)\}", tex))    # blanks count in them
        self.tokens = [t for t in TOKEN.findall(tex) if not t.isspace() or t == "\\ "]

    def fail(self, why):
        raise FormulaError("formula: %s in %r" % (why, self.raw))

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self):
        if self.at == len(self.tokens):
            self.fail("ends too early")
        self.at += 1
        return self.tokens[self.at - 1]

    def words(self):
        """What stands within {...}."""
        if self.take() != "{":
            self.fail("expected {")
        depth, out = 1, []
        while True:
            token = self.take()
            depth += (token == "{") - (token == "}")
            if depth == 0:
                return "".join(out)
            out.append(token)

    def row(self, *ends):
        """All parts up to one of the ends."""
        parts, out = [], ""
        while self.peek() is not None and self.peek() not in ends:
            parts.append(self.scripts())
        for k, (kind, mathml) in enumerate(parts):
            before = parts[k - 1][0] if k else ""
            after = parts[k + 1][0] if k + 1 < len(parts) else ""
            if mathml == "<mo>−</mo>" and before in ("", "open", "mo", "space"):
                mathml = '<mo form="prefix">−</mo>'    # a sign, no operation
            if kind == "op":    # cos and its like
                mathml = (THIN if before in ("ord", "close") else "") + mathml + (THIN if after in ("ord", "op") else "")
            out += mathml
        return out

    def argument(self):
        token = self.peek()
        if token == "{":
            self.take()
            inside = self.row("}")
            self.take()
            return "<mrow>%s</mrow>" % inside
        if token is not None and token[0].isdigit():
            self.tokens[self.at:self.at + 1] = list(token)    # \frac12
        return self.atom()[1]

    def scripts(self):
        kind, base = self.atom()
        low = high = ""
        while self.peek() in ("_", "^", "'"):
            token = self.take()
            if token == "_":
                low = self.argument()
            elif token == "^":
                high += self.argument()
            else:
                base = '<mrow>%s<mo lspace="0" rspace="0">′</mo></mrow>' % base    # this sign is raised already
        if not (low or high):
            return kind, base
        high = "<mrow>%s</mrow>" % high if high else ""
        tags = ("munder", "mover", "munderover") if "movablelimits" in base else ("msub", "msup", "msubsup")
        tag = tags[2] if low and high else tags[0] if low else tags[1]
        return kind, "<%s>%s%s%s</%s>" % (tag, base, low, high, tag)

    def atom(self):
        token = self.take()
        if token == "{":
            self.at -= 1
            return "ord", self.argument()
        if token == "}":
            self.fail("a } that closes nothing")
        if token[0].isdigit():
            return "ord", "<mn>%s</mn>" % token
        if token.isalpha():
            return "ord", "<mi>%s</mi>" % token
        if token[0] == "\\":
            return self.command(token[1:])
        if token in "([":
            return operator(token, "open")
        if token in ")]":
            return operator(token, "close")
        if token in "./":
            space = 'lspace="0" rspace="0"' if token == "." else 'lspace=".06em" rspace=".06em"'
            return ("ord" if token == "." else "mo"), "<mo %s>%s</mo>" % (space, token)
        return operator({"-": "−", "*": "∗", "~": "\u00a0"}.get(token, token), "ord" if token == "|" else "mo")

    def command(self, name):
        if name in GREEK:
            return "ord", "<mi%s>%s</mi>" % (' mathvariant="normal"' if GREEK[name] in UPRIGHT else "", GREEK[name])
        if name in ("sum", "prod"):
            return "mo", '<mo movablelimits="true">%s</mo>' % SIGNS[name]
        if name in SIGNS:
            return operator(SIGNS[name], "close" if name in ("rangle", "rvert", "rVert", "}") else "mo")
        if name in SPACES:
            return "space", '<mspace width="%sem"/>' % SPACES[name]
        if name in LIMITS:
            return "op", '<mo movablelimits="true" lspace="0" rspace="0">%s</mo>' % name
        if name in NAMES:
            return "op", "<mi>%s</mi>" % name
        if re.fullmatch("[bB]igg?[lr]?", name):
            size = 1.2 if name[0] == "b" else 1.8
            return ("open" if name[-1] == "l" else "close"), '<mo stretchy="true" minsize="%sem" maxsize="%sem">%s</mo>' % (
                size, size, self.delimiter())
        read = getattr(self, "read_" + name, None)
        if not read:
            self.fail("\\%s is not known" % name)
        return read()

    def delimiter(self):
        token = self.take()
        if token == ".":
            return ""
        if token[0] == "\\" and token[1:] not in SIGNS:
            self.fail("%s is no bracket" % token)
        return escaped(SIGNS[token[1:]] if token[0] == "\\" else token)

    def read_frac(self):
        return "ord", "<mfrac>%s%s</mfrac>" % (self.argument(), self.argument())

    read_dfrac = read_frac

    def read_tfrac(self):
        return "ord", '<mstyle displaystyle="false">%s</mstyle>' % self.read_frac()[1]

    def read_binom(self):
        return "ord", '<mrow><mo>(</mo><mfrac linethickness="0">%s%s</mfrac><mo>)</mo></mrow>' % (self.argument(), self.argument())

    def read_mathrel(self):
        return "mo", '<mo rspace="0">%s</mo>' % escaped(self.words())

    def read_sqrt(self):
        if self.peek() != "[":
            return "ord", "<msqrt>%s</msqrt>" % self.argument()
        self.take()
        index = "<mrow>%s</mrow>" % self.row("]")
        self.take()
        return "ord", "<mroot>%s%s</mroot>" % (self.argument(), index)

    def read_mathbb(self):
        letter = self.words()
        if letter not in "RNZ":
            self.fail("\\mathbb{%s} is not known" % letter)
        return "ord", '<mi mathvariant="normal">%s</mi>' % {"R": "ℝ", "N": "ℕ", "Z": "ℤ"}[letter]

    def read_mathrm(self):
        return "ord", '<mi mathvariant="normal">%s</mi>' % escaped(self.words())

    read_operatorname = read_mathrm

    def read_tag(self):
        self.tag = self.words()
        return "space", ""

    def read_text(self):
        self.words()
        return "space", "<mtext>%s</mtext>" % escaped(next(self.texts)).replace(" ", "\u00a0")

    def read_left(self):
        opens = self.delimiter()
        inside = self.row("\\right")
        self.take()
        return "ord", '<mrow><mo stretchy="true">%s</mo>%s<mo stretchy="true">%s</mo></mrow>' % (opens, inside, self.delimiter())

    def read_begin(self):
        kind, rows, token = self.words(), [[]], "&"
        if kind not in ("aligned", "pmatrix", "bmatrix", "matrix", "cases"):
            self.fail("\\begin{%s} is not known" % kind)
        while token != "\\end":
            rows[-1].append("<mtd>%s</mtd>" % self.row("&", "\\\\", "\\end"))
            token = self.take()
            if token == "\\\\":
                rows.append([])
        self.words()
        table = '<mtable class="%s"%s>%s</mtable>' % (kind, ' displaystyle="true"' if kind == "aligned" else "", "".join(
            "<mtr>%s</mtr>" % "".join(row) for row in rows))
        around = {"pmatrix": "()", "bmatrix": "[]", "cases": "{"}.get(kind, "")
        if not around:
            return "ord", table
        return "ord", "<mrow><mo>%s</mo>%s%s</mrow>" % (around[0], table, "<mo>%s</mo>" % around[1] if around[1:] else "")


for ACCENT, MARK in ACCENTS.items():
    setattr(Formula, "read_" + ACCENT, lambda self, mark=MARK: (
        "ord", '<mover accent="true">%s<mo>%s</mo></mover>' % (self.argument(), mark)))


@functools.lru_cache(None)
def formula(tex, display=False):
    """The MathML of a formula, and the words of its \\tag or None."""
    one = Formula(tex)
    inside = one.row()
    if one.peek() is not None:
        one.fail("cannot read on from %r" % one.peek())
    return "<math%s>%s</math>" % (' display="block"' if display else "", inside), one.tag
