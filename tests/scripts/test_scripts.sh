#!/bin/sh
# The commands of script/ from any folder: they explain themselves, refuse what they do not know, and setup needs
# neither network nor time once everything is there.
# usage: test_scripts.sh REPOSITORY
set -eu

repository=$1
cd /
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

for script in setup demo test bench format gallery; do
  "$repository/script/$script" --help | grep -q "^usage: script/$script" || fail "script/$script --help"
  [ "$script" = bench ] && continue  # hands its arguments on
  status=0
  "$repository/script/$script" --nonsense >/dev/null 2>&1 || status=$?
  [ "$status" = 2 ] || fail "script/$script --nonsense ended with $status instead of 2"
done

"$repository/script/setup" --list | grep -qx libxsimd-dev || fail "script/setup --list"
"$repository/script/setup" --minimal --list | grep -q openimageio && fail "script/setup --minimal lists OpenImageIO"

# With every package present (a dpkg-query that says so) setup asks apt for nothing.
stubs=$(mktemp -d)
trap 'rm -rf "$stubs"' EXIT
printf '#!/bin/sh\nprintf installed\n' >"$stubs/dpkg-query"
printf '#!/bin/sh\necho "apt-get $*" >>"%s/log"\n' "$stubs" >"$stubs/apt-get"
chmod +x "$stubs/dpkg-query" "$stubs/apt-get"
PATH="$stubs:$PATH" "$repository/script/setup" >/dev/null || fail "script/setup with everything installed"
[ ! -e "$stubs/log" ] || fail "script/setup called apt-get though nothing was missing: $(cat "$stubs/log")"

# With nothing present it updates the lists once and installs every package it lists; as another user through sudo.
printf '#!/bin/sh\nexit 1\n' >"$stubs/dpkg-query"
printf '#!/bin/sh\nexec "$@"\n' >"$stubs/sudo"
chmod +x "$stubs/sudo"
PATH="$stubs:$PATH" "$repository/script/setup" >/dev/null || fail "script/setup with nothing installed"
[ "$(grep -c ' update' "$stubs/log")" = 1 ] || fail "script/setup did not update the package lists once"
for package in $("$repository/script/setup" --list); do
  grep ' install .*--no-install-recommends' "$stubs/log" | tr ' ' '\n' | grep -qxF "$package" || fail "script/setup did not install $package"
done

exit "$failures"
