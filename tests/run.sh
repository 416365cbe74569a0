#!/usr/bin/env bash
# All tests: `bash tests/run.sh [arguments of cargo test]`. Sets up what a fresh Debian machine lacks (see setup.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
source tests/setup.sh
# Models that may not ship with the project; tests that want them say SKIPPED when they are not there.
export PARALLAX_MODELS="${PARALLAX_MODELS:-$(cd .. && pwd)/shared/scenes}"
cargo test --workspace --locked --no-fail-fast "$@"
