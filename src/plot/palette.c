/* palette - see palette.h. */
#include "palette.h"

#include <stdio.h>
#include <stdlib.h>

static const char *const cycle[PALETTE_CYCLE] = {"#0072B2", "#D55E00", "#009E73",
                                                 "#CC79A7", "#E69F00", "#56B4E9"};

static const char *const height[PALETTE_HEIGHTS] = {"#440154", "#482173", "#433E85", "#38588C",
                                                    "#2D708E", "#25858E", "#1E9B8A", "#2AB07F",
                                                    "#52C569", "#86D549", "#C2DF23"};

const char *palette_cycle(size_t i)
{
    return cycle[i % PALETTE_CYCLE];
}

const char *palette_height(size_t level)
{
    return height[level < PALETTE_HEIGHTS ? level : PALETTE_HEIGHTS - 1];
}

/* Between two colours of red, green and blue. */
static void mix_colours(char colour[PALETTE_COLOUR], const unsigned dark[3],
                        const unsigned light[3], size_t level)
{
    unsigned c[3];
    for (int i = 0; i < 3; i++)
        c[i] = (dark[i] * (unsigned)(PALETTE_SHADES - 1 - level) + light[i] * (unsigned)level) /
               (PALETTE_SHADES - 1);
    snprintf(colour, PALETTE_COLOUR, "#%02X%02X%02X", c[0] & 255, c[1] & 255, c[2] & 255);
}

void palette_shade(char colour[PALETTE_COLOUR], size_t level)
{
    mix_colours(colour, (const unsigned[]){92, 104, 118}, (const unsigned[]){240, 243, 246}, level);
}

void palette_tint(char colour[PALETTE_COLOUR], size_t i, size_t level)
{
    unsigned c[3], dark[3], light[3];
    unsigned long rgb = strtoul(palette_cycle(i) + 1, NULL, 16);
    for (int k = 0; k < 3; k++) {
        c[k] = (unsigned)(rgb >> (16 - 8 * k)) & 0xFF;
        dark[k] = c[k] / 2;
        light[k] = (c[k] + 3 * 255) / 4;
    }
    mix_colours(colour, dark, light, level);
}
