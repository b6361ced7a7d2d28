#!/usr/bin/env bash
# Looks at a board that runs the shipping image, from its host: ./loopback.sh DEVICE [ratio].
# The exciter stays unplugged. `ratio` measures the ratio of the channels too, by a loop of wires:
# docs/hardware.md, Ratio of the channels.
set -uo pipefail
cd "$(dirname "$0")/.."
CALIB=${CALIB_TOOL:-target/release/calib}
DEVICE=${1:?names no device: ./run hitl, or hitl/loopback.sh /dev/ttyACM0}
failed=0

look() {
  printf '\n== calib %s\n' "$*"
  "$CALIB" --device "$DEVICE" "$@" || { printf '== FAILED with %d\n' "$?"; failed=$((failed + 1)); }
}

look doctor
look info
# The drive's converter into ADC2 on the chip, noise, alignment, clock against USB, flash, options.
look selftest
# What is at the inputs with nothing driven: lines of the mains, of the Ethernet chip, of the DAC.
look capture --pairs 16384
[ "${2:-}" != ratio ] || look adjust ratio
# Deadlines after all that.
look info

printf '\n'
if [ "$failed" = 0 ]; then echo "loop-back: all passed"; else echo "loop-back: $failed FAILED"; exit 1; fi
