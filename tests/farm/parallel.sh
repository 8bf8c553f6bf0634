#!/bin/sh
# Renders tiles with GNU parallel, one of which fails at first, and compares the merged picture with
# a single run. parallel.sh PROGRAM; ends with status 77 where GNU parallel is not installed.
program=${1:?the program}
scenes=$(CDPATH= cd -- "$(dirname -- "$0")/../../scenes" && pwd) || exit 1

if ! parallel --version 2>/dev/null </dev/null | grep -q '^GNU parallel'; then
  echo 'skipped: GNU parallel is not installed (Debian: apt-get install parallel)'
  exit 77
fi
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# The program, but that tile 5 fails the first time.
cat >raytracer <<END
#!/bin/sh
case "\$*" in
  *'-tile 5 12'*) [ -e failed ] || { : >failed && exit 1; } ;;
esac
exec '$program' "\$@"
END
chmod +x raytracer
PATH=$work:$PATH
cp "$scenes"/*.obj .
cp "$scenes/06_mirror_balls.txt" scene.txt
mkdir parts

# The recipe of README.txt.
parallel --retries 3 --joblog tiles.log \
  raytracer -input scene.txt -size 120 90 -bounces 8 -threads 1 \
  -tile {} 12 -output parts/{}.tga ::: $(seq 12) &&
  raytracer -merge out.tga parts/*.tga || { echo 'failed: the recipe'; exit 1; }

"$program" -input scene.txt -size 120 90 -bounces 8 -output whole.tga || exit 1
[ -e failed ] || { echo 'failed: no tile had to be tried again'; exit 1; }
cmp out.tga whole.tga || exit 1
echo 'GNU parallel: 12 tiles, one tried again; the merged picture is that of a single run'
