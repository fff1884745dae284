// Tables of a planet's air alone: transmittance, and light of all orders of scattering after the first.
#pragma once
#include "10_atmosphere/air_data.h"
#include "common/app/module.h"
#include "common/base/epoch.h"
#include "common/gpu/frame.h"

namespace lightwalk {

/// For passes that include 10_atmosphere/sun_table.glsl.
class AirTables {
  public:
    /// Remakes the tables after a change of the air, of the scale of their width and height or of an exercise, or `always`;
    /// true if it did. The sun's light does not count: tables are per unit of it. `all_orders` false: the second table is
    /// not made. `owner` gives the passes their macros and the images their names.
    bool record(Frame& frame, const Module& owner, const Air& air, bool all_orders, float scale = 1.0f,
                bool always = false);

    /// State transmittance() and multiple() in the pass's reads.
    void set(Compute& pass) const;

    const Image& transmittance() const { return transmittance_; }
    const Image& multiple() const { return multiple_; }

  private:
    Image transmittance_, multiple_;
    Fingerprint made_;
    Pipeline make_transmittance_ = compute({.shader = "10_atmosphere/make_transmittance.comp"});
    Pipeline make_multiple_ = compute({.shader = "10_atmosphere/make_multiple.comp"});
};

}  // namespace lightwalk
