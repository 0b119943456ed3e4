/* verify_part - the part as points, and the stock of an option: see verify.h. */
#include "verify/verify.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/num.h"
#include "base/reader.h"
#include "io/cloud/cloud.h"
#include "io/mesh/meshfile.h"
#include "io/nurbs/surfaces.h"
#include "io/nurbs/surfaces_told.h"
#include "math/triangle_points.h"
#include "nurbs/tessellate.h"

#define MOST 4e6 /* points on the faces of a mesh */

static bool has_ending(const char *file, const char *ending)
{
    size_t n = file ? strlen(file) : 0, k = strlen(ending);
    return n > k && strcasecmp(file + n - k, ending) == 0;
}

#define CHORD 0.001 /* that triangles may be off a surface, mm */

static void densify(const struct mesh *mesh, double radius, struct vec3s *points, double *spacing)
{
    *spacing = fmax(sqrt(8 * radius * VERIFY_PART_SINK), sqrt(2 * mesh_area(mesh) / MOST));
    for (size_t i = 0; i < mesh->vertex.n; i++)
        *array_push(points) = mesh->vertex.item[i];
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct vec3 v[3];
        for (int k = 0; k < 3; k++)
            v[k] = mesh->vertex.item[mesh->face.item[i].v[k]];
        triangle_points(v, *spacing, points);
    }
}

/* What is wrong with the trimming of a surface, as who makes a mesh of it is told. */
static void tell_trimming(struct patch *patch, struct sheet *sheet, double size)
{
    const struct patches one = {.n = 1, .item = patch};
    double fine = fmax(1e-5 * size, CHORD);
    struct error why;

    if (surfaces_tell_refused(&one, sheet, SURFACES_GAP * size, &why) > 0)
        say("%s", why.text);
    surfaces_tell_trimming(&one, sheet, fine);
    surfaces_tell_gaps(&one, sheet, SURFACES_GAP * size);
}

/* The surfaces of a file, trimmed, as triangles; of their vertices and faces alone. */
static int read_surfaces(const char *file, struct mesh *mesh, struct error *error)
{
    struct patches patches = {0};
    struct surfaces_unit unit;
    int result = surfaces_read(file, 0, &patches, &unit, error);
    double size = patches_size(&patches);
    if (result == 0)
        surfaces_tell(&patches);
    for (size_t i = 0; result == 0 && i < patches.n; i++) {
        struct sheet sheet = {0};
        size_t from = mesh->vertex.n;
        tessellate(&patches.item[i], (struct tessellate_options){.tolerance = CHORD}, &sheet);
        if (sheet.too_fine)
            result = error_set(error, "%s: surface %d is too large for triangles within %g mm",
                               file, patches.item[i].entity, CHORD);
        else
            tell_trimming(&patches.item[i], &sheet, size);
        for (size_t k = 0; k < sheet.point.n; k++)
            *array_push(&mesh->vertex) = sheet.point.item[k];
        for (size_t k = 0; k < sheet.face.n; k++) {
            struct face face = sheet.face.item[k];
            for (int j = 0; j < 3; j++)
                face.v[j] += (int)from;
            *array_push(&mesh->face) = face;
        }
        sheet_free(&sheet);
    }
    patches_free(&patches);
    return result;
}

int verify_part_read(const char *file, const struct transform *place, double radius,
                     struct vec3s *points, double *spacing, size_t *corners, struct error *error)
{
    struct mesh mesh = {0};
    struct cloud_count count = {0};
    bool solid = has_ending(file, ".stl") || has_ending(file, ".off");
    bool surfaces = has_ending(file, ".igs") || has_ending(file, ".iges") ||
                    has_ending(file, ".stp") || has_ending(file, ".step") ||
                    has_ending(file, ".nurbs");
    bool once = reader_reads_once(file);
    *spacing = 0;
    *corners = 0;
    if (solid || surfaces || (once ? has_ending(file, ".ply") : mesh_is_there(file))) {
        int result = surfaces ? read_surfaces(file, &mesh, error) : mesh_read(file, &mesh, error);
        if (result == 0 && mesh.face.n == 0)
            result = error_set(error, "%s: no faces in it", file);
        if (result == 0) {
            transform_points(place, mesh.vertex.item, mesh.vertex.n);
            densify(&mesh, radius, points, spacing);
        }
        mesh_free(&mesh);
        return result;
    }
    int result = cloud_read(file, 1, points, &count, error);
    *corners = count.facets;
    return result;
}

/* ---- the stock */

#define FARTHEST 1e5 /* mm */

/* Up to 6 numbers between commas; how many, -1: something else. */
static int read_numbers(const char *s, double value[6])
{
    for (int n = 0; n < 6; s++) {
        if (!num_read(&s, &value[n]) || !(fabs(value[n]) <= FARTHEST))
            return -1;
        n++;
        if (!*s)
            return n;
        if (*s != ',')
            return -1;
    }
    return -1;
}

int verify_stock_read(const char *text, struct stock_options *stock, struct error *error)
{
    bool box = strncmp(text, "box", 3) == 0;
    const char *rest = text + (box ? 3 : strncmp(text, "offset", 6) == 0 ? 6 : 0);
    double v[6];
    int n = rest == text ? -1 : !*rest ? 0 : strchr(",:", *rest) ? read_numbers(rest + 1, v) : -1;
    *stock = (struct stock_options){.kind = box ? STOCK_AROUND : STOCK_OFFSET};
    if (box && n == 6) {
        stock->kind = STOCK_BETWEEN;
        stock->low = vec(v[0], v[1], v[2]);
        stock->high = vec(v[3], v[4], v[5]);
        if (v[0] < v[3] && v[1] < v[4] && v[2] < v[5])
            return 0;
        return error_set(error, "found `%.80s`, expected the lower corner first", text);
    }
    if (n == 1 && (v[0] > 0 || (box && v[0] == 0)))
        stock->allowance = v[0];
    else if (!(box && n == 0))
        return error_set(
            error, "found `%.80s`, expected box, box,MM, box:X0,Y0,Z0,X1,Y1,Z1 or offset,MM", text);
    return 0;
}
