// The images of bodies: maps, slopes made of them, tables of rings.
#pragma once
#include <map>
#include <memory>

#include "17_planets/bodies.h"
#include "common/scene/image_pool.h"

namespace lightwalk {

struct BodyMaps {
    std::shared_ptr<Image> color, normals;
    std::shared_ptr<Image> night, water, clouds;  ///< of the Earth
    std::shared_ptr<Image> rings;  ///< four layers: ω and optical depth; the tables back, forward, unlit
};

/// Maps of a body, if it has them. Throws InputError if a file is missing or damaged.
BodyMaps load_maps(Gpu& gpu, ImagePool& pool, BodyId body);

/// Colours of Pluto in sRGB, RGBA, row by row from the north: no free map of it was found, so these are its published
/// regions (S. A. Stern et al., Science 350, 2015): the bright western lobe of the heart and its paler eastern one,
/// the dark belt along the equator, the yellowish north, with noise for finer detail.
std::vector<uint8_t> pluto_map(int width, int height);

/// Of one ring: ω's colour and the optical depth, from the inner to the outer edge; and the three tables of 17.ring_phase, made by
/// single scattering at a sun and a camera `elevation_rad` above the rings.
std::vector<glm::vec4> ring_strip(BodyId body, int texels);
std::vector<glm::vec4> ring_table(const std::vector<glm::vec4>& strip, int table, double elevation_rad);

/// Light of single scattering, as shaders/17_planets/single_scattering.glsl has it.
namespace scattering {
double back(double depth, double mu0, double mu);
double through(double depth, double mu0, double mu);
double more(double depth, double albedo, bool lit);
double particle_phase(double cos_phase);
}  // namespace scattering

}  // namespace lightwalk
