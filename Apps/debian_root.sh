# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts that need a clean Debian: ParaView/build.sh, Testing/Install/clean_root.sh
# and packages.sh. Makes one in a folder with debootstrap, and runs commands there. As root.

# helios_own_mounts SCRIPT [ARGUMENT...]: restarts the script so that its mounts end with it.
helios_own_mounts() {
  if [ "$(id -u)" -ne 0 ]; then
    echo "run as root: it installs a Debian in a folder" >&2
    exit 1
  fi
  [ -n "${HELIOS_OWN_MOUNTS:-}" ] || HELIOS_OWN_MOUNTS=1 exec unshare --mount "$@"
}

helios_find_mirror() {
  local files=(/etc/apt/sources.list /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list)
  sed -nE 's/^URIs: *([^ ]+).*/\1/p; s/^deb +(\[[^]]*\] +)?([^ ]+).*/\2/p' "${files[@]}" 2>/dev/null |
    grep -m1 '/debian/*$' || echo "no Debian mirror in /etc/apt; name one" >&2
}

# helios_make_root RELEASE FOLDER [MIRROR]: bookworm (Debian 12) or trixie (13). Uses a Debian that
# is already there. MIRROR: of packages; default: the first one of this system.
helios_make_root() {
  local release=$1 mirror=${3:-}
  helios_root=$2
  if [ ! -x "$helios_root/usr/bin/apt-get" ] || [ -d "$helios_root/debootstrap" ]; then
    if ! command -v debootstrap >/dev/null; then
      echo "install it first: apt-get install debootstrap" >&2
      return 1
    fi
    [ -n "$mirror" ] || mirror=$(helios_find_mirror)
    printf '\n== Debian %s in %s, from %s\n' "$release" "$helios_root" "$mirror"
    debootstrap --variant=minbase "$release" "$helios_root" "$mirror"
  fi
  if ! grep -qs "^VERSION_CODENAME=$release$" "$helios_root/etc/os-release"; then
    echo "$helios_root is not a Debian $release; name another folder" >&2
    return 1
  fi
  cp /etc/resolv.conf "$helios_root/etc/resolv.conf"
  [ -z "${PIP_CERT:-}" ] || cp "$PIP_CERT" "$helios_root/opt/pip_cert.crt"
  mount -t proc proc "$helios_root/proc"
  mount --bind /dev "$helios_root/dev"
}

# helios_enter COMMAND...: in that Debian, with its environment and the caller's settings of pip.
helios_enter() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${PIP_INDEX_URL:+PIP_INDEX_URL="$PIP_INDEX_URL"} ${PIP_CERT:+PIP_CERT=/opt/pip_cert.crt} \
    ${CCACHE_DIR:+CCACHE_DIR=/opt/ccache} \
    chroot "$helios_root" "$@"
}
