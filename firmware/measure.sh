#!/usr/bin/env bash
# Measures what each way to draw costs, and writes the tables and pictures of docs/measured, which its README explains:
# cycles of a Cortex-M0+, in an emulator of the RP2040; instructions of a Cortex-M4 and of a 32-bit RISC-V core, in QEMU;
# bytes of flash and RAM; and what the panel of a Pico shows.
#
# Usage: firmware/measure.sh [--check | --profile | --help]
#   --check    Compares with the committed tables instead of writing them, and fails where they differ: exactly for the
#              compiler that they were made with; for another, which it names, only what every compiler makes the same.
#   --profile  Prints where the M0+'s cycles go, function by function, and writes nothing.
#
# Exit status: 0 done, 1 where something differs or fails, 2 where a piece is missing that could not be installed, or for
# an argument that is not known. Tables are written at the end, all or none.
set -euo pipefail

# cargo reads .cargo/config.toml from here.
cd "$(dirname "${BASH_SOURCE[0]}")"

usage='Usage: firmware/measure.sh [--check | --profile | --help]'
mode=${1:-write}
case $mode in
    --help) echo "$usage" && exit ;;
    write | --check | --profile) [ $# -le 1 ] || { echo "$usage" >&2 && exit 2; } ;;
    *) echo "$usage" >&2 && exit 2 ;;
esac

tables=../docs/measured
targets=${CARGO_TARGET_DIR:-target}/measured
export CARGO_TARGET_DIR=$targets RUSTC_WRAPPER=$PWD/measure/rustc-anywhere
m0=thumbv6m-none-eabi
m4=thumbv7em-none-eabihf
riscv=riscv32imc-unknown-none-elf
# Each is a profile of Cargo.toml: opt-level 3 and s.
profiles=(release small)
declare -A level=([release]=3 [small]=s)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# shellcheck source=measure/pieces.sh
. measure/pieces.sh
# shellcheck source=measure/bench.sh
. measure/bench.sh
# shellcheck source=measure/flash.sh
. measure/flash.sh
# shellcheck source=measure/panel.sh
. measure/panel.sh
# shellcheck source=measure/compare.sh
. measure/compare.sh

pieces
if [ "$mode" = --profile ]; then
    for profile in "${profiles[@]}"; do
        build $m0 "$profile" bench
        node emulator/run.js --profile "$targets/$m0/$profile/bench"
    done
    exit
fi

mkdir "$work/tables"
measure_bench
measure_flash
measure_panel
measure_turn
if [ "$mode" = --check ]; then
    compare_tables
    exit
fi
mkdir -p "$tables"
cp "$work"/tables/* "$tables/"
cp "$work/demo.gif" ../docs/
