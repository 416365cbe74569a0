#!/usr/bin/env bash
# Takes each guard of tests/guards.toml out of a copy of the source and wants the test that holds it to fail, on the CPU alone:
# `bash tests/guards.sh [PART OF A NAME | TEST TARGET]`. Ends with 1 if a test stays green. Takes a minute or so for each guard.
set -euo pipefail
cd "$(dirname "$0")/.."
source_tree=$PWD
work=${PARALLAX_GUARDS_DIR:-${TMPDIR:-/tmp}/parallax-guards}
mkdir -p "$work/tree"
# Without drivers: what is tested is the CPU, and without a GPU to require.
export CARGO_TARGET_DIR="$work/target" VK_DRIVER_FILES=/dev/null VK_ICD_FILENAMES=/dev/null
unset PARALLAX_REQUIRE_GPU
python3 - "$source_tree" "$work/tree" "${1:-}" <<'PYTHON'
import pathlib, subprocess, sys, tomllib
source, tree, part = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]

def restore(name):
    """The file of the copy as it is in the source, its date that of now, so that cargo sees it."""
    path = tree / name
    path.parent.mkdir(parents=True, exist_ok=True)
    text = (source / name).read_bytes()
    if not path.exists() or path.read_bytes() != text:
        path.write_bytes(text)

for name in subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=source, capture_output=True, text=True, check=True).stdout.split("\n"):
    if name and (source / name).is_file():
        restore(name)

def test(target, name):
    """Whether it is built, and whether it passes."""
    cargo = ["cargo", "test", "-q", "--locked", "--workspace", "--test", target]
    built = subprocess.run([*cargo, "--no-run"], cwd=tree, capture_output=True, text=True)
    if built.returncode:
        return False, built.stderr
    return True, subprocess.run([*cargo, "--", "--exact", name], cwd=tree, capture_output=True, text=True)

green = []
for guard in tomllib.loads((source / "tests/guards.toml").read_text())["guard"]:
    if part not in guard["name"] and part != guard["target"]:
        continue
    path = tree / guard["file"]
    path.write_text(path.read_text().replace(guard["find"], guard["replace"], 1))
    built, run = test(guard["target"], guard["test"])
    restore(guard["file"])
    if not built:
        print(f"DOES NOT BUILD  {guard['name']}\n{run}", flush=True)
        green.append(guard["name"])
    elif "1 passed" in run.stdout or "1 failed" not in run.stdout:
        print(f"GREEN  {guard['name']}: {guard['target']}::{guard['test']}", flush=True)
        green.append(guard["name"])
    else:
        print(f"red    {guard['name']}: {guard['target']}::{guard['test']}", flush=True)
print(f"{len(green)} guards are not held: {green}" if green else "every guard is held")
sys.exit(1 if green else 0)
PYTHON
