# What a Pico's panel shows, how often a second, and the RAM that the images take: part of measure.sh.

# Two frames of each scene: the first may be sent as a whole, where its background is new, and the second is sent as all that follow.
# Its cycles are what the table says; the picture and the checksum are the first one's, as the bench's are.
frames=2

# Runs an image of the package `pico`, and compares its panel with the host. More arguments go to the comparison.
on_panel() {
    local image=$1 name=$2 landscape=$3
    shift 3
    step "the panel of $name"
    # shellcheck disable=SC2086 # no argument at all for a panel that stands upright
    node emulator/panel.js $landscape "$image" "$work/$name" "$scenes" $frames
    "$work/compare$landscape" "$work/$name" "$@" >"$work/$name.csv"
}

# The host's side of it, for one panel or the other.
comparison() {
    local landscape=$1
    # shellcheck disable=SC2086
    cargo build --quiet --locked --release --package panel ${landscape:+--features landscape}
    cp "$targets/release/panel" "$work/compare$landscape"
}

measure_panel() {
    local image picture_option=--pictures pictures=$work/tables
    if [ "$mode" = --check ]; then
        picture_option=--check-pictures pictures=$tables
    fi
    step 'building what the panel is compared with'
    comparison ''
    comparison --landscape
    scenes=$("$work/compare" --scenes)
    build $m0 release pico --features landscape
    on_panel "$targets/$m0/release/dma" dma-320x240 --landscape
    build $m0 release pico
    on_panel "$targets/$m0/release/dma" dma-240x240 '' $picture_option "$pictures"
    on_panel "$targets/$m0/release/portable" portable-240x240 ''

    {
        compiler
        echo 'panel,image,scene,left_out,cycles,fps_125mhz,crc'
        for image in dma-240x240 portable-240x240 dma-320x240; do
            LC_ALL=C awk -F, -v OFS=, -v panel="${image#*-}" -v image="${image%-*}" \
                '$2 == 0 { crc = $5 } $2 == 1 { print panel, image, $1, $3, $4, sprintf("%.1f", 125000000 / $4), crc }' \
                "$work/$image.csv"
        done
    } >"$work/tables/panel.csv"
    {
        compiler
        echo 'panel,image,strip_rows,strips,depths,list,tables,other,stack,total'
        for image in dma-240x240 portable-240x240 dma-320x240; do
            awk -F, -v OFS=, -v panel="${image#*-}" -v image="${image%-*}" \
                '{ split(panel, side, "x"); print panel, image, $2 / side[1] / 2, $0 }' "$work/$image/ram.csv"
        done
    } >"$work/tables/ram.csv"
}

# A whole turn of the first scene: as a table, and as an animation. Its first frame, which is sent as a whole, is not counted.
measure_turn() {
    step 'a turn of the demo'
    node emulator/panel.js "$targets/$m0/release/dma" "$work/turn" 1 256
    "$work/compare" "$work/turn" --gif "$work/demo.gif" >"$work/turn.csv"
    {
        compiler
        echo 'panel,image,scene,frames,cycles_mean,cycles_slowest,slowest_frame,fps_mean_133mhz,fps_slowest_133mhz'
        LC_ALL=C awk -F, -v OFS=, '
            function of(cycles) { return sprintf("%.1f", 133000000 / cycles) }
            NR > 1 && $2 > 0 { scene = $1; frames++; all += $4; if ($4 > most) { most = $4; slowest = $2 } }
            END {
                mean = sprintf("%.0f", all / frames)
                print "240x240", "dma", scene, frames, mean, most, slowest, of(mean), of(most)
            }' "$work/turn.csv"
    } >"$work/tables/turn.csv"
}
