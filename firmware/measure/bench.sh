# Each way to draw on three cores: part of measure.sh.

on_m4() {
    # One instruction takes 2^6 ns: what the image's clock counts on.
    qemu-system-arm -M mps2-an386 -icount shift=6,align=off,sleep=off -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -kernel "$1"
}

on_riscv() {
    # One instruction takes a nanosecond, which the core's counter of instructions counts in.
    qemu-system-riscv32 -M virt -cpu rv32 -bios none -icount shift=0,align=off,sleep=off -nographic -monitor none \
        -serial none -semihosting-config enable=on,target=native -kernel "$1"
}

# What does not depend on the chip: scene, method, rows of a strip, triangles, pixels, checksum.
drawn() {
    grep -v '^#' "$1" | cut -d, -f1,2,4-6,12
}

measure_bench() {
    local profile emulator run
    for profile in "${profiles[@]}"; do
        build $m0 "$profile" bench
        node emulator/run.js "$targets/$m0/$profile/bench" >"$work/m0-$profile" &
        emulator=$!
        build $m4 "$profile" bench
        on_m4 "$targets/$m4/$profile/bench" >"$work/m4-$profile"
        if [ $with_riscv = yes ]; then
            build $riscv "$profile" bench
            on_riscv "$targets/$riscv/$profile/bench" >"$work/riscv-$profile"
        fi
        wait $emulator
    done
    step 'drawing the same on this host'
    cargo run --quiet --locked --package bench --release >"$work/host"

    drawn "$work/host" >"$work/expected"
    for run in "$work"/{m0,m4,riscv}-{release,small}; do
        [ -f "$run" ] || continue
        drawn "$run" | diff "$work/expected" - >"$work/differences" || {
            echo "${run##*/} does not draw what the host draws:" >&2
            cat "$work/differences" >&2
            exit 1
        }
    done

    table m0 "$rp2040" >"$work/tables/rp2040.csv"
    table m4 "$instructions" >"$work/tables/cortex-m4.csv"
    [ $with_riscv = no ] || table riscv "$instructions" >"$work/tables/riscv.csv"
}

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
instructions='
    NR == 1 { print "scene,method,opt_level,strip_rows,triangles,pixels,instructions_total,instructions_vertex," \
        "instructions_setup,instructions_raster,instructions_clear,instructions_per_pixel,crc"; next }
    { print $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, sprintf("%.1f", $7 / $6), $12 }'

table() {
    local core=$1 program=$2 profile
    compiler
    for profile in "${profiles[@]}"; do grep -v '^#' "$work/$core-$profile"; done |
        awk 'NR == 1 || !/^scene,/' | LC_ALL=C awk -F, -v OFS=, "$program"
}

# The first line of each table.
compiler() {
    head -n 1 "$work/m0-${profiles[0]}"
}
