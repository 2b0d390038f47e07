# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Puts the pages of the tree where Sphinx reads them, at the same places, so that their links hold. A file of the tree
that a page links to and that is no page, such as a configuration, becomes a page that shows it."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = {".yaml": "yaml", ".yml": "yaml", ".cpp": "c++", ".hpp": "c++", ".py": "python", ".cmake": "cmake",
             ".txt": "text", ".sh": "sh", ".cff": "yaml"}
LINK = re.compile(r"(\]\()([^)\s]+)(\))")  # its text may begin on the line before
IMAGES = {".png", ".svg", ".jpg"}


def heading_of(text: str) -> str:
    found = re.search(r"^# (.*)", text, re.MULTILINE)
    return found[1] if found else ""


class Stage:
    def __init__(self, source: Path):
        self.source = source
        self.pending: list[Path] = []
        self.done: set[Path] = set()
        self.missing = 0

    def all_pages(self) -> None:
        for file in sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]):
            if ROOT / "docs/site" not in file.parents:
                self.pending.append(file)
        while self.pending:
            file = self.pending.pop()
            if file not in self.done:
                self.done.add(file)
                self.page(file, str(file.relative_to(ROOT)))

    def page(self, file: Path, place: str) -> None:
        self.text(place, file.read_text(), file)

    def text(self, place: str, text: str, origin: Path | None = None) -> None:
        """Writes a page whose links are relative to `origin`, a file of the tree."""
        if origin is not None:
            text = self.rewritten(text, origin, place)
        if origin is not None and origin.name == "README.md" and ROOT not in (origin.parent, origin.parent.parent):
            text = "---\norphan: true\n---\n" + text  # of a room; pages link to it
        target = self.source / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    def rewritten(self, text: str, origin: Path, place: str) -> str:
        out, fenced = [], False
        for line in text.split("\n"):
            if line.lstrip().startswith("```"):
                fenced = not fenced
            elif not fenced and (defined := re.match(r"(\[[^\]]+\]: )(\S+)$", line)):
                line = defined[1] + self.target(defined[2], origin, place)
            elif not fenced and not line.startswith("    "):
                # Also inside of `code`, which may go over lines: without a dot or slash only a file's name is a link.
                line = LINK.sub(lambda m: m[1] + self.target(m[2], origin, place) + m[3]
                                if re.search("[./#]", m[2]) or (origin.parent / m[2]).exists() else m[0], line)
            out.append(line)
        return "\n".join(out)

    def target(self, link: str, origin: Path, place: str) -> str:
        if re.match(r"[a-z]+:|#", link):
            return link
        name, _, anchor = link.partition("#")
        if origin.parent == ROOT / "docs/site":  # the front page names places of the site
            return link
        file = (origin.parent / name).resolve()
        if not file.exists() or ROOT not in file.parents:
            print(f"{origin.relative_to(ROOT)}: there is no {link}", file=sys.stderr)
            self.missing += 1
            return link
        if file.suffix == ".md" and file.is_file():
            self.pending.append(file)
            there = str(file.relative_to(ROOT))
        elif file.suffix in IMAGES:
            there = str(file.relative_to(ROOT))
            (self.source / there).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, self.source / there)
        else:
            there = self.shown(file)
        return os.path.relpath(there, Path(place).parent) + (f"#{anchor}" if anchor else "")

    def shown(self, file: Path) -> str:
        """A page that shows a file or a folder; its place."""
        name = str(file.relative_to(ROOT))
        place = f"files/{name}.md"
        if file in self.done:
            return place
        self.done.add(file)
        text = f"---\norphan: true\n---\n# {name}\n\n"
        if file.is_dir():
            if (file / "README.md").exists():
                self.pending.append(file / "README.md")
            for inner in sorted(file.iterdir()):
                if inner.name != "__pycache__" and (inner.is_dir() or inner.suffix not in IMAGES):
                    there = str(inner.relative_to(ROOT)) if inner.suffix == ".md" else self.shown(inner)
                    if inner.suffix == ".md":
                        self.pending.append(inner)
                    text += f"* [{inner.name}]({os.path.relpath(there, Path(place).parent)})\n"
        else:
            try:
                content = file.read_text()
            except UnicodeDecodeError:
                content = "(not a text)\n"
            lines = content.splitlines()
            most = 400
            if len(lines) > most:
                content = "\n".join(lines[:most]) + f"\n... {len(lines) - most} more lines\n"
            language = LANGUAGES.get(file.suffix, "text")
            text += f"A file of the repository.\n\n````{language}\n{content.rstrip()}\n````\n"
        target = self.source / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
        return place


def commands_page(program: str) -> str:
    """What --help prints, command by command."""
    def output(*arguments: str) -> str:
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout.rstrip()

    main = output("--help")
    commands = re.findall(r"^  (\w+) ", main.split("Subcommands:")[1], re.MULTILINE)
    text = "# Commands\n\nThe same texts are in the man pages, `man leastcost` and `man leastcost-run`.\n\n"
    text += f"## leastcost\n\n```text\n{main}\n```\n"
    for command in commands:
        text += f"\n## {command}\n\n```text\n{output(command, '--help')}\n```\n"
    return text


def citation_page() -> str:
    cff = (ROOT / "CITATION.cff").read_text()
    version = re.search(r"VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
    field = lambda key: re.search(rf"^ *(?:- )?{key}: (.*)", cff, re.MULTILINE)[1]  # noqa: E731
    return (f"# Citation\n\n{field('message')} The file `CITATION.cff` of the repository says the same to programs.\n\n"
            f"```text\n@software{{leastcost,\n  author  = {{{{{field('name')}}}}},\n  title   = {{{field('title')}}},\n"
            f"  version = {{{version}}},\n}}\n```\n\n"
            "Also name the source of the method or the data that you used: [Sources](docs/theory/bibliography.md). The\n"
            "method of equally spaced points is that of VFCS, the certificates and proofs are described in\n"
            "[Certificate](docs/theory/certificate.md) and [Proofs](docs/theory/proofs.md).\n")
