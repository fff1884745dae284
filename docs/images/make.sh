#!/bin/sh
# Makes the pictures of this folder: docs/images/make.sh, after ./course run. Needs ImageMagick.
# LIGHTWALK_CHAPTERS names another folder of built chapters than build/chapters.
set -eu
cd "$(dirname "$(readlink -f "$0")")/../.."
export LIGHTWALK_ROOT="$PWD"
chapters=${LIGHTWALK_CHAPTERS:-build/chapters}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# draw CHAPTER NAME OPTIONS...
draw() {
    chapter=$1 name=$2
    shift 2
    "$chapters/$chapter" "$@" --screenshot "$work/$name.png" >/dev/null
}

# join FILE TILES NAMES...: side by side, with a gap of 4 pixels.
join() {
    file=$1 tiles=$2
    shift 2
    pictures=''
    for name in "$@"; do pictures="$pictures $work/$name.png"; done
    # shellcheck disable=SC2086  # a list of words
    montage $pictures -tile "$tiles" -geometry +2+2 -background white -depth 8 -strip \
        -define png:compression-level=9 "docs/images/$file.png"
}

for one in polygons.triangulate family.transform family.view_projection; do
    draw 01_obj "${one#*.}" --shot "${one%.*}" --use "solution,01.${one#*.}=exercise" --size 400x225
done
join 01_starters 3x1 triangulate transform view_projection

for method in gouraud blinn_phong_normalised; do
    draw 02_lambert_phong "$method" --shot teapot --method "$method"
    mogrify -crop 280x230+400+140 +repage "$work/$method.png"
done
join 02_gouraud 2x1 gouraud blinn_phong_normalised

for method in blinn_phong blinn_phong_normalised; do
    for n in 10 80 640; do
        draw 02_lambert_phong "$method.$n" --scene docs/images/sphere.json --size 240x240 --method $method --shininess $n
    done
done
join 02_normalisation 3x2 blinn_phong.10 blinn_phong.80 blinn_phong.640 \
    blinn_phong_normalised.10 blinn_phong_normalised.80 blinn_phong_normalised.640

for method in phong blinn_phong blinn_phong_normalised; do
    draw 02_lambert_phong "rim.$method" --scene docs/images/sphere_rim.json --size 240x240 --method $method \
        --shininess 12
done
join 02_seam 3x1 rim.phong rim.blinn_phong rim.blinn_phong_normalised

for method in phong blinn_phong gouraud; do
    draw 02_lambert_phong "floor.$method" --scene docs/images/floor.json --size 320x180 --method $method
done
join 02_floor 3x1 floor.phong floor.blinn_phong floor.gouraud

for falloff in range_fade inverse_square_window inverse_square; do
    draw 03_attenuation "lamp.$falloff" --scene docs/images/lamp.json --size 400x225 --falloff $falloff
done
join 03_falloffs 3x1 lamp.range_fade lamp.inverse_square_window lamp.inverse_square

for method in tiled clustered every_light; do
    draw 03_attenuation "field.$method" --scene assets/scenes/field.json --lights 300 --size 400x225 \
        --falloff inverse_square --threshold 0.256 --method $method
done
join 03_threshold 3x1 field.tiled field.clustered field.every_light
