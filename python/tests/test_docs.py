# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Python in the pages is true: the blocks of a page run, one after the other."""

import re
from pathlib import Path

import pytest


@pytest.mark.parametrize("page", ["docs/python.md", "docs/tutorial/python.md", "python/README.md"])
def test_blocks_run(page, configs, monkeypatch, capsys):
    monkeypatch.chdir(configs.parent)
    blocks = re.findall(r"^```python\n(.*?)^```", Path(page).read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    names: dict = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)
    assert "nan" not in capsys.readouterr().out
