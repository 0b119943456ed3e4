/*
 * verdict - what ncverify found, and its telling: as text, as points with colours, as a page.
 */
#ifndef CLOUDMILL_VERDICT_H
#define CLOUDMILL_VERDICT_H

#include "simulate/axis_limits.h"
#include "simulate/deviation_map.h"
#include "base/error.h"
#include "ncread/ncread.h"
#include "simulate/stock_simulate.h"

struct out;

enum { FINDING_TEXT = 240 };

/* One thing found. */
struct finding {
    bool fault;              /* it makes the program refused; else it is told only */
    char text[FINDING_TEXT]; /* with its block, without the file's name */
};

/* What one piece of the program did to the part. */
struct verdict_piece {
    float gouge, over; /* worst, mm, 0 at least */
    unsigned pass;     /* how many cuts parted by rapids came before */
};

struct verdict {
    const char *file, *control, *machine; /* as said, or told from the text */
    double radius, tolerance, left;       /* left: most material, HUGE_VAL: not judged */
    double band;                          /* as of deviation_map */
    const struct nc_motion *nc_motion;
    const struct centre_path *cut;
    const struct vec3s *point;
    struct deviation_map roll;
    struct axis_limits load;
    double rapid;        /* how deep a rapid move goes in, 0: none does */
    size_t rapid_points; /* points that rapids pass through */
    size_t rapid_at, rapid_piece;
    const struct holder_collision
        *holder;                        /* shank and holder against the part; NULL: not looked at */
    const struct stock_simulate *stock; /* what became of the stock; NULL: none was given */
    const struct holder_collision *stock_holder;
    double cell; /* of the stock, mm */
    unsigned passes;
    struct verdict_piece *piece; /* as many as the motion has */
    struct {
        size_t n, cap;
        struct finding *item;
    } finding;
};

/* Sums up the roll over each piece and finds what is wrong; all but piece and finding is given. */
void verdict_judge(struct verdict *verdict);

/* The pieces with the deepest gouges, or with most left, worst first; returns how many. */
size_t verdict_worst(const struct verdict *verdict, bool gouge, size_t most, size_t *piece);

bool verdict_refused(const struct verdict *verdict);
void verdict_free(struct verdict *verdict);

/* A table of the figures. */
void verdict_text(const struct verdict *verdict, const char *file);

/* Of it what the stock was cut by, pass by pass, and what is left. */
void verdict_stock(const struct verdict *verdict, struct out *o);

/* A PLY of all points: x y z, colour, deviation (mm), block. */
void verdict_map(const struct verdict *verdict, const char *file);

/* A page for a browser that needs nothing else. */
void verdict_page(const struct verdict *verdict, const char *file);

/* Colour of a deviation: red gouges, green is cut, blue is left; beyond the region grey. */
struct colour {
    int red, green, blue;
};
struct colour verdict_colour(const struct verdict *verdict, size_t point);

#endif
