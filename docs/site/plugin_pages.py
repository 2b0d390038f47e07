# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Adds to the page of each plug-in, which `leastcost describe --markdown` wrote, the configurations that use it."""
import os
import re
from pathlib import Path

import yaml

from pages import ROOT, Stage

# Keys of configurations and studies under which plug-ins stand, and the kind of these.
KINDS = {"manifold": "manifold", "obstacles": "obstacle", "robot": "robot", "cost": "cost", "kernel": "kernel",
         "initializer": "initializer", "solver": "solver", "post_process": "post_processor", "kernels": "kernel",
         "solvers": "solver", "costs": "cost", "factors": "manifold", "terms": "cost"}


def plugins_in(node: object, found: set[tuple[str, str]]) -> None:
    """Every (kind, type) that a tree of YAML names."""
    if isinstance(node, list):
        for item in node:
            plugins_in(item, found)
    if not isinstance(node, dict):
        return
    for key, value in node.items():
        kind = KINDS.get(str(key).split(".")[-1])
        if kind:
            for item in value if isinstance(value, list) else [value]:
                if isinstance(item, str):
                    found.add((kind, item))
                elif isinstance(item, dict) and "type" in item:
                    found.add((kind, str(item["type"])))
        plugins_in(value, found)


def add_configurations(stage: Stage, folder: Path) -> list[str]:
    uses: dict[tuple[str, str], list[Path]] = {}
    for file in sorted([*(ROOT / "configs").glob("*.yaml"), *(ROOT / "configs/studies").glob("*.yaml")]):
        found: set[tuple[str, str]] = set()
        plugins_in(yaml.safe_load(file.read_text()), found)
        for plugin in found:
            uses.setdefault(plugin, []).append(file)
    add_trees(folder)
    unused = []
    for page in sorted(folder.glob("*/*.md")):
        kind, name = page.parent.name, page.stem
        files = uses.get((kind, name), [])
        text = page.read_text()
        if not files:
            unused.append(f"{kind} {name}")
            text += "\n## A configuration\n\n" + f"```yaml\n{minimal(kind, name)}\n```\n"
            page.write_text(text)
            continue
        # Where its name is that of the plug-in it is about it; else the shortest.
        best = min(files, key=lambda f: (name not in f.stem, f.parent.name == "studies", len(f.read_text())))
        link = lambda f: os.path.relpath(stage.source / stage.shown(f), page.parent)  # noqa: E731
        text += f"\n## A configuration that uses it\n\n[{best.relative_to(ROOT)}]({link(best)}):\n\n"
        text += f"```yaml\n{best.read_text().rstrip()}\n```\n"
        rest = [f for f in files if f != best]
        if rest:
            text += "\nAlso: " + ", ".join(f"[{f.stem}]({link(f)})" for f in rest[:20]) + ".\n"
        page.write_text(text)
    return unused


def add_trees(folder: Path) -> None:
    """The index of all kinds, and under each kind its types, in the order of the tables."""
    kinds = [f for f in sorted(folder.glob("*.md")) if f.stem not in ("run", "study", "index")]
    order = ["manifolds", "costs", "obstacles", "robots", "kernels", "initializers", "solvers", "post_processors"]
    kinds.sort(key=lambda f: order.index(f.stem) if f.stem in order else len(order))
    rows = ""
    for kind in kinds:
        text = kind.read_text()
        types = re.findall(r"\]\((\w+/\w+\.md)\)", text)
        rows += f"| [{kind.stem.replace('_', '-')}]({kind.name}) | {text.split(chr(10))[2]} | {len(types)} |\n"
        kind.write_text(text + "\n```{toctree}\n:hidden:\n\n" + "\n".join(types) + "\n```\n")
    tree = "\n".join(["run.md", "study.md", *(k.name for k in kinds)])
    (folder / "index.md").write_text(
        "# Plug-ins and keys\n\nMade by `leastcost describe`, with the configurations of `configs/` that use them. The keys\n"
        f"of a file: [of a configuration](run.md), [of a study](study.md).\n\n| kind | | types |\n|---|---|---|\n{rows}\n"
        f"```{{toctree}}\n:hidden:\n\n{tree}\n```\n")


def minimal(kind: str, name: str) -> str:
    key = {"obstacle": "obstacles", "post_processor": "post_process"}.get(kind, kind)
    return f"{key}: [{{type: {name}}}]" if key != kind else f"{key}: {{type: {name}}}"
