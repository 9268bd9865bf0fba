#!/usr/bin/env bash
# What is written of a version is looked at: each record that contradicts it is refused by name.
set -euo pipefail
source_dir=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@localhost GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@localhost
mkdir -p "$room/packaging" "$room/docs"
cp "$source_dir/packaging/release" "$source_dir/packaging/build_steps.sh" "$room/packaging/"
cd "$room"

# In the state of a version that may be published.
reset() {
  echo 'project(remount VERSION 3.4.5 LANGUAGES C CXX)' > CMakeLists.txt
  printf '# Changelog\n\n## 3.4.5 (2030-01-02)\n\nMore.\n\n## 3.4.4\n' > CHANGELOG.md
  printf 'cff-version: 1.2.0\nversion: 3.4.5\ndate-released: 2030-01-02\n' > CITATION.cff
  echo 'find_package(remount 3.4 REQUIRED)' > docs/library.md
}
commit() { git add -A && git commit -q --allow-empty -m "state"; }
git init -q .
reset && commit
packaging/release --records | grep -q "of version 3.4.5"

count=0
# refused WORDS: as the tree stands
refused() {
  local said
  if said=$(packaging/release --records 2>&1); then echo "taken in spite of: $1"; exit 1; fi
  if ! grep -qF -- "$1" <<<"$said"; then echo "expected '$1', it said: $said"; exit 1; fi
  count=$((count + 1))
}
# wrong FILE SCRIPT WORDS: one record changed, and committed
wrong() {
  sed -i "$2" "$1" && commit
  refused "$3"
  reset && commit
}
echo more >> CHANGELOG.md
refused "the tree is not clean"
git checkout -q .
wrong CMakeLists.txt 's/3.4.5/3.4/' "states no version"
wrong CHANGELOG.md 's/^## 3.4.5.*/## Unreleased/' 'begins with "Unreleased"'
wrong CHANGELOG.md 's/^## 3.4.5.*/## 3.4.50/' 'begins with "3.4.50"'
wrong CITATION.cff 's/3.4.5/3.4.4/' "states the version '3.4.4'"
wrong CITATION.cff '/date/d' "has no day"
wrong docs/library.md 's/3.4/3.3/' "asks for version '3.3'"
git tag v3.4.5 HEAD~1
refused "a tag of another commit"
echo "$count refused"
