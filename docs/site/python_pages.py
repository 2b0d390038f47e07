# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The Python reference: signatures and docstrings of what `leastcost` exports, read from the source without importing
it, so that it needs neither the compiled module nor numpy."""
import ast
import re
from pathlib import Path


def exported(package: Path) -> list[tuple[str, ast.AST]]:
    """The public names in the order of __all__, each with its definition."""
    modules = {f.stem: ast.parse(f.read_text()) for f in package.glob("*.py")}
    names = next(ast.literal_eval(n.value) for n in modules["__init__"].body
                 if isinstance(n, ast.Assign) and n.targets[0].id == "__all__")
    defined = {n.name: n for m in modules.values() for n in m.body
               if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
    return [(name, defined[name]) for name in names if name in defined]


def text_of(docstring: str | None) -> str:
    """Our docstrings: paragraphs, and lines `name: what it is` with indented continuations, which become a list."""
    if not docstring:
        return ""
    out = []
    for paragraph in docstring.split("\n\n"):
        if paragraph.startswith("    "):
            out.append("```python\n" + re.sub(r"^    ", "", paragraph, flags=re.MULTILINE) + "\n```")
            continue
        lines = re.sub(r"\n +", " ", paragraph).split("\n")
        if all(re.match(r"[\w, *]+: ", line) for line in lines) and len(lines) > 1:
            items = (line.split(": ", 1) for line in lines)
            out.append("\n".join(f"* `{name}`: {escaped(said)}" for name, said in items))
        else:
            items = []
            for line in lines:
                found = re.match(r"([a-z_]\w*(?:, \w+)*): (.*)", line)
                items.append(f"\n* `{found[1]}`: {escaped(found[2])}" if found else escaped(line))
            out.append("\n".join(items))
    return "\n\n".join(out)


def escaped(text: str) -> str:
    return re.sub(r"([\\*_\[\]<>|$])", r"\\\1", text)


def signature(function: ast.FunctionDef, skip_self: bool) -> str:
    arguments = function.args
    if skip_self and arguments.args and arguments.args[0].arg in ("self", "cls"):
        arguments.args = arguments.args[1:]
    returns = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"({ast.unparse(arguments)}){returns}".replace("'", '"')


def is_property(function: ast.FunctionDef) -> bool:
    return any(isinstance(d, ast.Name) and d.id in ("property", "cached_property") for d in function.decorator_list)


def class_text(name: str, node: ast.ClassDef) -> str:
    methods = [n for n in node.body if isinstance(n, ast.FunctionDef)]
    init = next((m for m in methods if m.name == "__init__"), None)
    bases = ", ".join(ast.unparse(b) for b in node.bases)
    shape = signature(init, True).removesuffix(" -> None") if init else f"({bases})" if bases else ""
    text = f"## {name}\n\n```python\nclass {name}{shape}\n```\n\n{text_of(ast.get_docstring(node))}\n"
    if init and ast.get_docstring(init):
        text += f"\n{text_of(ast.get_docstring(init))}\n"
    for field in (n for n in node.body if isinstance(n, ast.AnnAssign)):
        text += f"\n* `{ast.unparse(field.target)}: {ast.unparse(field.annotation)}`\n"
    for method in methods:
        if method.name.startswith("_"):
            continue
        shown = f"{name}.{method.name}"
        head = shown if is_property(method) else f"{shown}{signature(method, True)}"
        if is_property(method) and method.returns:
            head += f": {ast.unparse(method.returns)}"
        text += f"\n### {escaped(shown)}\n\n```python\n{head}\n```\n\n{text_of(ast.get_docstring(method))}\n"
    return text


def page(package: Path) -> str:
    head = ast.get_docstring(ast.parse((package / "__init__.py").read_text()))
    text = f"# Python\n\n{text_of(head)}\n\nHow to install it, and by task: [Python](../docs/python.md).\n\n"
    functions = [(n, d) for n, d in exported(package) if isinstance(d, ast.FunctionDef)]
    classes = [(n, d) for n, d in exported(package) if isinstance(d, ast.ClassDef)]
    for name, node in functions:
        text += (f"## {escaped(name)}\n\n```python\n{name}{signature(node, False)}\n```\n\n"
                 f"{text_of(ast.get_docstring(node))}\n\n")
    return text + "\n".join(class_text(name, node) for name, node in classes)
