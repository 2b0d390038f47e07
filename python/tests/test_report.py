# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What the program makes of a run: report, figure; and the little of it that notebooks show."""

import re
import subprocess
import xml.etree.ElementTree as ET

import leastcost as lc
import pytest


@pytest.mark.parametrize("name", ["brachistochrone", "plan_taut"])
def test_the_report_is_that_of_the_program(configs, program, tmp_path, name):
    run = [program, "run", f"configs/{name}.yaml", "-o", tmp_path / name]
    subprocess.run(run, cwd=configs.parent, capture_output=True, check=True)
    theirs = (tmp_path / name / "report.html").read_text()
    ours = lc.run(configs / f"{name}.yaml").report()
    assert ours.startswith("<!doctype html>") or ours.startswith("<!DOCTYPE html>")
    headings = re.compile(r"<h[12][^>]*>.*?</h[12]>")
    assert headings.findall(ours) == headings.findall(theirs) != []
    assert re.findall(r"<svg.*?</svg>", ours, re.DOTALL)[0] == re.findall(r"<svg.*?</svg>", theirs, re.DOTALL)[0]


def test_the_figure_is_that_of_the_program(configs, program, tmp_path):
    for step in (
        [program, "run", "configs/plan_taut.yaml", "-o", tmp_path / "run"],
        [program, "figure", tmp_path / "run", "-o", tmp_path / "figure.svg", "--width", "100mm"],
    ):
        subprocess.run(step, cwd=configs.parent, capture_output=True, check=True)
    result = lc.run(configs / "plan_taut.yaml")
    assert result.figure(width=100) == (tmp_path / "figure.svg").read_text()
    assert ET.fromstring(result.figure()).get("width") == "84mm"


def test_a_size_without_room_is_refused(configs):
    with pytest.raises(lc.InputError, match="width"):
        lc.run(configs / "brachistochrone.yaml").figure(width=3)


def test_notebooks_show_cost_verdict_and_picture(configs):
    html = lc.run(configs / "brachistochrone.yaml")._repr_html_()
    assert "3.14159" in html and "+-" in html and "certified (local)" in html and "<svg" in html
    assert len(html) < 60_000
    ET.fromstring(html.replace("<br>", "<br/>"))


def test_notebooks_show_the_page_that_answers(configs):
    result = lc.run(configs / "plan_taut.yaml")
    cell = ET.fromstring(result.page(height="30em")._repr_html_())
    assert cell.tag == "iframe" and "height:30em" in cell.get("style")
    page, report = cell.get("srcdoc"), result.report()
    assert abs(len(page) - len(report)) < 100  # both say when they were made, and how long that took
    assert page.split()[:40] == report.split()[:40] and 'id="ask-form"' in page


def test_notebooks_say_why_a_path_is_not_certified(configs):
    result = lc.run(configs / "kernel_linear.yaml")
    assert not result.certified
    html = result._repr_html_()
    assert "uncertified" in html and result.failures[0].message.split("<")[0][:20] in html


def test_temporary_folders_are_removed(configs, tmp_path, monkeypatch):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    result = lc.run(configs / "brachistochrone.yaml")
    result.report()
    result.figure()
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setenv("TMPDIR", str(tmp_path / "none"))
    with pytest.raises(lc.OutputError, match="TMPDIR"):
        result.report()
