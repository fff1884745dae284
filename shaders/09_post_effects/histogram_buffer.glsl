// How many pixels of the picture each bin has.
layout(scalar) coherent buffer BinBuffer { uint picture_bins[]; };
