/*
 * cl_catia - the words of CATIA V5: the tool axis by TLAXIS, arcs by INDIRV and
 *
 *   TLON,GOFWD/ (CIRCLE/ xc,yc,zc,r),ON,(LINE/ xc,yc,zc,xe,ye,ze)
 *
 * from where the tool is, in the direction of INDIRV, to the second point of the line.
 */
#include <math.h>
#include <string.h>

#include "cl_dialect.h"
#include "base/num.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const double level = 0.005; /* mm, points as high as each other */

static bool shows(const struct apt *apt)
{
    if (apt->comment)
        return strstr(apt->raw, "CATIA APT VERSION") || strncmp(apt->raw, "$$*CATIA0", 9) == 0;
    return strcmp(apt->word, "INDIRV") == 0 || strcmp(apt->word, "TLON,GOFWD") == 0;
}

static int read_indirv(struct path_parse *p)
{
    double v[3];
    return path_numbers(p, 0, 3, v, "i, j, k") < 0
               ? -1
               : path_direction(p, v, "an arc's direction", &p->tangent);
}

/* The n numbers behind `(WORD/` in the statement. */
static int numbers_in(struct path_parse *p, const char *word, size_t n, double *value)
{
    const char *s = strstr(p->apt.raw, word);
    s = s ? strchr(s, '/') : NULL;
    for (size_t i = 0; s && i < n; i++) {
        s++;
        s += strspn(s, " \t");
        if (!num_read(&s, &value[i]) || !isfinite(value[i]))
            break;
        s += strspn(s, " \t");
        if (i + 1 == n && *s == ')')
            return 0;
        if (*s != ',')
            break;
    }
    return error_at(AT(p), "found TLON,GOFWD without (%s/ and %zu numbers), expected them", word,
                    n);
}

/* The direction has few digits: an arc across the tool axis is square to it, when its points are.
 */
static void square_to_tool(struct vec3 tool, struct vec3 spoke, struct vec3 chord,
                           struct vec3 *axis)
{
    double along = vec_dot(*axis, tool);
    if (fabs(along) > 0.999 && fabs(vec_dot(spoke, tool)) < level &&
        fabs(vec_dot(chord, tool)) < level)
        *axis = vec_scale(along > 0 ? 1 : -1, tool);
}

static int read_tlon(struct path_parse *p)
{
    double c[4], l[6];
    if (numbers_in(p, "CIRCLE", 4, c) < 0 || numbers_in(p, "LINE", 6, l) < 0)
        return -1;
    if (vec_length(p->tangent) == 0)
        return error_at(AT(p), "found TLON,GOFWD without a direction, expected INDIRV before it");
    struct path_arc arc = {.centre = path_point_of(p, c), .radius = p->unit * c[3]};
    struct vec3 spoke = vec_sub(p->at.p, arc.centre);
    arc.axis = vec_unit(vec_cross(spoke, p->tangent));
    if (vec_length(vec_cross(spoke, p->tangent)) < 0.5 * vec_length(spoke))
        return error_at(AT(p), "found an arc whose direction points to its centre, expected one "
                               "along the circle");
    struct vec3 end = path_point_of(p, l + 3);
    square_to_tool(p->axis, spoke, vec_sub(end, p->at.p), &arc.axis);
    p->tangent = vec(0, 0, 0);
    if (path_begin_arc(p, arc) < 0)
        return -1;
    return path_move_to(p, (struct pose){end, p->axis});
}

static const struct path_row rows[] = {
    {"INDIRV", read_indirv},
    {"TLON,GOFWD", read_tlon},
    {"AUTOPS", path_drop}, /* the plane of an arc, which INDIRV says too */
    {"PSIS", path_drop},
};

const struct cl_dialect cl_catia = {"CATIA", shows, rows, sizeof rows / sizeof *rows};
