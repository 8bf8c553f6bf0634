#!/bin/sh
# Renders every scene of this folder, and of courses/ in it, to build/renders, with the arguments
# that the scene's comment gives, and makes a page with all of them, build/gallery/index.html;
# installs a compiler and cmake where they are missing.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"
. "$root/tests/scene_arguments.sh"
. "$root/tests/gallery.sh"

now() {
  date +%s.%N
}

# render_scene FILE: one line about it, and false where it failed. Sets `seconds`.
render_scene() {
  name=$(basename "$1" .txt)
  picture=$build/renders/$name.tga
  start=$(now)
  # The arguments are a list of words, none a pattern; files that they name go beside the picture.
  (set -f && cd "$build/renders" &&
    "$build/raytracer" -quiet -input "$1" -output "$picture" $(arguments_of "$1")) ||
    return 1
  seconds=$(echo "$start $(now)" | awk '{ printf "%.2f", $2 - $1 }')
  printf '%-32s %8s s  %s\n' "$name" "$seconds" "$picture"
}

install_missing
build_program --target raytracer
mkdir -p "$build/renders" && begin_gallery || exit 1
status=0
for scene in "$root"/scenes/*.txt "$root"/scenes/courses/*.txt; do
  [ -f "$scene" ] || continue
  if render_scene "$scene"; then
    add_to_gallery "$scene" "$seconds s"
  else
    printf '%-32s failed\n' "$(basename "$scene" .txt)"
    add_to_gallery "$scene" failed
    status=1
  fi
done
end_gallery || status=1
exit $status
