// How many pixels of the picture each bin has. Checks of one bin have no picture.
#ifndef NO_PICTURE
layout(scalar) coherent buffer BinBuffer { uint picture_bins[]; };
#endif
