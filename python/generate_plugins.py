#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Writes leastcost/_plugins.py: one function per plug-in, from the same lists of fields as `leastcost describe`.

    python3 python/generate_plugins.py build/release/bin/leastcost          writes the file
    python3 python/generate_plugins.py build/release/bin/leastcost --print  prints it (tests/test_plugins.py)
"""

import json
import keyword
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

Schema = dict[str, Any]
TARGET = Path(__file__).parent / "leastcost/_plugins.py"
WIDTH = 120

HEAD = '''# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
# Made by python/generate_plugins.py: do not edit.
"""Blocks of a configuration, one function per plug-in: `lc.cost.travel_time(gravity=1)` is
{"type": "travel_time", "gravity": 1}. What is not given is left to leastcost, whose defaults may depend on the rest."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Mapping, Sequence
    from typing import Literal, Union

    from numpy.typing import ArrayLike

    File = Union[str, os.PathLike[str]]
    #: The word alone, or its block.
    Block = Union[str, Mapping[str, Any]]

Kind = TypeVar("Kind")


def _block(type: str, **options: Any) -> dict[str, Any]:
    return {"type": type, **{key: value for key, value in options.items() if value is not None}}


def _in_words(kind: type[Kind]) -> type[Kind]:
    """The kind, whose functions say what they have instead of an option that they have not."""
    for name, member in list(vars(kind).items()):
        if isinstance(member, staticmethod):
            setattr(kind, name, staticmethod(_told(f"{kind.__name__}.{name}", member.__func__)))
    return kind


def _told(name: str, function: Callable[..., dict[str, Any]]) -> Callable[..., dict[str, Any]]:
    known = function.__code__.co_varnames[: function.__code__.co_kwonlyargcount]

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> dict[str, Any]:
        for option in options:
            if option not in known:
                raise TypeError(f"lc.{name}() has no option {option!r}{_meant(option, known)}")
        return function(*arguments, **options)

    return call


def _meant(option: str, known: tuple[str, ...]) -> str:
    import difflib

    near = difflib.get_close_matches(option, known, 1)
    if near:
        return f" (did you mean {near[0]!r}?)"
    return f"; its options are: {', '.join(known)}" if known else "; it has none"
'''


def annotation(schema: Schema) -> str:
    """The Python type of an option."""
    kind: Any = schema.get("type")
    if "enum" in schema:
        return f"Literal[{', '.join(json.dumps(choice) for choice in schema['enum'])}]"
    if "allOf" in schema:  # a plug-in
        return "Block"
    if "anyOf" in schema:
        return annotation_of_many(schema["anyOf"])
    if isinstance(kind, list):  # any scalar is taken as it is written
        return "str"
    if kind == "array":
        return annotation_of_list(schema["items"])
    if kind == "object":
        values = schema["additionalProperties"]
        return f"Mapping[str, {annotation(values)}]" if values else "Mapping[str, Any]"
    return {"boolean": "bool", "integer": "int", "number": "float", "string": "File"}[str(kind)]


def annotation_of_many(schemas: list[Schema]) -> str:
    kinds = [schema.get("type") for schema in schemas]
    if kinds == ["boolean", "number"]:
        return "bool | float"
    if kinds == ["number", "array"]:
        return "ArrayLike"
    if "const" in schemas[-1]:
        return f"int | Literal[{json.dumps(schemas[-1]['const'])}]"
    if kinds[-1] == "array":
        return "str | Sequence[str]"
    return "Block"


def annotation_of_list(items: Schema) -> str:
    if "$ref" in items:
        return "Sequence[Block]"
    if items.get("type") == "object":
        return "Sequence[Mapping[str, Any]]"
    return "ArrayLike"


def range_of(schema: Schema) -> str:
    if [part.get("type") for part in schema.get("anyOf", [])] == ["number", "array"]:
        schema = schema["anyOf"][0]
    while schema.get("type") == "array":
        schema = schema["items"]
    words = [(f"> {schema['exclusiveMinimum']:g}") if "exclusiveMinimum" in schema else ""]
    words += [f">= {schema['minimum']:g}" if "minimum" in schema else ""]
    words += [f"<= {schema['maximum']:g}" if "maximum" in schema else ""]
    return " and ".join(filter(None, words))


def parts_of(schema: Schema) -> str:
    """The keys of a block, the types of one that has several, the kind of a plug-in."""
    if schema.get("type") == "array":
        return parts_of(schema["items"])
    if "$ref" in schema:
        return f"lc.{schema['$ref'].split('/')[-1]}"
    if "allOf" in schema:
        return parts_of(schema["allOf"][0])
    if "anyOf" in schema and "allOf" in schema["anyOf"][-1]:
        return f"type: {', '.join(schema['anyOf'][-1]['properties']['type']['enum'])}"
    keys = [key for key in schema.get("properties", {}) if key != "type"]
    return f"with {', '.join(keys)}" if keys else ""


def explanation(option: str, schema: Schema, required: bool) -> str:
    default = f"default: {json.dumps(schema['default'])}" if "default" in schema else ""
    facts = [range_of(schema), parts_of(schema), "" if required else default]
    said = "; ".join(filter(None, facts))
    return f"{option}: {schema['description']}" + (f" ({said})" if said else "")


def function(kind: str, type: str, schema: Schema) -> list[str]:
    required = schema.get("required", [])
    options = {key: value for key, value in schema["properties"].items() if key != "type"}
    ordered = sorted(options, key=lambda key: key not in required)
    names = {key: key + "_" if keyword.iskeyword(key) else key for key in ordered}
    arguments = [
        f"{names[key]}: {annotation(options[key])}" + ("" if key in required else " | None = None") for key in ordered
    ]
    given = "".join(f", {key}={name}" if key == name else f', **{{"{key}": {name}}}' for key, name in names.items())
    lines = ["    @staticmethod", *signature(type, arguments)]
    lines += docstring(schema["properties"]["type"]["description"], [
        explanation(names[key], options[key], key in required) for key in ordered
    ])
    return [*lines, *call(f'        return _block("{type}"{given})')]


def signature(name: str, arguments: list[str]) -> list[str]:
    name += "_" if keyword.iskeyword(name) else ""
    if not arguments:
        return [f"    def {name}() -> dict[str, Any]:"]
    line = f"    def {name}(*, {', '.join(arguments)}) -> dict[str, Any]:"
    if len(line) <= WIDTH:
        return [line]
    body = [part for argument in arguments for part in argument_lines(argument)]
    return [f"    def {name}(", "        *,", *body, "    ) -> dict[str, Any]:"]


def argument_lines(argument: str) -> list[str]:
    """A long list of words has lines of its own."""
    line = f"        {argument},"
    if len(line) <= WIDTH:
        return [line]
    head, words = argument.split("[", 1)
    words, tail = words.split("]", 1)
    body = textwrap.wrap(words, WIDTH, initial_indent=" " * 12, subsequent_indent=" " * 12)
    return [f"        {head}[", *body, f"        ]{tail},"]


def docstring(summary: str, options: list[str]) -> list[str]:
    def wrapped(text: str, indent: str) -> list[str]:
        text = text.replace("\\", "\\\\")
        return textwrap.wrap(text, WIDTH, initial_indent="        ", subsequent_indent=indent, break_long_words=False,
                             break_on_hyphens=False)

    lines = wrapped('"""' + summary, "        ")
    if options:
        lines.append("")
    for option in options:
        lines += wrapped(option, "          ")
    if options or len(lines[-1]) + 3 > WIDTH:
        return [*lines, '        """']
    return [*lines[:-1], lines[-1] + '"""']


def call(line: str) -> list[str]:
    if len(line) <= WIDTH:
        return [line]
    head, arguments = line.split("(", 1)
    return [head + "(", *textwrap.wrap(arguments.removesuffix(")"), WIDTH, initial_indent=" " * 12,
                                       subsequent_indent=" " * 12), "        )"]


def text(schema: Schema) -> str:
    out = [HEAD]
    for kind, definition in schema["definitions"].items():
        if kind in ("run", "part_of_run", "study") or kind.endswith("_with_name"):
            continue
        cases = definition["anyOf"][-1]["allOf"]
        described = definition["description"]
        summary = docstring(described[0].upper() + described[1:].rstrip(".") + ".", [])
        out.append(f"\n\n@_in_words\nclass {kind}:\n" + "\n".join(line[4:] for line in summary) + "\n")
        for case in cases:
            type = case["if"]["properties"]["type"]["const"]
            out.append("\n" + "\n".join(function(kind, type, case["then"])) + "\n")
    return "".join(out)


def main() -> None:
    schema = json.loads(subprocess.run([sys.argv[1], "schema"], capture_output=True, text=True, check=True).stdout)
    if sys.argv[2:] == ["--print"]:
        print(text(schema), end="")
    else:
        TARGET.write_text(text(schema))


if __name__ == "__main__":
    main()
