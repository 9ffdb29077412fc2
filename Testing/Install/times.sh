# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by clean_root.sh and readme.sh: the time of each step, and whether it worked.

helios_times=()
helios_failed=false

helios_minutes() { # SECONDS
  printf '%d min %02d s' $(($1 / 60)) $(($1 % 60))
}

# helios_time NAME COMMAND...: runs it and notes its time; sets helios_failed if it fails.
helios_time() {
  local name=$1 start=$SECONDS status word=ok
  printf '\n== %s\n' "$name"
  set +e
  (
    set -e
    "${@:2}"
  )
  status=$?
  set -e
  if [ $status -ne 0 ]; then
    word="FAILED ($status)"
    helios_failed=true
  fi
  helios_times+=("$(printf '%14s  %-12s %s' "$(helios_minutes $((SECONDS - start)))" "$word" "$name")")
}

helios_print_times() {
  printf '\n== times\n'
  printf '%s\n' "${helios_times[@]}"
}
