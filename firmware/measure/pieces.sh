# What measuring needs: part of measure.sh.

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

# Without RISC-V the other tables are measured all the same.
with_riscv=yes
no_riscv() {
    with_riscv=no
    echo "riscv.csv is not measured: $1 is missing. Needed: $2" >&2
}

pieces() {
    need node nodejs "Node.js"
    [ -d emulator/node_modules/rp2040js ] || {
        need npm npm "npm"
        (cd emulator && npm ci --silent) || missing "the emulator rp2040js" "\`(cd firmware/emulator && npm ci)\`"
    }
    [ "$mode" != --profile ] || return 0
    need qemu-system-arm qemu-system-arm "QEMU for Arm"
    command -v qemu-system-riscv32 >/dev/null || ../.ci/install qemu-system-misc || true
    if ! command -v qemu-system-riscv32 >/dev/null; then
        no_riscv 'QEMU for RISC-V' "\`apt-get install qemu-system-misc\`"
    elif ! ../.ci/thumb $riscv tree --quiet --locked --package bench --depth 0 >/dev/null 2>&1; then
        no_riscv "the Rust target $riscv" "\`rustup target add $riscv\`"
    fi
}

steps=0
# How many steps there are: builds and runs of three cores, sizes, images and their runs.
all_steps=18
step() {
    steps=$((steps + 1))
    local done=$((steps * 24 / all_steps))
    printf '[%-24s] %s\n' "$(printf '%*s' "$((done > 24 ? 24 : done))" '' | tr ' ' '#')" "$1" >&2
}

# Builds a package for a chip, with more arguments of cargo where they are given.
build() {
    local target=$1 profile=$2 package=$3 status=0
    shift 3
    step "building $package for $target at opt level ${level[$profile]}"
    ../.ci/thumb "$target" build --quiet --locked --package "$package" --profile "$profile" "$@" || status=$?
    [ "$status" != 2 ] || missing "the Rust target $target" "\`rustup target add $target\`"
    [ "$status" = 0 ] || exit 1
}
