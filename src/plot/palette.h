/*
 * palette - the colours of pictures: distinct to readers with any colour vision, and in grey.
 *
 * Okabe and Ito's eight (Color Universal Design, 2008) for what differs in kind, viridis (van der
 * Walt and Smith, 2015) for heights.
 */
#ifndef CLOUDMILL_PALETTE_H
#define CLOUDMILL_PALETTE_H

#include <stddef.h>

enum {
    PALETTE_CYCLE = 6, /* colours for passes and streams before they begin anew */
    PALETTE_HEIGHTS = 11,
    PALETTE_SHADES = 32,
    PALETTE_COLOUR = 8 /* room for #rrggbb */
};

/* The i-th of the cycle. */
const char *palette_cycle(size_t i);

/* From the lowest, 0, to the highest, PALETTE_HEIGHTS - 1. */
const char *palette_height(size_t level);

/* A facet's grey by the light on it, 0 dark to PALETTE_SHADES - 1; or a shade of the given colour
 * of the cycle. */
void palette_shade(char colour[PALETTE_COLOUR], size_t level);
void palette_tint(char colour[PALETTE_COLOUR], size_t cycle, size_t level);

#endif
