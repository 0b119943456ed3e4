/* mesh_region - see mesh_region.h. */
#include "stage/mesh_region.h"

#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "base/reader.h"
#include "mesh/mesh_clip.h"
#include "mesh/mesh_outline.h"

/* Of the border of a region: so far an outline may be off it, and the border is so much wider. */
static const double COARSE = 0.5;

bool mesh_region_given(const struct mesh_region_options *options)
{
    return options->box || options->faces || options->steep || options->region;
}

/* The number that a surface has in its file: what stands behind the last colon of its name. */
static long number_of(const struct mesh_surface *surface)
{
    const char *colon = strrchr(surface->name, ':');

    return colon ? strtol(colon + 1, NULL, 10) : -1;
}

/* One number, or two joined by a hyphen; *text moves on. */
static bool read_range(const char **text, long *from, long *to)
{
    char *end;

    if (**text < '0' || **text > '9')
        return false;
    *from = *to = strtol(*text, &end, 10);
    if (*end == '-' && end[1] >= '0' && end[1] <= '9')
        *to = strtol(end + 1, &end, 10);
    *text = end;
    return *from <= *to;
}

static int mark_range(const struct mesh_surfaces *surfaces, long from, long to, bool *keep,
                      struct error *error)
{
    size_t found = 0;

    for (size_t i = 0; i < surfaces->n; i++) {
        long number = number_of(&surfaces->item[i]);
        if (number < from || number > to)
            continue;
        keep[i] = true;
        found++;
    }
    if (found > 0)
        return 0;
    return error_set(error,
                     "option --faces: found %ld, expected the number of a surface of the mesh, of "
                     "which it has %zu, from %ld to %ld",
                     from, surfaces->n, number_of(&surfaces->item[0]),
                     number_of(&surfaces->item[surfaces->n - 1]));
}

/* Ranges between commas; their surfaces are marked, if there are any yet. */
static int read_faces(const char *text, const struct mesh_surfaces *surfaces, bool *keep,
                      struct error *error)
{
    const char *p = text;

    for (bool more = true; more; p += *p == ',') {
        long from, to;
        if (!read_range(&p, &from, &to) || (*p && *p != ','))
            return error_set(error, "option --faces: found '%s', expected numbers such as 5,7-12",
                             text);
        if (surfaces && mark_range(surfaces, from, to, keep, error) != 0)
            return -1;
        more = *p == ',';
    }
    return 0;
}

static int take_faces(const char *text, const struct mesh *mesh, struct mesh *part,
                      struct error *error)
{
    const struct mesh_surfaces *surfaces = &mesh->origin.surface;
    bool *keep = mem_alloc(surfaces->n + 1, sizeof *keep);
    int status = 0;

    if (surfaces->n != 1 && mesh->surface.n != mesh->face.n)
        status = error_set(error, "option --faces: the mesh does not say which surfaces its facets "
                                  "are of, expected one of nurbs2mesh");
    if (status == 0)
        status = read_faces(text, surfaces, keep, error);
    if (status == 0 && surfaces->n > 1)
        mesh_clip_surfaces(part, keep);
    for (size_t i = 0; status == 0 && i < surfaces->n; i++) {
        const struct mesh_surface *s = &surfaces->item[i];
        if (keep[i])
            *array_push(&part->origin.surface) =
                (struct mesh_surface){mem_string(s->name, strlen(s->name)), s->radius, s->at};
    }
    free(keep);
    return status;
}

static int read_steep(const char *text, double *least, double *most, struct error *error)
{
    const char *p = text;

    if (!num_read(&p, least) || *p++ != ':' || !num_read(&p, most) || *p || !(*least >= 0) ||
        !(*least < *most) || !(*most <= 180))
        return error_set(
            error,
            "option --steep: found '%s', expected two angles within 0 and 180 degrees, "
            "such as 0:45",
            text);
    return 0;
}

static int take_steep(const char *text, struct vec3 up, struct mesh *part, struct error *error)
{
    double least = 0, most = 0;

    if (read_steep(text, &least, &most, error) != 0)
        return -1;
    mesh_clip_steep(part, up, RADIANS(least), RADIANS(most));
    return 0;
}

static int check_box(const double *box, struct error *error)
{
    for (int i = 0; i < 3; i++)
        if (!(box[i] < box[i + 3]))
            return error_set(error,
                             "option --box: found %g to %g in %c, expected the lower bound first",
                             box[i], box[i + 3], 'x' + i);
    return 0;
}

static int take_box(const double *box, struct mesh *part, struct error *error)
{
    const struct vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    if (check_box(box, error) != 0)
        return -1;
    for (int i = 0; i < 3; i++) {
        mesh_clip_plane(part, axis[i], box[i]);
        mesh_clip_plane(part, vec_scale(-1, axis[i]), -box[i + 3]);
    }
    return 0;
}

enum {
    CORNERS_MAX = 1000, /* of polygons */
    CORNERS_FEW = 200   /* of an outline, as far as one so coarse is near enough */
};

/* A polygon ends: it must be one. */
static int end_polygon(const struct reader *r, const struct region_polygons *p, struct error *error)
{
    size_t corners = p->from.n > 0 ? p->corner.n - (size_t)p->from.item[p->from.n - 1] : 3;
    if (corners >= 3)
        return 0;
    return error_at(error, r->name, r->line, "found a polygon of %zu corners, expected three",
                    corners);
}

/* A corner `x y`, with `#` before a comment, or an empty line. */
static int take_corner(const struct reader *r, const char *line, bool *open,
                       struct region_polygons *p, struct error *error)
{
    double x, y;

    line += strspn(line, " \t\r");
    if (*line == '#')
        return 0;
    if (!*line) {
        *open = false;
        return end_polygon(r, p, error);
    }
    bool read = num_read(&line, &x) && strchr(" \t,;", *line) != NULL && *line;
    line += strspn(line, " \t,;");
    if (!read || !num_read(&line, &y) || !isfinite(x) || !isfinite(y) ||
        line[strspn(line, " \t\r")])
        return error_at(error, r->name, r->line, "found no two numbers, expected a corner `x y`");
    if (p->corner.n == CORNERS_MAX)
        return error_at(error, r->name, r->line, "found more corners, expected at most %d",
                        CORNERS_MAX);
    if (!*open)
        *array_push(&p->from) = (int)p->corner.n;
    *open = true;
    *array_push(&p->corner) = vec(x, y, 0);
    return 0;
}

static int read_polygons(const char *file, struct region_polygons *p, struct error *error)
{
    struct reader r;
    bool open = false;
    char *line;
    size_t n;
    int got;

    if (reader_open(&r, file, error) < 0)
        return -1;
    while ((got = reader_line(&r, &line, &n, error)) > 0 &&
           (got = take_corner(&r, line, &open, p, error)) == 0)
        ;
    if (got == 0)
        got = end_polygon(&r, p, error);
    if (got == 0 && p->from.n == 0)
        got = error_at(error, r.name, 0, "found no polygon, expected corners `x y`");
    reader_close(&r);
    return got;
}

int mesh_region_check(const struct mesh_region_options *options, struct error *error)
{
    double least = 0, most = 0;

    if (options->box && check_box(options->box, error) != 0)
        return -1;
    if (options->faces && read_faces(options->faces, NULL, NULL, error) != 0)
        return -1;
    if (options->steep && read_steep(options->steep, &least, &most, error) != 0)
        return -1;
    if (!options->region || !options->polygons)
        return 0;
    return read_polygons(options->region, options->polygons, error);
}

/* The file is read once where what was read is kept: it may be a pipe. */
static int take_polygons(const struct mesh_region_options *options, struct mesh *part,
                         struct error *error)
{
    struct region_polygons own = {0}, *p = options->polygons ? options->polygons : &own;
    int status = p->from.n > 0 ? 0 : read_polygons(options->region, p, error);

    error->file = status != 0;
    if (status == 0) {
        const struct box box = box_around(p->corner.item, p->corner.n);
        const double bound[] = {box.low.x, box.low.y, box.high.x, box.high.y};
        for (int i = 0; i < 4; i++) { /* little is then left to be split */
            double way = i < 2 ? 1 : -1;
            mesh_clip_plane(part, i % 2 ? vec(0, way, 0) : vec(way, 0, 0), way * bound[i] - 0.01);
        }
        mesh_clip_polygons(part, p);
    }
    region_polygons_free(&own);
    return status;
}

/* Of the facets, some of which are looked at, enough are in the region with its border, and most
 * without. */
static bool holds_part(struct region region, const struct mesh *part)
{
    enum { LOOKED = 1000 };
    const double enough = 0.01, most = 0.5;
    size_t step = part->face.n / LOOKED + 1, inner = 0, held = 0, all = 0;

    for (size_t f = 0; f < part->face.n; f += step, all++) {
        const int *v = part->face.item[f].v;
        const struct vec3 *p = part->vertex.item;
        struct vec3 at = vec_scale(1.0 / 3, vec_add(vec_add(p[v[0]], p[v[1]]), p[v[2]]));
        inner += region_holds(&region, at);
        held += region_polygons_hold(&region.polygons, at);
    }
    return (double)inner >= enough * (double)all && (double)held >= most * (double)all;
}

struct region mesh_region_of_points(const struct mesh_region_options *options)
{
    const double *box = options->box;
    bool outlined = options->faces || options->steep;
    struct region region = {.boxed = box && !outlined,
                            .border = (outlined ? 1 + COARSE : 1) * options->border};

    if (region.boxed)
        region.box = (struct box){vec(box[0], box[1], box[2]), vec(box[3], box[4], box[5])};
    if (options->region || outlined)
        region.polygons = *options->polygons;
    return region;
}

/* The outline of what faces or slopes were taken of, coarser where a finer one has too many
 * corners; none where it says little. */
static void keep_outline(const struct mesh_region_options *options, const struct mesh *part)
{
    struct region_polygons *outline = options->polygons;
    const double coarsest = COARSE * options->border, narrow = 2 * options->border;

    for (double within = coarsest / 4; within <= coarsest; within *= 2) {
        region_polygons_free(outline);
        if (mesh_outline_find(part, within, narrow, outline) && outline->corner.n <= CORNERS_FEW)
            break;
    }
    struct region region = mesh_region_of_points(options);
    if (outline->corner.n > CORNERS_MAX || !holds_part(region, part))
        region_polygons_free(outline);
}

/* What is said of whole surfaces does not hold of a part of them: kmax does. */
static void forget_surfaces(struct mesh *part)
{
    for (size_t i = 0; i < part->origin.surface.n; i++)
        free(part->origin.surface.item[i].name);
    array_free(&part->origin.surface);
}

int mesh_region_take(const struct mesh_region_options *options, const struct mesh *mesh,
                     struct mesh *part, struct error *error)
{
    *part = mesh_clip_copy(mesh);
    if (options->faces && take_faces(options->faces, mesh, part, error) != 0)
        return -1;
    if (options->steep && take_steep(options->steep, options->up, part, error) != 0)
        return -1;
    if (options->box && take_box(options->box, part, error) != 0)
        return -1;
    if (options->region && take_polygons(options, part, error) != 0)
        return -1;
    if (options->steep || options->box || options->region)
        forget_surfaces(part);
    array_free(&part->surface);
    mesh_clip_unused(part);
    if ((options->faces || options->steep) && options->polygons)
        keep_outline(options, part);
    return 0;
}
