# The page of all scenes, with pictures as PNG, which browsers show. To be read by scenes/render.sh.

gallery=$build/gallery
page=$gallery/index.html

# as_html: its input as text of a page.
as_html() {
  sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; s/"/\&quot;/g'
}

begin_gallery() {
  rm -rf "$gallery" && mkdir -p "$gallery" || return
  cat >"$page.new" <<'END'
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Scenes of the ray tracer</title>
<style>
 body { font: 15px/1.4 sans-serif; margin: 1.5em; color: #222; background: #f6f6f4; }
 main { display: grid; grid-template-columns: repeat(auto-fill, minmax(260px, 1fr)); gap: 1.2em; }
 article { background: #fff; border: 1px solid #ccc; padding: .8em; }
 img { height: 180px; max-width: 100%; object-fit: contain; }
 h2 { font-size: 1.05em; margin: .4em 0; } code { font-size: .8em; overflow-wrap: anywhere; }
 p { margin: .4em 0; } .failed { color: #b3261e; font-weight: bold; }
</style></head><body>
<h1>Scenes of the ray tracer</h1>
<main>
END
}

# The pictures that the run of a scene wrote, the main one first.
pictures_of() {
  (cd "$gallery" && ls "$1.png" "$1"_*.png 2>/dev/null)
}

# add_to_gallery SCENE TIME: the scene's title (its first comment), pictures, command and time,
# which is "failed" where there are no pictures.
add_to_gallery() {
  name=$(basename "$1" .txt)
  if [ "$2" != failed ]; then
    (set -f && cd "$gallery" && "$build/raytracer" -quiet -input "$1" -output "$name.png" \
      $(arguments_of "$1" | sed 's/\.tga /.png /g')) || return
  fi
  title=$(sed -n '1s/^#[[:space:]]*//p' "$1" | tr -d '\r' | as_html)
  {
    echo '<article>'
    for picture in $(pictures_of "$name"); do
      printf '<a href="%s"><img src="%s" alt="%s"></a>\n' "$picture" "$picture" "$title"
    done
    printf '<h2>%s</h2>\n<p>%s: ' "${title:-$name}" "$name"
    if [ "$2" = failed ]; then echo '<span class="failed">failed</span></p>'; else echo "$2</p>"; fi
    printf '<p><code>%s</code></p>\n</article>\n' \
      "$(sed -n 's/^#[[:space:]]*raytracer/raytracer/p' "$1" | head -n 1 | tr -d '\r' | as_html)"
  } >>"$page.new"
}

end_gallery() {
  echo '</main></body></html>' >>"$page.new" && mv "$page.new" "$page" &&
    printf '%-32s %8s    %s\n' gallery '' "$page"
}
