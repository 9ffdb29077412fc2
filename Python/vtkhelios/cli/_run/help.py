# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Explanations of vtkhelios run --help."""

EPILOG = """\
what it writes, below OUTPUT/<name of the survey>/, for every active leg:
  legNNN_points.xyz       one echo per line: x y z [m], intensity [nW], echo width [ns],
                          return number, number of returns, pulse, object, class, GPS time [s]
  legNNN_trajectory.txt   x y z [m], GPS time [s], roll pitch yaw [deg]
  legNNN_fullwave.txt     the waveforms, with --waveforms: one pulse per line, pulse, origin x y z,
                          direction x y z, first and last time [ns, two-way], GPS time [s],
                          samples [nW]
  legNNN_pulse.txt        the pulses, with --pulses: one per line, origin x y z, direction x y z,
                          time [ns], pulse, channel
  legNNN_hits.pvtp        the hits of sub-rays, with --hits: points with PulseIds, Weight (share of
                          the pulse), Range [m], CellIds, IncidenceAngle [deg]
Legs with the same stripId write to one file each: stripNNN_points.xyz and so on.
With --format las or laz: legNNN_points.las or .laz, LAS 1.4 with all attributes of an echo (Docs/files.md), point
format 6 or 7, which all programs read. With --waveforms legNNN_fullwave.las beside it, the same
points with waveforms, point format 9 or 10, and their samples in legNNN_fullwave.wdp; PDAL and
QGIS refuse these formats. With --waveforms-in-points legNNN_points.las has format 9 or 10, with
legNNN_points.wdp, and is the only LAS file of the leg. The names of parts and materials are beside
each LAS file, as legNNN_points.names.json. Other files are text.
With --format copc: legNNN_points.copc.laz, COPC for viewers and QGIS, made of LAZ at the end of a leg; waveforms
as with laz.
With --format vtp: legNNN_points.pvtp, legNNN_trajectory.pvtp, legNNN_fullwave.pvtt and so on, with
their pieces beside them.
  run_summary.json        versions, inputs with their SHA-256, options, counts and files of every
                          leg, timings
During a run file names end in .part; the files hold whole lines at any time.
A survey whose scene swaps parts has several epochs. They run one after the other, each into its
own folder below that: epoch000, epoch001 and so on. See Docs/scenes.md.

interrupted runs:
  run.journal, beside the files, records what is flushed to disk. The same command with --resume
  continues a run that was killed, stopped by Ctrl-C, or ended by a full disk after its last block;
  the files are then byte-identical to those of an uninterrupted run. Inputs and options (files,
  seed, format, sampling) must be the same; an error names those that differ. The journal and the
  last blocks of the files have checksums: damage is an error; --check-all verifies the whole
  files. A finished run is not changed. See Docs/running.md.

several computers:
  --part K/N runs part K of N of the pulses, into a folder partKKKofNNN; vtkhelios join makes the
  run of them, byte-identical to that of one process. mpiexec -n N vtkhelios run shares the run
  among N ranks of MPI. See Docs/cluster.md.

run time, points and bytes beforehand:
  --dry-run loads the scene, runs at most a tenth of the pulses, sampled over every leg, and
  estimates the whole run, and the price of other tolerances and numbers of sub-rays. It writes nothing.
  --json prints the estimate as JSON. A run of some seconds prints the price in one line before its
  first pulse, on standard error, from at most 2 % of its pulses and time, and one second.

beam sampling:
  A survey with beamSampleQuality has that many circles of sub-rays. Otherwise sampling is
  adaptive, to the tolerances (1 mm for 95 % of the ranges, 1 % of the amplitudes and echoes): a
  closed form for planar footprints, the visible areas of all surfaces in other beams, a picture of
  as many cells as the tolerances require in beams full of leaves, and in beams of more than 512
  surfaces more and more cells until successive answers agree (--max-sub-rays).
  --range-tolerance and --energy-tolerance, --accuracy instrument (a tenth of the scanner's noise),
  or --sub-rays, override the survey. --verbose prints the statistics. See Docs/instrument.md.

accuracy:
  At its end a run computes 200 to 1000 of its pulses with a hit, of all legs, again at a tenth of
  the tolerances, and prints the difference: the 95th percentile of the range error, missed and
  invented echoes, and the RMS of the amplitude, beside what was asked. --verbose prints all measures
  with their 95 % confidence intervals, and the error of this reference itself, some of whose pulses
  are checked with 32,768 sub-rays; run_summary.json has them as "accuracy". What cannot be told is
  said. Noise and turbid voxels are left out. The point files do not depend on it.

where files are searched: absolute names are used unchanged; others in every --assets folder in
order, the folder of the survey, the working directory, and the data shipped with vtkHelios.

examples:
  vtkhelios run survey.xml
  vtkhelios run survey.xml --assets scenes --assets my_scanners --output clouds
  vtkhelios run survey.xml --no-noise --seed 7 --threads 4 --overwrite
  vtkhelios run survey.xml --format vtp --waveforms      for ParaView and PyVista
  vtkhelios run survey.xml --format las                  for LAS tools
  vtkhelios run survey.xml --format copc                 for QGIS, Potree and other viewers
  vtkhelios run survey.xml --range-tolerance 0.0002      a surface scanner: 0.2 mm
  vtkhelios run survey.xml --accuracy instrument         within a tenth of the scanner's noise
  vtkhelios run survey.xml --sub-rays 19 --detector gaussian
  vtkhelios run survey.xml --dry-run                     estimate time, points and bytes
  vtkhelios run survey.xml --resume                      continue an interrupted run
  vtkhelios run survey.xml --epoch 2                     only the third epoch, of a scene with swaps
  vtkhelios run survey.xml --part 2/4                    the second quarter; then vtkhelios join

exit codes: 0 done, 1 failed or no points at all (the reason is on standard error),
2 wrong usage, 130 interrupted by Ctrl-C, 143 by SIGTERM, within a second (the files written so far
are valid; --resume continues).
"""
