#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs every test on an X server of its own. The last line is
# 'N passed, N failed'; the exit status is 0 only where tests ran and none failed. Arguments go to ctest
# (for one, -R Placement).
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

install_packages
build_targets

log=$(mktemp)
trap 'rm -f -- "$log"' EXIT
status=0
under_xvfb 1920x1200 ctest --test-dir "$build" --output-on-failure --no-tests=error \
  --parallel "$(nproc)" "$@" </dev/null 2>&1 | tee -- "$log" || status=$?

# ctest closes with "98% tests passed, 1 tests failed out of 50".
summary=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)
read -r failed total <<<"${summary:-0 0}"
echo "$((total - failed)) passed, $failed failed"
[ "$status" -eq 0 ] && [ "$failed" -eq 0 ] && [ "$total" -gt 0 ]
