/*
 * path_options - the options that all makers of tool paths (meshnorm, planecut) share: ball, guard,
 * tool axis, feeds, links, tool.
 */
#ifndef CLOUDMILL_PATH_OPTIONS_H
#define CLOUDMILL_PATH_OPTIONS_H

#include "base/cli.h"
#include "gouge/gouge.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"
#include "stage/tool_options.h"
#include "stage/gouge_options.h"
#include "stage/mesh_region.h"
#include "stage/toolpath.h"

/* The values of the options, before cli_parse their defaults. */
struct path_options {
    double radius; /* of the ball; each tool has -r in a table of its own */
    double tilt, lead, fixed[3], to_point[3], from_point[3], circle[7];
    double smooth; /* so much higher a centre may be to run smoothly, mm; -1: by the tolerance */
    double left_share; /* percent of the points that may be left within reach */
    double scallop;    /* between the rows, mm; 0: nothing is promised of it */
    double tolerance, limit, depth, noise, play, rate, lean, turn; /* degrees, degrees/mm */
    struct region_polygons polygons; /* of --region, once they are read */
    double said_noise; /* --noise, mm; below zero: not given, and `noise` is as measured */
    struct vec3s certain, doubtful, curtain, believed; /* points of the scan of -g (guard_read.h) */
    struct vec3s facets;                               /* of meshes of -g, likewise */
    double gap; /* between guard points on facets, mm; 0: a scan's guard, or none */
    double clearance, approach, feed, plunge, spindle; /* clearance NAN: by the part */
    int layers, tool, coolant;
    double effort; /* effort.h */
    bool paper, one_way, avoid;
    bool lean_given, play_given, limit_given, fixed_given, to_given, from_given, circle_given;
    const char *partno, *machine;
    double box[6];
    bool box_given;
    const char *region;        /* file, NULL: none */
    const char *faces, *steep; /* likewise, as of mesh_region.h */
    struct tool_options body;
    struct guard_choice guard;
    bool on_surfaces;        /* those that the mesh was made from are at hand, and cut */
    bool guarded;            /* by a scan: path_options_scan */
    struct unmets unguarded; /* sharp edges that it does not know (path_options_guard) */
};

extern struct path_options path_options;
extern const struct cli_option path_option_table[]; /* for cli.more */

/* Checks the options against each other, fills in what follows from others, and gives the rule for
 * the axis.  -1: an error of usage. */
int path_options_check(struct tool_axis_options *axis, struct error *error);

/* What of the mesh is asked for (--box, --region, and of planecut --faces, --steep). */
struct mesh_region_options path_options_region(void);

/* The same of points, of which none at the border are asked for, where rows end: a region as of
 * mesh_region_of_points. */
struct region path_options_points(void);

/* Reads the scan that is to guard: that of -g, or the one that the mesh names.  -1: one of -g can't
 * be read. */
int path_options_scan(const struct mesh *mesh, struct error *error);

/*
 * What the ball is kept clear of: that scan, or the mesh sampled so finely that the ball
 * sinks in by less than SINK.  A scan is refused if most vertices are further than `near` mm from
 * it. *guard is NULL with --paper.  `edges` of the mesh, if they are known already; or NULL.
 */
int path_options_guard(const struct mesh *mesh, const struct mesh_edges *edges, double near,
                       int threads, struct gouge_check **guard, struct error *error);

/* The scallop that rows are planned for, mm: less than what is asked for by what centres are lifted
 * on the mean to run smoothly. */
double path_options_row_scallop(void);

/* Fills the rules of the toolpath but for the direction of the feed; `distance` is that of the
 * passes, mm.  -1: --clearance lies within the part. */
int path_options_rules(const struct mesh *mesh, const struct gouge_check *guard, double distance,
                       struct toolpath *t, struct error *error);

/* Before the path is made: with a tolerance all that its head says is known, and it is written to
 * `output` (NULL: standard output) while it is made.  `tool`: the maker that the ledger names for
 * what straight lines spend. */
void path_options_begin(const struct mesh *mesh, const char *tool, const char *output,
                        struct toolpath *t);

/* After it is made: writes what is left of it, or all. */
void path_options_end(const struct mesh *mesh, const char *tool, struct toolpath *t);

#endif
