# The command that a scene's comment gives.

# The arguments in a scene's line `# raytracer -input NAME.txt -output NAME.tga ARGUMENTS`, without
# the names of the two files.
arguments_of() {
  sed -n 's/^#[[:space:]]*raytracer[[:space:]]//p' "$1" | head -n 1 | tr -d '\r' | awk '{
    for (i = 1; i <= NF; i++) {
      if ($i ~ /^--?(input|output)$/) i++
      else printf "%s ", $i
    }
  }'
}
