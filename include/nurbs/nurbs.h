/*
 * nurbs - rational B-spline curves and surfaces of any degree: points, normals, curvatures.  The
 * door of this folder.
 *
 * In come trimmed surfaces (nurbs/patch.h; io/nurbs reads them from files), out goes one mesh with
 * exact normals and curvatures.  The stages, each with a header of its own:
 *
 *   evaluation    here
 *   isolines      where the grid of a surface has its lines (Filip, Magedson and Markot 1986)
 *   trimming      curves as polygons in the parameters (trim_loops), and the grid cut along them
 *                 (trim_grid; Weiler and Atherton 1977, Sutherland and Hodgman 1974)
 *   tessellation  a surface as triangles, to a tolerance or a count (nurbs/tessellate.h)
 *   sewing        boundaries of neighbours made one (nurbs/patch_mesh.h, nurbs/sew.h)
 *   orientation   all surfaces turned to one side, the outside out (nurbs/orient.h)
 *
 * Surfaces fitted to points come from height_fit.h and height_knots.h (least squares) and
 * net_patches.h (Ferguson, Bezier).
 *
 * Beside them: curves and surfaces of other kinds as NURBS (nurbs/construct.h), the smallest
 * concave radius (nurbs/concave_radius.h), and contact points moved from the mesh onto the surfaces
 * (nurbs/project.h).
 *
 * The formulas are those of Piegl and Tiller, The NURBS Book: basis functions eq 2.5, their
 * derivatives eq 2.7, rational derivatives eq 4.20, and of do Carmo, Differential Geometry of
 * Curves and Surfaces, 3-3, for the curvatures.  Knots need not be clamped; weights are positive.
 */
#ifndef CLOUDMILL_NURBS_H
#define CLOUDMILL_NURBS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "math/uv.h"
#include "math/vec.h"

enum { NURBS_DEGREE_MAX = 25 };

/* Knots, weights and coordinates beyond this are refused by readers: squares would overflow. */
#define NURBS_LARGEST 1e100

/* One parameter: poles + degree + 1 knots, and the range that is used, within
 * knot[degree]..knot[poles]. */
struct nurbs_axis {
    int degree;
    size_t poles;
    double *knot;
    double from, to;
};

/* A pole in homogeneous coordinates: multiplied by its weight. */
struct nurbs_pole {
    double wx, wy, wz, w;
};

struct nurbs_curve {
    struct nurbs_axis t;
    struct nurbs_pole *pole;
};

/* Pole (i, j) is pole[j * u.poles + i]: u runs fastest, as in IGES. */
struct nurbs {
    struct nurbs_axis u, v;
    struct nurbs_pole *pole;
};

/* Point, unit normal along dS/du x dS/dv, and principal curvatures k1 >= k2 in 1/mm, positive
 * where the surface is concave seen from the side that the normal points to. */
struct nurbs_place {
    struct vec3 point, normal;
    double k1, k2;
};

/* -1 with a message that says what is wrong with the knots, the degree or the range (`name`: u, v
 * or t), 0 when they are sound.  A range beyond the knots is cut to them. */
int nurbs_axis_check(struct nurbs_axis *axis, const char *name, struct error *error);

/* The knots inside the range where the surface may have a kink: those repeated as often as the
 * degree.  Writes up to `most` of them to `at`; returns how many there are. */
size_t nurbs_axis_breaks(const struct nurbs_axis *axis, double *at, size_t most);

/* At the end of the range, and beyond, the span before it is evaluated: a range that ends on a kink
 * belongs to one side of it. */
struct vec3 nurbs_point(const struct nurbs *s, struct uv at);

/* d[k][l] is the derivative k times to u and l times to v; k + l <= order <= 2. */
void nurbs_derivatives(const struct nurbs *s, struct uv at, int order, struct vec3 d[3][3]);

/* Where dS/du x dS/dv vanishes (a pole, a degenerate edge) the normal is the limit from inside the
 * range and the curvatures are those a little way inside; never NaN.  Where there is no limit (all
 * poles in one place or on one line) the normal is (0, 0, 0). */
struct nurbs_place nurbs_place(const struct nurbs *s, struct uv at);

/* The normal alone, of the derivatives up to the second order there. */
struct vec3 nurbs_normal(const struct nurbs *s, struct uv at, struct vec3 d[3][3]);

/* The foot point of q near `at`, within the range (Gauss-Newton). */
struct uv nurbs_foot(const struct nurbs *s, struct vec3 q, struct uv at);

struct vec3 nurbs_curve_point(const struct nurbs_curve *c, double t);

/* Its derivative, at a knot that of the span after it. */
struct vec3 nurbs_curve_derivative(const struct nurbs_curve *c, double t);

/* The same before the division by the weight. */
struct nurbs_pole nurbs_curve_pole(const struct nurbs_curve *c, double t);

/* The basis functions that are not zero at t: degree + 1 values; returns the first pole's number.
 */
size_t nurbs_basis(const struct nurbs_axis *axis, double t, double *value);

/* The parameter of the point of the curve nearest to q, within its range. */
double nurbs_curve_foot(const struct nurbs_curve *c, struct vec3 q);

/* Turns the curve round: it runs over the same range the other way. */
void nurbs_curve_reverse(struct nurbs_curve *c);

void nurbs_free(struct nurbs *s);
void nurbs_curve_free(struct nurbs_curve *c);

#endif
