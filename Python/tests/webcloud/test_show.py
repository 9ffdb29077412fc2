# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cloud.show(): the page in a notebook."""

import html
import re

import numpy as np
import pytest
from webcloud._page_reader import PageReader

import vtkhelios


@pytest.fixture
def cloud(make_arrays):
    arrays = make_arrays(500)
    return vtkhelios.Cloud.from_arrays(arrays.pop("points"), **arrays)


def frame_of(page):
    """The document of the frame that a notebook shows."""
    found = re.fullmatch(r'<iframe srcdoc="([^"]*)" [^<]*></iframe>', page._repr_html_())
    return html.unescape(found[1])


def test_notebook_shows_the_page(cloud, tmp_path):
    page = cloud.show(color_by="Range", height=444, title='a "b" <c>')
    text = frame_of(page)
    assert text == page.text and 'height="444"' in page._repr_html_()
    read = PageReader(text)
    points, values = read.cloud()
    assert (
        read.meta["title"] == 'a "b" <c>'
        and read.meta["colourBy"] == "Range"
        and len(points) == 500
    )
    assert np.array_equal(np.sort(values["GpsTime"]), np.sort(np.round(cloud["GpsTime"], 7)))
    page.write(tmp_path / "a.html")
    assert (tmp_path / "a.html").read_text() == text
    assert re.fullmatch(
        r"CloudPage\(0\.\d MB\); write\(path\) writes it, notebooks show it", repr(page)
    )


def test_sample_and_arrays(cloud):
    read = PageReader(cloud.show(points=100, arrays=["Range"]).text)
    assert read.meta["shown"] == 100 and [column["name"] for column in read.meta["columns"]] == [
        "Range"
    ]


def test_points_that_are_not_finite_are_left_out(cloud):
    cloud.points[3] = np.nan
    assert PageReader(cloud.show().text).meta["shown"] == 499


def test_first_view(cloud):
    """The classes if there are several, else the colours, else the height."""
    views = []
    for names in (None, ["RGB", "Range"], ["Range"]):
        views.append(PageReader(cloud.show(arrays=names).text).meta["colourBy"])
    assert views == ["ClassificationIds", "RGB", "Height"]


def test_waveforms_of_a_survey(make_survey):
    cloud = vtkhelios.read_survey(make_survey(stop=5)).run(waveforms=True)
    assert PageReader(cloud.show(points=50).text).meta["waveforms"]["count"] == 50


def test_errors(cloud):
    with pytest.raises(KeyError, match="no array Rnge; did you mean Range?"):
        cloud.show(arrays=["Rnge"])
    with pytest.raises(KeyError, match="no array Rnge; the cloud has: Height, Range"):
        cloud.show(color_by="Rnge")
    with pytest.raises(ValueError, match="points is 0; give the most points of the page, from 1"):
        cloud.show(points=0)
    with pytest.raises(ValueError, match="cloud: has no points; give a cloud with points"):
        vtkhelios.Cloud().show()


def test_notebook_is_executed(cloud, tmp_path):
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    code = (
        "import numpy as np, vtkhelios\n"
        "vtkhelios.Cloud.from_arrays(np.random.default_rng(1).normal(size=(99, 3))).show()"
    )
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    nbclient.NotebookClient(notebook, timeout=120).execute()
    output = notebook.cells[0].outputs[0].data
    assert output["text/plain"].startswith("CloudPage(") and output["text/html"].startswith(
        "<iframe"
    )
