#!/usr/bin/env bash
# Installs what is missing, builds, and opens the workbench: packaging/run.sh --help says how.
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

usage() {
  cat <<'END'
Usage: packaging/run.sh [OPTIONS] [FILE]

Builds PB-FFD Workbench, installing with apt what that needs, and opens FILE in it: a mesh (OBJ, OFF, PLY,
STL) or a project (PBFFD). Without FILE it opens a sample.

  --theme dark|light|system   the colours
  --screenshot [OUT.png]      write a picture of the window and leave; needs no display
                              (pbffd-workbench.png where no name is given)
  --size WxH                  the size of the window in pixels
  --help                      this text
END
}

# What is passed on to the program, and what of it this script has to know.
arguments=()
file=
screenshot=
size=
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h)
      usage
      exit
      ;;
    --screenshot)
      case ${2-} in
        ?*.png | ?*.PNG)
          screenshot=$2
          shift
          ;;
        *) screenshot=pbffd-workbench.png ;;
      esac
      ;;
    --screenshot=*) screenshot=${1#*=} ;;
    --size | --theme)
      [ $# -gt 1 ] || fail "$1 needs a value: packaging/run.sh --help says which."
      [ "$1" = --size ] && size=$2
      arguments+=("$1" "$2")
      shift
      ;;
    --size=*)
      size=${1#*=}
      arguments+=("$1")
      ;;
    --)
      [ $# -gt 1 ] && file=$2
      break
      ;;
    -*) arguments+=("$1") ;;
    *) file=$1 ;;
  esac
  shift
done

if [ -n "$file" ] && [ ! -r "$file" ]; then
  fail "Could not open $file: it is not there, or may not be read. Check the name."
fi
if [ -z "$screenshot" ] && [ -z "${DISPLAY:-}" ]; then
  fail 'There is no display here to open a window on (DISPLAY is not set).' \
    'Run this on a desktop, or get a picture of the window instead:' \
    '  packaging/run.sh --screenshot OUT.png [--size WxH] [FILE]'
fi

install_packages
build_targets pbffd-workbench pbffd pbffd_samples

# A name that begins with a hyphen must not look like an option.
[[ $file != -* ]] || file=./$file
arguments+=(${screenshot:+--screenshot "$screenshot"} "${file:-$build/samples/creature.obj}")
workbench=$build/bin/pbffd-workbench
if [ -z "${DISPLAY:-}" ]; then
  # Room for any size that is asked for, and at least for a large window.
  [[ $size =~ ^[1-9][0-9]*x[1-9][0-9]*$ ]] || size=3840x2160
  under_xvfb "$size" "$workbench" "${arguments[@]}" || exit
else
  "$workbench" "${arguments[@]}" || exit
fi
[ -z "$screenshot" ] || echo "The picture is in $screenshot."
