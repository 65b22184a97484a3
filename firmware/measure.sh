#!/usr/bin/env bash
# Measures what each way to draw costs, and writes docs/measured/rp2040.csv (cycles of a Cortex-M0+, in an emulator of the
# RP2040) and docs/measured/cortex-m4.csv (instructions of a Cortex-M4, in QEMU).
#
# Usage: firmware/measure.sh [--check | --profile]
#   --check    Compares with the committed tables instead of writing them, and fails where they differ: exactly for the
#              compiler that they were made with; for another, which it names, all but cycles and instructions.
#   --profile  Prints where the M0+'s cycles go, function by function, and writes nothing.
#
# Exit status: 0 done, 1 where something differs or fails, 2 where a piece is missing that could not be installed.
set -euo pipefail

# cargo reads .cargo/config.toml from here.
cd "$(dirname "${BASH_SOURCE[0]}")"

mode=${1:-write}
case $mode in
    write | --check | --profile) ;;
    *)
        echo "Usage: firmware/measure.sh [--check | --profile]" >&2
        exit 1
        ;;
esac

tables=../docs/measured
targets=${CARGO_TARGET_DIR:-target}
m0=thumbv6m-none-eabi
m4=thumbv7em-none-eabihf
# Each is a profile of Cargo.toml: opt-level 3 and s.
profiles=(release small)

missing() {
    echo "missing: $1. Needed: $2" >&2
    exit 2
}

# Installs a Debian package, where that is possible, or names what has to be there.
need() {
    local command=$1 package=$2 what=$3
    command -v "$command" >/dev/null || ../.ci/install "$package" || true
    command -v "$command" >/dev/null || missing "$what ($command)" "\`apt-get install $package\`"
}

build() {
    local target=$1 profile=$2 status=0
    ../.ci/thumb "$target" build --quiet --package bench --profile "$profile" || status=$?
    [ "$status" != 2 ] || missing "the Rust target $target" "\`rustup target add $target\`"
    [ "$status" = 0 ] || exit 1
}

on_m0() {
    node emulator/run.js "$@"
}

on_m4() {
    # One instruction takes 2^6 ns: what the image's clock counts on.
    qemu-system-arm -M mps2-an386 -icount shift=6,align=off,sleep=off -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$1"
}

need node nodejs "Node.js"
[ -d emulator/node_modules/rp2040js ] || {
    need npm npm "npm"
    (cd emulator && npm ci --silent) || missing "the emulator rp2040js" "\`(cd firmware/emulator && npm ci)\`"
}
[ "$mode" = --profile ] || need qemu-system-arm qemu-system-arm "QEMU for Arm"

if [ "$mode" = --profile ]; then
    for profile in "${profiles[@]}"; do
        build $m0 "$profile"
        on_m0 --profile "$targets/$m0/$profile/bench"
    done
    exit
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for profile in "${profiles[@]}"; do
    build $m0 "$profile"
    on_m0 "$targets/$m0/$profile/bench" >"$work/m0-$profile" &
    emulator=$!
    build $m4 "$profile"
    on_m4 "$targets/$m4/$profile/bench" >"$work/m4-$profile"
    wait $emulator
done
cargo run --quiet --package bench --release >"$work/host"

# What does not depend on the chip: scene, method, rows of a strip, triangles, pixels, checksum.
drawn() {
    grep -v '^#' "$1" | cut -d, -f1,2,4-6,12
}
drawn "$work/host" >"$work/expected"
for run in "$work"/m[04]-*; do
    drawn "$run" | diff "$work/expected" - >"$work/differences" || {
        echo "${run##*/} does not draw what the host draws:" >&2
        cat "$work/differences" >&2
        exit 1
    }
done

# The tables' columns, from the image's. 62.5 MHz is the bus's clock, and a pixel has 16 bits. A strip is sent while the
# next one is drawn into another buffer; a whole frame leaves room for one only, so that drawing waits for the bus.
rp2040='
    function of(cycles) { return sprintf("%.1f", 133000000 / cycles) }
    NR == 1 { print "scene,method,opt_level,strip_rows,triangles,pixels,cycles_total,cycles_vertex,cycles_setup," \
        "cycles_raster,cycles_clear,cycles_per_pixel,fps_cpu_133mhz,fps_with_bus,crc"; next }
    {
        cpu = $7 + $8 + $11
        bus = 240 * 240 * 16 / 62500000 * 133000000
        frame = $4 < 240 ? (cpu > bus ? cpu : bus) : cpu + bus
        print $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, sprintf("%.1f", $7 / $6), of(cpu), of(frame), $12
    }'
cortex_m4='
    NR == 1 { print "scene,method,opt_level,strip_rows,triangles,pixels,instructions_total,instructions_vertex," \
        "instructions_setup,instructions_raster,instructions_clear,instructions_per_pixel,crc"; next }
    { print $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, sprintf("%.1f", $7 / $6), $12 }'

table() {
    local core=$1 program=$2
    head -n 1 "$work/$core-${profiles[0]}"
    for profile in "${profiles[@]}"; do grep -v '^#' "$work/$core-$profile"; done |
        awk 'NR == 1 || !/^scene,/' | LC_ALL=C awk -F, -v OFS=, "$program"
}
table m0 "$rp2040" >"$work/rp2040.csv"
table m4 "$cortex_m4" >"$work/cortex-m4.csv"

if [ "$mode" = write ]; then
    mkdir -p "$tables"
    cp "$work/rp2040.csv" "$work/cortex-m4.csv" "$tables/"
    exit
fi

# Scene, method, opt level, rows of a strip, triangles, pixels, checksum.
same_for_any_compiler() {
    grep -v '^#' "$1" | awk -F, -v OFS=, '{ print $1, $2, $3, $4, $5, $6, $NF }'
}
failed=0
for name in rp2040.csv cortex-m4.csv; do
    [ -f "$tables/$name" ] || { echo "docs/measured/$name is missing: run firmware/measure.sh" >&2; exit 1; }
    committed=$(head -n 1 "$tables/$name")
    here=$(head -n 1 "$work/$name")
    if [ "$committed" = "$here" ]; then
        diff "$tables/$name" "$work/$name" || failed=1
    else
        echo "docs/measured/$name was made with ${committed#\# }, and this is ${here#\# }: comparing what is drawn only"
        diff <(same_for_any_compiler "$tables/$name") <(same_for_any_compiler "$work/$name") || failed=1
    fi
done
if [ $failed = 1 ]; then
    echo "docs/measured differs from what is measured here: run firmware/measure.sh" >&2
    exit 1
fi
