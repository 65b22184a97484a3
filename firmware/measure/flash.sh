# Bytes of flash that each way to draw takes: part of measure.sh.

measure_flash() {
    local target profile
    {
        compiler
        echo 'core,opt_level,draws,topleft_bytes,image_bytes'
        for target in $m0 $m4; do
            for profile in "${profiles[@]}"; do
                build "$target" "$profile" footprint
                node emulator/flash.js "$target" "${level[$profile]}" "$targets/$target/$profile"
            done
        done
    } >"$work/tables/flash.csv"
}
