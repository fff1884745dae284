#!/bin/sh
# Makes the pictures of this folder: docs/images/make.sh [CHAPTERS], after ./course run. Needs ImageMagick.
# CHAPTERS: another folder of built chapters than build/chapters, from the root or as a whole path.
set -eu
cd "$(dirname "$(readlink -f "$0")")/../.."
export LIGHTWALK_ROOT="$PWD"
chapters=${1:-build/chapters}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# draw CHAPTER NAME OPTIONS...: 16 pictures' mean, where the options say nothing else.
draw() {
    chapter=$1 name=$2
    shift 2
    case " $* " in *" --samples "*) samples='' ;; *) samples='--samples 16' ;; esac
    # shellcheck disable=SC2086  # words, or none
    "$chapters/$chapter" $samples "$@" --screenshot "$work/$name.png" >/dev/null
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

# keep FILE NAME: alone, for a slider.
keep() {
    convert "$work/$2.png" -depth 8 -strip -define png:compression-level=9 "docs/images/$1.png"
}

for one in polygons.triangulate family.transform family.view_projection; do
    draw 01_obj "${one#*.}" --shot "${one%.*}" --use "solution,01.${one#*.}=exercise" --size 400x225
done
join 01_starters 3x1 triangulate transform view_projection

for method in gouraud blinn_phong_normalised; do
    draw 02_lambert_phong "$method" --shot teapot --method "$method"
    mogrify -crop 280x230+370+120 +repage "$work/$method.png"
done
keep 02_gouraud gouraud
keep 02_per_pixel blinn_phong_normalised

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

for one in normal.1 offset.1 steep.8 occlusion.8 relief.8 exact.1; do
    draw 04_surface_maps "tiles.${one%.*}" --scene assets/scenes/stone_tiles_70.json --size 640x360 \
        --method "${one%.*}" --steps "${one#*.}"
    mogrify -crop 320x180+40+20 +repage "$work/tiles.${one%.*}.png"
done
join 04_methods 3x2 tiles.normal tiles.offset tiles.steep tiles.occlusion tiles.relief tiles.exact

draw 04_surface_maps outline.loaded --shot column --mesh loaded --steps 64
draw 04_surface_maps outline.displaced --shot column
mogrify -crop 400x300+170+60 +repage "$work/outline.loaded.png" "$work/outline.displaced.png"
keep 04_outline_parallax outline.loaded
keep 04_outline_displaced outline.displaced

draw 04_surface_maps floor.renormalised --shot brushed --size 480x270 --filter renormalised --samples 1
draw 04_surface_maps floor.toksvig --shot brushed --size 480x270 --filter toksvig --samples 1
draw 04_surface_maps floor.truth --shot brushed --size 480x270 --filter renormalised --samples 256
join 04_filter 3x1 floor.renormalised floor.toksvig floor.truth

for steps in 8 32 128; do
    draw 04_surface_maps "error.$steps" --scene assets/scenes/stone_tiles_85.json --size 320x180 --show hit_error --samples 1 \
        --method occlusion --steps $steps
done
join 04_hit_error 3x1 error.8 error.32 error.128

draw 04_surface_maps slope.normal --shot normal --size 720x405
draw 04_surface_maps slope.occlusion --shot wall --size 720x405
keep 04_wall_normal slope.normal
keep 04_wall_parallax slope.occlusion

for method in none pyramid; do
    draw 08_bloom "neon.$method" --shot neon --method $method --size 480x270
done
join 08_neon 2x1 neon.none neon.pyramid

for method in separable three_pass_7tap dual_kawase pyramid; do
    draw 08_bloom "spot.$method" --source spot --show spread --cut none --shape gaussian --gain 20 --sigma_px 12 \
        --method $method --size 160x160 --samples 1
done
join 08_spots 4x1 spot.separable spot.three_pass_7tap spot.dual_kawase spot.pyramid

for method in off gaussian gather lens; do
    draw 09_post_effects "lens.$method" --shot evening --dof.method $method --dof.views 256 --dof.taps 256 --size 480x270 \
        --samples $([ $method = lens ] && echo 1 || echo 4)
done
join 09_lens 2x2 lens.off lens.gaussian lens.gather lens.lens

for tone in clamp hill agx neutral; do
    draw 09_post_effects "tone.$tone" --scene assets/scenes/forge.json --post.tone $tone --post.match on --size 480x270 \
        --post.exposure fixed --post.stops 2
done
join 09_tones 2x2 tone.clamp tone.hill tone.agx tone.neutral

for method in none preetham polynomial tables; do
    draw 10_atmosphere "sunset.$method" --shot sunset --method $method --size 480x270
done
join 10_methods 2x2 sunset.none sunset.preetham sunset.polynomial sunset.tables

for erosion in 0 0.15 0.6; do
    draw 11_fractals "worn.$erosion" --scene scenes/terrain_noon.json --size 400x225 --set terrain.erosion=$erosion \
        --set terrain.snow_line_m=900
done
join 11_worn 3x1 worn.0 worn.0.15 worn.0.6

for octaves in 3 6 9; do
    draw 11_fractals "octaves.$octaves" --scene scenes/terrain_sunset.json --size 400x225 --set terrain.most_octaves=$octaves
done
join 11_octaves 3x1 octaves.3 octaves.6 octaves.9

for method in none mlaa; do
    draw 13_mlaa "wires.$method" --shot city --method $method --samples 1
done
draw 13_mlaa wires.truth --shot city --method none --samples 64
mogrify -crop 100x70+340+150 +repage -filter point -resize 400% "$work/wires.none.png" "$work/wires.mlaa.png" "$work/wires.truth.png"
join 13_wires 3x1 wires.none wires.mlaa wires.truth

for method in lambert preintegrated separable gaussians_6; do
    draw 12_skin "nose.$method" --scene assets/scenes/portrait.json --dolly 0.45 --method $method --size 1280x720 \
        --samples 4
    mogrify -crop 300x260+400+340 +repage "$work/nose.$method.png"
done
join 12_methods 4x1 nose.lambert nose.preintegrated nose.separable nose.gaussians_6
