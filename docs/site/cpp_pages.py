# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The C++ reference: Markdown from the XML that Doxygen makes of the installed headers, a page for each folder.

A name without a comment gets its sentence from where there is one: an option from its `help` in the list of fields, a
type of a variant from `kHelp`, an override from what it overrides, names of one declaration from the comment behind it,
an overload from the others. What has none is listed as such and counted."""
import os
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from pages import ROOT

STRING = r'"((?:[^"\\]|\\.)*)"'

# What every class with such a member means by it.
CONSTANTS = {"kType": "Its name in configurations.", "kHelp": "What describe says of it.",
             "kAbility": "The word for this ability in describe and in messages.",
             "present": "Whether this object has the ability: its type only may have it."}

# Functions of <cmath> that the number types of framework/numbers have as well.
FUNCTIONS = {"exp", "expm1", "log", "log1p", "sqrt", "cbrt", "pow", "hypot", "sin", "cos", "tan", "asin", "acos", "atan",
             "atan2", "sinh", "cosh", "tanh", "abs", "fabs", "min", "max", "isfinite", "floor"}


def escaped(text: str) -> str:
    return re.sub(r"([\\`*_\[\]<>|$])", r"\\\1", text)


def plain(element: ElementTree.Element | None) -> str:
    return "" if element is None else re.sub(r"\s+", " ", "".join(element.itertext())).strip()


def markdown(element: ElementTree.Element | None) -> str:
    """The paragraphs of a description; code and lists as text."""
    if element is None:
        return ""
    out = []
    for para in element:
        if para.tag == "para" and para.find("verbatim") is not None:
            out.append("```text\n" + "".join(para.itertext()).strip("\n") + "\n```")
        elif plain(para):
            out.append(escaped(plain(para)))
    return "\n\n".join(out)


def helps() -> dict[tuple[str, str], str]:
    """(struct, option) -> its help, and (struct, "") -> kHelp."""
    found: dict[tuple[str, str], str] = {}
    for folder in ("framework", "problems", "solvers", "recipes", "ompl", "gdal", "urdf", "catalogue"):
        for file in [*(ROOT / folder).rglob("*.cpp"), *(ROOT / folder).rglob("*.hpp")]:
            text = file.read_text()
            for body in re.finditer(r"^(?:inline )?void (?:\w+::)*(\w+)::fields\(\w+Visitor& \w+\) \{(.*?)^\}", text,
                                    re.MULTILINE | re.DOTALL):
                for call in re.finditer(rf'\(\s*"(\w+)",\s*(\w+).*?\.help\s*=\s*((?:{STRING}\s*)+)', body[2], re.DOTALL):
                    sentence = "".join(re.findall(STRING, call[3])).replace('\\"', '"')
                    found.setdefault((body[1], call[2]), sentence)
            for struct in re.finditer(rf"^ *struct (\w+) \{{.*?kHelp\s*=\s*((?:{STRING}\s*)+);", text,
                                      re.MULTILINE | re.DOTALL):
                if "\n}" not in struct[0]:
                    found[struct[1], ""] = "".join(re.findall(STRING, struct[2])).replace('\\"', '"')
    return found


class Reference:
    def __init__(self, xml: Path):
        self.help = helps()
        self.all, self.bare = 0, []
        self.sentences: dict[str, str] = {}  # of a member's id, for those that override it
        self.folders: dict[str, dict[str, list[str]]] = {}  # folder -> header -> blocks of Markdown
        self.names: list[tuple[str, str, str]] = []
        roots = [ElementTree.parse(f).getroot() for f in sorted(xml.glob("*.xml")) if f.name != "index.xml"]
        compounds = [c for root in roots for c in root.iter("compounddef")]
        self.beside: dict[tuple[str, str], str] = {}  # of a declaration, and of a set of overloads
        for compound in compounds:
            for member in compound.iter("memberdef"):
                said = plain(member.find("briefdescription")) or plain(member.find("detaileddescription"))
                self.sentences[member.get("id")] = said
                for place in self.places(member, compound.findtext("compoundname").split("::")[-1]):
                    self.beside[place] = self.beside.get(place) or said
        for compound in compounds:
            name = compound.findtext("compoundname")
            if compound.get("kind") in ("class", "struct") and compound.get("prot") == "public":
                if self.is_public(name):
                    self.class_(compound, name)
            elif compound.get("kind") == "namespace" and self.is_public(name):
                for member in compound.iter("memberdef"):
                    self.free(member)

    @staticmethod
    def is_public(name: str) -> bool:
        return name.startswith("leastcost") and "detail" not in name.split("::") and "<" not in name

    @staticmethod
    def places(member: ElementTree.Element, owner: str) -> list[tuple[str, str]]:
        """Where another member may have the comment that this one shares."""
        location = member.find("location")
        declaration = [] if member.get("kind") != "variable" else [(location.get("file"), location.get("line"))]
        return declaration + [(owner, member.findtext("name"))]

    def place(self, element: ElementTree.Element) -> list[str]:
        header = element.find("location").get("file")
        header = header[header.index("leastcost/"):] if "leastcost/" in header else header
        folder = str(Path(header).parent.relative_to("leastcost"))
        return self.folders.setdefault(folder if folder != "." else "all", {}).setdefault(header, [])

    def sentence(self, element: ElementTree.Element, owner: str, name: str) -> str:
        """What is said about a name, from the first place that says something."""
        self.all += 1
        own = plain(element.find("briefdescription")) or plain(element.find("detaileddescription"))
        if own:
            return own
        overridden = element.find("reimplements")
        if overridden is not None:
            self.sentences[element.get("id")] = self.sentences.get(overridden.get("refid"), "")
            above = self.sentences[element.get("id")]
            base = overridden.text.split("::")[-1]
            return above or f"See {base} of the class that this one is made from."
        if not name:
            if (owner, "") in self.help:
                return self.help[owner, ""]
            if owner.endswith("Options"):
                return f"Options of {owner[:-len('Options')]}."
        elif (owner, name) in self.help:
            return self.help[owner, name]
        elif name == owner:
            return f"Makes a {owner}."
        elif name == f"~{owner}":
            return "Destructor."
        elif name == "fields":
            return "Visits every option, for readers and writers of configurations."
        elif name == "words":
            return "The words of configurations and results for the values of an enum."
        elif name in CONSTANTS:
            return CONSTANTS[name]
        elif name.startswith("operator"):
            return "Operator."
        if name:
            for place in self.places(element, owner or "leastcost"):
                if self.beside.get(place):
                    return self.beside[place]
            if element.get("kind") == "typedef":
                return f"Short for {plain(element.find('type'))}."
            if name in FUNCTIONS and "/numbers/" in element.find("location").get("file"):
                return f"std::{name} for this type of number."
        self.bare.append(f"{owner}::{name}" if owner and name else owner or name)
        return ""

    def class_(self, compound: ElementTree.Element, full: str) -> None:
        name = full.split("::")[-1]
        blocks = self.place(compound)
        short = full.removeprefix("leastcost::")
        first = self.sentence(compound, name, "")
        self.names.append((short, compound.find("location").get("file"), first))
        bases = ", ".join(plain(b) for b in compound.findall("basecompoundref") if b.get("prot") == "public")
        template = compound.find("templateparamlist")
        head = "" if template is None else "template <" + ", ".join(
            " ".join(filter(None, (plain(p.find("type")), plain(p.find("declname"))))) for p in template) + ">\n"
        text = f"({anchor(short)})=\n### {escaped(short)}\n\n```c++\n{head}{compound.get('kind')} {short}"
        text += f" : {bases}\n```\n" if bases else "\n```\n"
        for part in ("briefdescription", "detaileddescription"):
            text += "\n" + (markdown(compound.find(part)) + "\n" if markdown(compound.find(part)) else "")
        if not plain(compound.find("briefdescription")) + plain(compound.find("detaileddescription")):
            text += escaped(first) + "\n"
        rows = ""
        for member in compound.iter("memberdef"):
            if member.get("prot") != "public" or member.get("kind") == "friend":
                continue
            sentence = self.sentence(member, name, member.findtext("name"))
            rows += f"| {code(signature(member))} | {escaped(sentence)} |\n"
        blocks.append(text + (f"\n| member | |\n|---|---|\n{rows}" if rows else ""))

    def free(self, member: ElementTree.Element) -> None:
        name = member.findtext("name")
        if "/leastcost/" not in "/" + member.find("location").get("file"):
            return
        blocks = self.place(member)
        first = self.sentence(member, "", name)
        if member.get("kind") != "function" or not name.startswith("operator"):
            self.names.append((name, member.find("location").get("file"), first))
        text = f"### {escaped(name)}\n\n```c++\n{signature(member)}\n```\n\n"
        described = "\n\n".join(filter(None, (markdown(member.find("briefdescription")),
                                              markdown(member.find("detaileddescription")))))
        text += (described or escaped(first)) + "\n"
        values = "".join(
            f"| `{v.findtext('name')}` | {escaped(plain(v.find('briefdescription')) or plain(v.find('detaileddescription')))} |\n"
            for v in member.findall("enumvalue"))
        blocks.append(text + (f"\n| value | |\n|---|---|\n{values}" if values else ""))


def anchor(name: str) -> str:
    return "cpp-" + re.sub(r"\W+", "-", name).lower()


def code(text: str) -> str:
    return "`" + text.replace("|", "\\|").replace("`", "'") + "`"


def signature(member: ElementTree.Element) -> str:
    kind, name = member.get("kind"), member.findtext("name")
    type_ = plain(member.find("type"))
    if kind == "enum":
        return f"enum class {name}"
    if kind == "typedef":
        return f"using {name} = {type_}"
    text = " ".join(filter(None, (type_, name)))
    if kind == "function":
        text += re.sub(r"\s*=\s*(0|default)$", "", plain(member.find("argsstring")))
    elif member.find("initializer") is not None:
        value = plain(member.find("initializer"))
        text += " " + value if len(value) < 40 else ""
    text = re.sub(r"< ", "<", text).replace(" >", ">").replace(" &", "&").replace(" *", "*")
    return re.sub(r"([&*])(?=\w)", r"\1 ", text)


def page_name(folder: str) -> str:
    return folder.replace("/", "_") + ".md"


def write(xml: Path, target: Path) -> dict[str, int]:
    reference = Reference(xml)
    target.mkdir(parents=True, exist_ok=True)
    for folder, headers in reference.folders.items():
        text = f"# {folder}\n\n"
        for header, blocks in sorted(headers.items()):
            text += f"## {escaped(header)}\n\n`#include <{header}>`\n\n" + "\n".join(blocks) + "\n"
        (target / page_name(folder)).write_text(text)
    tree = "\n".join(page_name(f) for f in sorted(reference.folders))
    rows = ""
    for name, header, sentence in sorted(set(reference.names), key=lambda n: n[0].lower()):
        header = header[header.index("leastcost/"):]
        folder = str(Path(header).parent.relative_to("leastcost"))
        short = re.split(r"(?<=[.:;]) ", sentence)[0] if sentence else ""
        rows += f"| [{escaped(name)}]({page_name(folder if folder != '.' else 'all')}) | {escaped(short)} |\n"
    (target / "index.md").write_text(
        "# C++\n\nThe installed headers, by folder; below, all names. How to link the library:\n"
        f"[install]({os.path.relpath(target.parents[1] / 'docs/install.md', target)}); by task: "
        f"[C++ by task]({os.path.relpath(target.parents[1] / 'docs/cpp.md', target)}).\n\n"
        f"```{{toctree}}\n:maxdepth: 1\n\n{tree}\n```\n\n## All names\n\n| name | |\n|---|---|\n{rows}")
    (target.parents[2] / "undocumented.txt").write_text("\n".join(reference.bare) + "\n")
    return {"all": reference.all, "bare": len(reference.bare)}
