# Sourced by `tests/run.sh`: finds, or installs where that is allowed, what the tests need beyond Rust, and sets the variables by which
# the tests find it. Prints what it did; where it may not install it prints what to do and goes on, and the tests then say SKIPPED.

cache="${XDG_CACHE_HOME:-$HOME/.cache}/parallax"

# Runs a command as root if that is possible without a password.
as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; elif sudo -n true 2>/dev/null; then sudo "$@"; else return 1; fi
}

# install_package NAME WHY
install_package() {
    if ! command -v apt-get >/dev/null; then
        echo "set-up: $2 is missing. Install the counterpart of Debian's package $1."
        return 1
    fi
    [ -n "${apt_updated:-}" ] || { as_root apt-get update -qq && apt_updated=1; } || {
        echo "set-up: $2 is missing and this user may not install it. Run: sudo apt-get install $1"
        return 1
    }
    echo "set-up: installing $1 ($2)"
    as_root apt-get install -y -qq "$1" >/dev/null
}

lavapipe_icd() {
    local icd
    for icd in /usr/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/lvp_icd*.json; do
        [ -f "$icd" ] && echo "$icd" && return
    done
    true
}

# The second driver: the library inside Debian's chromium-common, unpacked and not installed.
fetch_swiftshader() {
    [ -f "$cache/swiftshader/vk_swiftshader_icd.json" ] && return 0
    command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null || {
        echo "set-up: no SwiftShader. Set PARALLAX_SWIFTSHADER to its vk_swiftshader_icd.json."
        return 1
    }
    local work
    work=$(mktemp -d)
    echo "set-up: unpacking SwiftShader from Debian's chromium-common"
    (cd "$work" && { apt-get download -qq chromium-common 2>/dev/null || { as_root apt-get update -qq && apt-get download -qq chromium-common; }; } &&
        dpkg-deb -x chromium-common_*.deb . &&
        mkdir -p "$cache/swiftshader" &&
        cp usr/lib/chromium/libvk_swiftshader.so usr/lib/chromium/vk_swiftshader_icd.json "$cache/swiftshader/") ||
        echo "set-up: SwiftShader could not be fetched; set PARALLAX_SWIFTSHADER to its vk_swiftshader_icd.json."
    rm -rf "$work"
    [ -f "$cache/swiftshader/vk_swiftshader_icd.json" ]
}

# What cannot be installed has been told; the tests say what they skip for it.
command -v cc >/dev/null || install_package gcc "a linker" || true
command -v spirv-val >/dev/null || install_package spirv-tools "spirv-val" || true
command -v objdump >/dev/null || install_package binutils "objdump" || true
command -v valgrind >/dev/null || install_package valgrind "callgrind" || true
ldconfig -p 2>/dev/null | grep libvulkan.so.1 >/dev/null || install_package libvulkan1 "the Vulkan loader" || true
[ -n "$(lavapipe_icd)" ] || install_package mesa-vulkan-drivers "lavapipe" || true

if [ -z "${PARALLAX_SWIFTSHADER:-}" ] && fetch_swiftshader; then
    export PARALLAX_SWIFTSHADER="$cache/swiftshader/vk_swiftshader_icd.json"
fi

# Both software drivers, and only they, so that every machine tests the same; set the variable yourself to test a driver of your own.
if [ -z "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ]; then
    drivers=$(lavapipe_icd)
    if [ -n "${PARALLAX_SWIFTSHADER:-}" ]; then
        drivers="${drivers:+$drivers:}$PARALLAX_SWIFTSHADER"
    fi
    if [ -n "$drivers" ]; then
        export VK_DRIVER_FILES="$drivers" VK_ICD_FILENAMES="$drivers"
    fi
fi

# Mesa's layer that asks a compositor which device it prefers complains where there is no compositor.
export NODEVICE_SELECT=1
