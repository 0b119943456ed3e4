/*
 * verify - an NC program judged against the part that it was made for.  The door of the folder.
 *
 * In: the motion that a program stands for (ncread/ncread.h), the part as points, what the machine
 * may do, and what is demanded.  Out: a verdict with its figures and findings, written as text, as
 * points with colours, or as a page for a browser.
 *
 * Stages, each by formulas of simulate/simulate.h, none by code that writes programs:
 *   1. verify_part_read   the part: the points of a scan, or points on the faces of a mesh and on
 *                         trimmed surfaces;
 *   2. verify_run         the ball along the program over the part, rapid moves, flute, shank and
 *                         holder, the stock cut pass by pass, the axes; then what is wrong with
 *                         them;
 *   3. verdict_text, verdict_map, verdict_page   the verdict written.  The page's files are
 *                         src/verify/page.html, page.css and page.js; make builds them in.
 */
#ifndef CLOUDMILL_VERIFY_H
#define CLOUDMILL_VERIFY_H

#include "base/error.h"
#include "math/region.h"
#include "math/transform.h"
#include "simulate/simulate.h"

/* ---- the part and the stock */

/*
 * Appends the points of a file, as they stand in it.  A mesh (a PLY with faces, STL, OFF) or the
 * surfaces of a .igs, .iges or .nurbs file, trimmed and as triangles, are put in their `place` (to
 * mm) and give points on their faces too, so dense that a ball of `radius` rolled over them sinks
 * in between by less than VERIFY_PART_SINK, as long as that are no more than some millions;
 * *spacing is what was kept, 0 for a cloud.  Of a mesh that is piped in under no name that says so
 * the corners alone are taken, as a cloud: *corners is how many facets it has, else 0.
 */
int verify_part_read(const char *file, const struct transform *place, double radius,
                     struct vec3s *points, double *spacing, size_t *corners, struct error *error);

#define VERIFY_PART_SINK 0.0005 /* mm */

/* What the points of a scan stand for (verify_surface_find). */
struct verify_surface {
    double noise;          /* one standard deviation, mm, taken out of the points; 0: none */
    double rounded;        /* the step that their heights were rounded to, mm; 0: none */
    struct vec3s outliers; /* taken out */
    unsigned char *under;  /* of each point that is left: 1 under a roof, out of reach from above */
    double spacing;        /* of the points, mean, mm */
    struct vec3s roof;     /* points that face up with nothing of the scan below (roof.h) */
    struct vec3s curtain;  /* what hangs below its rims and goes on beyond them, and its flanks */
    struct vec3s steep;    /* places on steep flanks, between points that are far apart there */
    struct vec3s scanned;  /* the points that are left, with their noise */
    double sheets;         /* distance of scans that do not meet, mm; 0: they meet ... */
    struct vec3 sheets_at; /* ... where it is largest */
};

/*
 * The surface of n points that were read from scans: outliers are taken out, rounded heights are
 * spread (believed_unround), and where the noise is alike everywhere each point moves onto the
 * quadric through as many of its neighbours as lie about one within it; where even the fewest do
 * not, at an edge, it stays.  The points are sorted.  `noise`: of the scan, mm; below zero:
 * measured; 0: every point is believed as it is.  -1: no point, or more than can be sorted.
 * `radius`: of the ball, which its rims may keep off.
 */
int verify_surface_find(struct vec3s *point, double noise, double radius, int threads,
                        struct verify_surface *surface, struct error *error);

/* Appends places where the part may go on, unseen, between the points (cloud/judged_scan.h). */
void verify_surface_unseen(const struct verify_surface *surface, double radius, int threads,
                           struct vec3s *place);
void verify_surface_free(struct verify_surface *surface);

/*
 * Reads the stock of an option: box (around the part), box,MM (so much larger on its sides and its
 * top), box:X0,Y0,Z0,X1,Y1,Z1 (two corners), or offset,MM (the surface and so much more).
 * -1: what was found instead.
 */
int verify_stock_read(const char *text, struct stock_options *stock, struct error *error);

/* ---- the run */

/* What is judged; what it points at must outlive the verdict. */
struct verify_program {
    const char *file, *control, *machine; /* their names, for the report */
    const struct nc_motion *motion;
    const struct vec3s *part;             /* its points, mm */
    const struct verify_surface *surface; /* of a scan, what more is known; NULL: not a scan */
    const struct region *region;          /* of the part that it cuts; NULL: not known */
    double ball;                          /* the radius that its head says, mm; 0: none */
    const struct nc_motion *path;         /* that it was made from; NULL: not known */
    /* by what its head says: */
    bool contact_feed;    /* feeds are those of the contact point */
    bool of_whole;        /* it is a part of a program: what it leaves is no fault of it */
    bool guarded;         /* by this scan: it ends above all of it */
    double post, axis;    /* off the path by, mm and degrees; below zero: not said */
    double rapid;         /* way of its rapid moves, mm; 0: not said */
    bool ours;            /* of ncpost */
    double rounding;      /* that is asked for of corners at most, mm; 0: it is told alone */
    const char *made_for; /* the machine; "": not said */
    bool wet;             /* its first cut has coolant, unless the path says otherwise */
    int tool;             /* its only tool, by its head; 0: not known */
    bool calls;           /* and it is called, as its control's file does */
    bool clockwise;       /* its spindle turns so, unless the path says otherwise */
    const char *work;     /* its work offset, "": the active preset; NULL: not known */
    size_t unmet;         /* what its makers could not keep, and the first of it */
    const char *unmet_first;
};

struct verify_options {
    double radius;    /* of the ball, mm */
    double tolerance; /* deepest gouge, mm */
    double share;     /* of the points that may have more than that, 0 to 1 */
    double left;      /* most material left, mm; HUGE_VAL: not judged, ... */
    double rows;      /* of that, what its rows leave: scallop, and what their mesh is off, mm */
    double told;      /* ... but told where it is more than this, and than the tolerance */
    bool partial;     /* it cuts a part of the scan: the region known, or that it cuts, is judged */
    double band;      /* as of deviation_map, mm */
    struct tool_shape tool;            /* above the ball; no spans: the ball alone is judged */
    const struct stock_options *stock; /* NULL: none */
    double cell;                       /* of the stock, mm; 0: by its size */
    double digit;                      /* the last of lengths, where the machine has its own number
                                          of digits, in the program's unit; 0: the usual one */
    struct axis_limits limits;         /* of the machine */
    struct machine_time_options time;  /* of it; its limits are those */
    int threads;                       /* as of parallel_for */
};

enum { FINDING_TEXT = 240 };

/* One thing found. */
struct finding {
    bool fault;              /* the program is refused for it; else it is a notice */
    char text[FINDING_TEXT]; /* with its block, without the file's name */
};

/* What one piece of the program did to the part. */
struct verdict_piece {
    float gouge, over; /* worst, mm, 0 at least */
    unsigned pass;     /* number of cuts between rapid moves up to here */
};

/* A rapid move through the part. */
struct verdict_rapid {
    double depth;  /* the deepest, mm; 0: none goes in */
    size_t points; /* that rapid moves go through */
    size_t point, piece;
};

/* The deepest that the ball goes into a steep flank between its points. */
struct verdict_steep {
    double depth;  /* 0: nowhere deeper than is allowed */
    size_t places; /* that it is deeper in */
    size_t piece;
    struct vec3 at;
};

/* The points that were taken for outliers. */
struct verdict_outliers {
    size_t points, gouged; /* all; those in which the ball is deeper than the tolerance */
    double depth;          /* deepest, mm */
    struct vec3 at;
};

struct verdict {
    struct verify_program program;
    struct verify_options options;
    struct centre_path cut;
    struct deviation_map map;
    struct part_coverage coverage;
    size_t asked;  /* points that are to be cut: of the region that is known, or all */
    size_t unseen; /* of those left, points that the tool reaches only if no edge goes on there that
                      no point tells of; asked where more are left than may be, and few enough */
    double limit;  /* of what counts as left, mm */
    double noise;  /* so much more than the tolerance is allowed for noise, mm */
    struct verdict_outliers outliers;
    struct verdict_steep steep;
    struct axis_use axes;
    struct machine_time time;
    struct verdict_rapid rapid;
    struct holder_collision part_holder; /* the tool above its ball against the part */
    struct under_scan under;             /* the tool under the scan */
    bool has_stock;                      /* what follows holds */
    struct stock_simulate stock;
    double cell; /* of the stock, mm */
    unsigned passes;
    struct verdict_piece *piece; /* as many as the motion has */
    struct {
        size_t n, cap;
        struct finding *item;
    } finding;
};

/* Runs the program over the part and finds what is wrong with it. */
struct verdict verify_run(const struct verify_program *program,
                          const struct verify_options *options);
void verdict_free(struct verdict *verdict);

bool verdict_refused(const struct verdict *verdict);

/* The pieces with the deepest gouges, or with most left, worst first; returns how many. */
size_t verdict_worst(const struct verdict *verdict, bool gouge, size_t most, size_t *piece);

/* enum part_class of a point; with `partial` a point beyond the region is out of reach. */
int verdict_class_of(const struct verdict *verdict, size_t point);

/* A class in words. */
const char *verdict_class(int class);

/* ---- the verdict written; file NULL or "-": standard output */

/* A table of the figures. */
void verdict_text(const struct verdict *verdict, const char *file);

/* A PLY of all points: x y z, colour (red gouged, green cut, blue left, grey out of reach),
 * deviation (mm), block, class. */
void verdict_map(const struct verdict *verdict, const char *file);

/* A page for a browser that needs nothing else. */
void verdict_page(const struct verdict *verdict, const char *file);

#endif
