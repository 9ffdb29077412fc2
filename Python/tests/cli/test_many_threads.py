# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""With many threads the pieces of a block are computed together: the files are the same."""

import _command_line
import _small_run


def test_files_of_many_threads_are_those_of_one(tmp_path):
    survey = _small_run.write_survey(tmp_path)
    text = survey.read_text()
    survey.write_text(text.replace('headRotateStop_deg="60"', 'headRotateStop_deg="260"'))
    written = {}
    for threads in (1, 17, 33):
        output = tmp_path / str(threads)
        more = ["--threads", str(threads), "--sub-rays", "1", "--no-accuracy-report"]
        assert _command_line.start(survey, output, more).wait() == 0
        written[threads] = {
            path.name: path.read_bytes() for path in (output / "fence").glob("*.xyz")
        }
    assert len(written[1]) == 2
    assert min(len(content) for content in written[1].values()) > 1_000_000
    assert written[17] == written[1]
    assert written[33] == written[1]
