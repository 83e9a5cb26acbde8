# shellcheck shell=bash
# What run.sh and test.sh share; they source it. Sets `project` and `build`, the folders of the sources and of
# the release build, and defines the functions below. Nothing here changes the caller's working folder.

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
build=$project/build/release

# fail WHAT...: one message on standard error, one line an argument, and the end.
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# The names in packages.txt, one a line.
listed_packages() {
  sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$project/packaging/packages.txt"
}

# Those of the listed packages that are not installed, one a line.
missing_packages() {
  local listed installed
  listed=$(listed_packages | sort -u)
  # dpkg-query fails where it knows nothing of a name; what it does know it still prints.
  installed=$(printf '%s\n' "$listed" |
    xargs dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' 2>/dev/null |
    sed -n 's/^installed //p' | sort -u) || true
  comm -23 <(printf '%s\n' "$listed") <(printf '%s\n' "$installed")
}

# as_root COMMAND...: as root, through sudo where that takes it. Asks for a password only at a terminal.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@" </dev/null
  elif [ -t 0 ]; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    sudo -n env DEBIAN_FRONTEND=noninteractive "$@" </dev/null
  fi
}

can_become_root() {
  [ "$(id -u)" -eq 0 ] && return
  command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }
}

# Installs what is missing of packages.txt; does not touch apt where nothing is.
install_packages() {
  local missing
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo 'This is neither Debian nor Ubuntu, so nothing is installed: the build may find libraries missing.' \
      'packaging/packages.txt names them.' >&2
    return
  fi
  mapfile -t missing < <(missing_packages)
  [ "${#missing[@]}" -eq 0 ] && return
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  can_become_root || fail \
    'Could not install the packages: that takes root, and sudo is not there or asks for a password.' \
    'Run this as root or at a terminal, or install them first:' \
    "  apt-get install --no-install-recommends ${missing[*]}"
  as_root apt-get update -o DPkg::Lock::Timeout=300 || fail \
    'Could not update the package lists (apt-get update, above). Check the network and the sources of apt.'
  as_root apt-get install --yes --no-install-recommends -o DPkg::Lock::Timeout=300 "${missing[@]}" || fail \
    'Could not install the packages (apt-get install, above).' \
    'They are all in Debian 12 (main) and Ubuntu 24.04 (universe); older releases do not have them.'
}

# The folder that the build was configured for, empty where it never was.
configured_for() {
  [ -f "$build/build.ninja" ] || return 0
  sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null || true
}

# build_targets [TARGET...]: all of them without one. Compiles only what changed since the last time.
build_targets() {
  local jobs
  jobs=$(nproc)
  if [ "$(configured_for)" != "$project" ]; then
    # --fresh: a cache of a folder that was moved would be refused.
    cmake --fresh -S "$project" --preset release </dev/null ||
      fail 'Could not configure the build (cmake, above).'
  fi
  cmake --build "$build" --parallel "$jobs" ${1:+--target "$@"} </dev/null ||
    fail 'Could not build (the compiler, above).'
}

# under_xvfb SCREEN COMMAND...: with an X server of its own, that draws in memory and by software.
under_xvfb() {
  local screen=$1
  shift
  env --unset=WAYLAND_DISPLAY LIBGL_ALWAYS_SOFTWARE=1 \
    xvfb-run --auto-servernum --server-args="-screen 0 ${screen}x24" "$@"
}
