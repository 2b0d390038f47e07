# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Python in the pages is true: the blocks of a page run, one after the other."""

import re
from pathlib import Path

import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
README = Path(__file__).parents[2] / "README.md"


@pytest.mark.parametrize("page", ["README.md", "docs/fields.md", "docs/python.md", "docs/tutorial/python.md", "python/README.md"])
def test_blocks_run(page, configs, tmp_path, monkeypatch, capsys):
    blocks = re.findall(r"^```python\n(.*?)^```", (configs.parent / page).read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    (tmp_path / "configs").symlink_to(configs)  # what they write is not left in the tree
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)
    assert "nan" not in capsys.readouterr().out


def test_the_block_of_the_readme_is_short():
    (block,) = re.findall(r"^```python\n(.*?)^```", README.read_text(), re.DOTALL | re.MULTILINE)
    assert len(block.splitlines()) <= 12
