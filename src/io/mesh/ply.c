/* ply - see ply.h. */
#include "io/mesh/ply.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/parallel.h"
#include "ply_origin.h"
#include "ply_source.h"

/* What is wanted of a file: the mesh, checked, or its points as they are. */
enum ply_purpose { PLY_MESH, PLY_POINTS };

/* The properties of a vertex that a mesh has. */
enum role {
    ROLE_X,
    ROLE_Y,
    ROLE_Z,
    ROLE_NX,
    ROLE_NY,
    ROLE_NZ,
    ROLE_ROW,
    ROLE_COL,
    ROLE_KMAX,
    ROLES
};

static const char *const role_name[ROLES] = {"x", "y", "z", "nx", "ny", "nz", "row", "col", "kmax"};

/* The property of each role, -1 for none; normals and rows count only when they are complete. */
static int find_roles(const struct ply_source *s, const struct ply_element *element,
                      enum ply_purpose purpose, int property[ROLES], struct error *error)
{
    for (int i = 0; i < ROLES; i++)
        property[i] = ply_element_property(element, role_name[i]);
    for (int i = ROLE_X; i <= ROLE_Z; i++)
        if (property[i] < 0)
            return error_at(error, s->reader->name, 0,
                            "vertices have no property %s, expected x, y and z", role_name[i]);
    bool normals = property[ROLE_NX] >= 0 && property[ROLE_NY] >= 0 && property[ROLE_NZ] >= 0;
    bool rows = property[ROLE_ROW] >= 0 && property[ROLE_COL] >= 0;
    for (int i = ROLE_NX; i < ROLES; i++)
        if (purpose == PLY_POINTS || (i <= ROLE_NZ && !normals) ||
            ((i == ROLE_ROW || i == ROLE_COL) && !rows))
            property[i] = -1;
    return 0;
}

static int check_vertex(const struct ply_source *s, const int property[ROLES],
                        const double value[ROLES], struct error *error)
{
    for (int i = 0; i < ROLES; i++) {
        if (property[i] < 0)
            continue;
        if (!isfinite(value[i]))
            return ply_error(s, error, "vertex %zu has a %s that is no finite number, expected one",
                             s->row, role_name[i]);
        if ((i == ROLE_ROW || i == ROLE_COL) &&
            (value[i] != floor(value[i]) || fabs(value[i]) > INT_MAX))
            return ply_error(s, error, "vertex %zu has %s %g, expected a whole number", s->row,
                             role_name[i], value[i]);
    }
    return 0;
}

static void add_vertex(struct mesh *mesh, const int property[ROLES], const double value[ROLES])
{
    *array_push(&mesh->vertex) = vec(value[ROLE_X], value[ROLE_Y], value[ROLE_Z]);
    if (property[ROLE_NX] >= 0)
        *array_push(&mesh->normal) = vec_unit(vec(value[ROLE_NX], value[ROLE_NY], value[ROLE_NZ]));
    if (property[ROLE_ROW] >= 0) {
        *array_push(&mesh->row) = (int)value[ROLE_ROW];
        *array_push(&mesh->col) = (int)value[ROLE_COL];
    }
    if (property[ROLE_KMAX] >= 0)
        *array_push(&mesh->kmax) = value[ROLE_KMAX];
}

static int read_vertex(struct ply_source *s, const enum role *role, double value[ROLES],
                       struct error *error)
{
    for (size_t i = 0; i < s->element->property.n; i++) {
        const struct ply_property *p = &s->element->property.item[i];
        int got = role[i] == ROLES ? ply_skip(s, p, error)
                                   : ply_value(s, p->type, &value[role[i]], error);
        if (got < 0)
            return -1;
    }
    return 0;
}

enum { PLAIN_MOST = 16 }; /* numbers of a row that is read at once */

/* A row of plain numbers as read_vertex has it; 0: it is none. */
static size_t plain_vertex(const struct ply_source *s, const enum role *role, double value[ROLES])
{
    double number[PLAIN_MOST];
    size_t n = s->element->property.n, length = n <= PLAIN_MOST ? ply_row_numbers(s, n, number) : 0;

    for (size_t i = 0; i < n && length > 0; i++) {
        if (s->element->property.item[i].list)
            return 0;
        if (role[i] != ROLES)
            value[role[i]] = number[i];
    }
    return length;
}

static int next_vertex(struct ply_source *s, const enum role *role, double value[ROLES],
                       struct error *error)
{
    size_t length = plain_vertex(s, role, value);
    if (length > 0)
        ply_row_take(s, length);
    return length > 0 || (ply_row_begin(s, error) == 0 && read_vertex(s, role, value, error) == 0 &&
                          ply_row_end(s, error) == 0)
               ? 0
               : -1;
}

static int read_vertices(struct ply_source *s, enum ply_purpose purpose, struct mesh *mesh,
                         struct error *error)
{
    int property[ROLES], status = 0;
    double value[ROLES] = {0};
    if (find_roles(s, s->element, purpose, property, error) < 0)
        return -1;
    if (s->element->count > INT_MAX)
        return error_at(error, s->reader->name, 0, "%zu vertices, expected at most %d",
                        s->element->count, INT_MAX);
    enum role *role = mem_alloc(s->element->property.n, sizeof *role);
    for (size_t i = 0; i < s->element->property.n; i++)
        role[i] = ROLES;
    for (int i = 0; i < ROLES; i++)
        if (property[i] >= 0)
            role[property[i]] = (enum role)i;

    for (s->row = 0; s->row < s->element->count && status == 0; s->row++) {
        if (next_vertex(s, role, value, error) < 0 ||
            (purpose == PLY_MESH && check_vertex(s, property, value, error) < 0))
            status = -1;
        else
            add_vertex(mesh, property, value);
    }
    free(role);
    return status;
}

static int read_index(struct ply_source *s, enum ply_type type, size_t vertices, int *index,
                      struct error *error)
{
    double value;
    if (ply_value(s, type, &value, error) < 0)
        return -1;
    if (!(value >= 0 && value < (double)vertices && value == floor(value)))
        return ply_error(s, error, "face %zu has vertex index %.17g, expected 0 to %zu", s->row,
                         value, vertices - 1);
    *index = (int)value;
    return 0;
}

/* The corners of a polygon as a fan of triangles about its first corner, as they come in. */
static int read_corners(struct ply_source *s, const struct ply_property *p, struct mesh *mesh,
                        struct error *error)
{
    size_t corners;
    int first = 0, before = 0, index = 0;
    if (ply_length(s, p->length_type, &corners, error) < 0)
        return -1;
    if (corners < 3)
        return ply_error(s, error, "face %zu has %zu corners, expected 3 or more", s->row, corners);
    for (size_t i = 0; i < corners; i++) {
        if (read_index(s, p->type, mesh->vertex.n, &index, error) < 0)
            return -1;
        if (i == 0)
            first = index;
        if (i >= 2)
            *array_push(&mesh->face) = (struct face){{first, before, index}};
        before = index;
    }
    return 0;
}

/* Which surface the triangles of a face are of; the corners come before it. */
static int read_surface(struct ply_source *s, const struct ply_property *p, struct mesh *mesh,
                        struct error *error)
{
    double value, n = (double)mesh->origin.surface.n;
    if (ply_value(s, p->type, &value, error) < 0)
        return -1;
    if (!(value >= 0 && value < n && value == floor(value)))
        return ply_error(s, error, "face %zu is of surface %.17g, expected 0 to %g", s->row, value,
                         n - 1);
    while (mesh->surface.n < mesh->face.n)
        *array_push(&mesh->surface) = (int)value;
    return 0;
}

static bool is_surface(const struct ply_property *p, const struct mesh *mesh)
{
    return !p->list && mesh->origin.surface.n > 0 && strcmp(p->name, "surface") == 0;
}

static bool is_corners(const struct ply_property *p)
{
    return p->list &&
           (strcmp(p->name, "vertex_indices") == 0 || strcmp(p->name, "vertex_index") == 0);
}

/* A triangle as plain numbers, with nothing or its surface after it: its row is read. */
static bool plain_face(struct ply_source *s, struct mesh *mesh)
{
    const struct ply_property *p = s->element->property.item;
    size_t more = s->element->property.n - 1, length;
    double number[5];
    struct face face;
    if (!is_corners(p) || more > 1 || (more == 1 && !is_surface(&p[1], mesh)))
        return false;
    length = ply_row_numbers(s, 4 + more, number);
    if (length == 0 || !(number[0] >= 3 && number[0] <= 3))
        return false;
    for (int i = 0; i < 3; i++) {
        double corner = number[i + 1];
        if (!(corner >= 0 && corner < (double)mesh->vertex.n && corner == floor(corner)))
            return false;
        face.v[i] = (int)corner;
    }
    if (more == 1) {
        double surface = number[4];
        if (!(surface >= 0 && surface < (double)mesh->origin.surface.n &&
              surface == floor(surface)) ||
            mesh->surface.n < mesh->face.n)
            return false;
        *array_push(&mesh->surface) = (int)surface;
    }
    *array_push(&mesh->face) = face;
    ply_row_take(s, length);
    return true;
}

static int read_faces(struct ply_source *s, struct mesh *mesh, struct error *error)
{
    if (mesh->vertex.n == 0 && s->element->count > 0)
        return error_at(error, s->reader->name, 0,
                        "faces without vertices before them, expected "
                        "element vertex first");
    for (s->row = 0; s->row < s->element->count; s->row++) {
        if (plain_face(s, mesh))
            continue;
        if (ply_row_begin(s, error) < 0)
            return -1;
        for (size_t i = 0; i < s->element->property.n; i++) {
            const struct ply_property *p = &s->element->property.item[i];
            if ((is_corners(p)         ? read_corners(s, p, mesh, error)
                 : is_surface(p, mesh) ? read_surface(s, p, mesh, error)
                                       : ply_skip(s, p, error)) < 0)
                return -1;
        }
        if (ply_row_end(s, error) < 0)
            return -1;
    }
    return 0;
}

static int skip_rows(struct ply_source *s, struct error *error)
{
    for (s->row = 0; s->row < s->element->count; s->row++) {
        if (ply_row_begin(s, error) < 0)
            return -1;
        for (size_t i = 0; i < s->element->property.n; i++)
            if (ply_skip(s, &s->element->property.item[i], error) < 0)
                return -1;
        if (ply_row_end(s, error) < 0)
            return -1;
    }
    return 0;
}

/* Everything after the head, element by element. */
static int read_elements(struct reader *r, const struct ply_head *head, enum ply_purpose purpose,
                         struct mesh *mesh, struct error *error)
{
    struct ply_source s = {.reader = r, .format = head->format};
    for (size_t i = 0; i < head->element.n; i++) {
        int got = 0;
        s.element = &head->element.item[i];
        if (strcmp(s.element->name, "vertex") == 0)
            got = read_vertices(&s, purpose, mesh, error);
        else if (s.element->property.n == 0)
            continue; /* rows of nothing */
        else if (strcmp(s.element->name, "face") == 0 && purpose == PLY_MESH)
            got = read_faces(&s, mesh, error);
        else
            got = skip_rows(&s, error);
        if (got < 0)
            return -1;
    }
    return s.element ? ply_finish(&s, error) : 0;
}

static size_t faces_of(const struct ply_head *head)
{
    const struct ply_element *face = ply_head_element(head, "face");

    return face ? face->count : 0;
}

/* *faces: as the head says. */
static int read_all(struct reader *r, enum ply_purpose purpose, struct mesh *mesh, size_t *faces,
                    struct error *error)
{
    struct ply_head head;
    int status = ply_head_read(r, &head, &mesh->origin, error);
    *faces = status == 0 ? faces_of(&head) : 0;
    if (status == 0)
        status = read_elements(r, &head, purpose, mesh, error);
    if (status == 0 && !ply_head_element(&head, "vertex"))
        status = error_at(error, r->name, 0, "a PLY file without element vertex, expected one");
    ply_head_free(&head);
    return status;
}

int ply_read_mesh(struct reader *r, struct mesh *mesh, struct error *error)
{
    size_t faces;
    *mesh = (struct mesh){.origin = ply_origin_none()};
    int status = read_all(r, PLY_MESH, mesh, &faces, error);
    if (status == 0 && (mesh->vertex.n == 0 || mesh->face.n == 0))
        status = error_at(error, r->name, 0, "no %s, expected a mesh of triangles",
                          mesh->vertex.n ? "faces" : "vertices");
    if (status < 0)
        mesh_free(mesh);
    return status;
}

int ply_read(const char *file, struct mesh *mesh, struct error *error)
{
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    int status = ply_read_mesh(&r, mesh, error);
    reader_close(&r);
    return status;
}

int ply_read_points(struct reader *r, struct vec3s *points, size_t *faces, struct error *error)
{
    struct mesh mesh = {.vertex = *points, .origin = ply_origin_none()};
    int status = read_all(r, PLY_POINTS, &mesh, faces, error);
    *points = mesh.vertex;
    mesh.vertex = (struct vec3s){0};
    mesh_free(&mesh);
    return status;
}

bool ply_has_faces(const char *file)
{
    struct reader r;
    struct error error;
    struct ply_head head;
    struct mesh mesh = {.origin = ply_origin_none()};
    if (reader_open(&r, file, &error) < 0)
        return false;
    int status = ply_head_read(&r, &head, &mesh.origin, &error);
    bool has = status == 0 && faces_of(&head) > 0;
    ply_head_free(&head);
    mesh_free(&mesh);
    reader_close(&r);
    return has;
}

static void write_vec(struct out *out, struct vec3 v, int digits)
{
    out_num(out, v.x, digits);
    out_bytes(out, " ", 1);
    out_num(out, v.y, digits);
    out_bytes(out, " ", 1);
    out_num(out, v.z, digits);
}

static void write_properties(struct out *out, const char *type, const char *names)
{
    for (const char *p = names; *p; p += strcspn(p, " "), p += strspn(p, " "))
        out_printf(out, "property %s %.*s\n", type, (int)strcspn(p, " "), p);
}

void ply_head_write(struct out *out, const struct mesh_origin *origin,
                    const struct ply_shape *shape)
{
    out_text(out, "ply\nformat ascii 1.0\n");
    ply_origin_write(out, origin);
    out_printf(out, "element vertex %zu\n", shape->vertices);
    write_properties(out, "double", shape->normals ? "x y z nx ny nz" : "x y z");
    write_properties(out, "int", shape->rows ? "row col" : "");
    write_properties(out, "double", shape->kmax ? "kmax" : "");
    out_printf(out, "element face %zu\n", shape->faces);
    out_text(out, "property list uchar int vertex_indices\n");
    write_properties(out, "int", shape->surfaces ? "surface" : "");
    out_text(out, "end_header\n");
}

void ply_vertex_write(struct out *out, const struct ply_vertex *v, const struct ply_shape *shape)
{
    write_vec(out, v->at, 6);
    if (shape->normals) {
        out_bytes(out, " ", 1);
        write_vec(out, v->normal, 9);
    }
    if (shape->rows) {
        out_bytes(out, " ", 1);
        out_int(out, v->row);
        out_bytes(out, " ", 1);
        out_int(out, v->column);
    }
    if (shape->kmax) {
        out_bytes(out, " ", 1);
        out_num(out, v->kmax, 9);
    }
    out_bytes(out, "\n", 1);
}

void ply_face_write(struct out *out, const int corner[3], int surface,
                    const struct ply_shape *shape)
{
    out_bytes(out, "3", 1);
    for (int k = 0; k < 3; k++) {
        out_bytes(out, " ", 1);
        out_int(out, corner[k]);
    }
    if (shape->surfaces) {
        out_bytes(out, " ", 1);
        out_int(out, surface);
    }
    out_bytes(out, "\n", 1);
}

/* What is written of a mesh: its vertices, then its facets, a row each. */
struct ply_rows {
    const struct mesh *mesh;
    struct ply_shape shape;
};

static struct ply_vertex vertex_of(const struct ply_rows *rows, size_t i)
{
    const struct mesh *mesh = rows->mesh;
    struct ply_vertex v = {.at = mesh->vertex.item[i]};
    if (rows->shape.normals)
        v.normal = mesh->normal.item[i];
    if (rows->shape.rows) {
        v.row = mesh->row.item[i];
        v.column = mesh->col.item[i];
    }
    if (rows->shape.kmax)
        v.kmax = mesh->kmax.item[i];
    return v;
}

static void write_rows(struct out *out, const struct ply_rows *rows, size_t from, size_t to)
{
    const struct mesh *mesh = rows->mesh;
    size_t n = rows->shape.vertices;
    for (; from < to && from < n; from++) {
        struct ply_vertex v = vertex_of(rows, from);
        ply_vertex_write(out, &v, &rows->shape);
    }
    for (; from < to; from++)
        ply_face_write(out, mesh->face.item[from - n].v,
                       rows->shape.surfaces ? mesh->surface.item[from - n] : 0, &rows->shape);
}

enum { PART = 2048 /* rows */, PARTS = 8 };

/* Parts of the rows, each put into memory for itself. */
struct ply_parts {
    const struct ply_rows *rows;
    size_t from, to;
    struct out *memory[PARTS];
};

static void write_parts(void *context, size_t from, size_t to)
{
    const struct ply_parts *p = context;
    for (size_t k = from; k < to; k++) {
        size_t first = p->from + k * PART, end = first + PART;
        write_rows(p->memory[k], p->rows, first, end < p->to ? end : p->to);
    }
}

static void write_by_threads(struct out *out, const struct ply_rows *rows, size_t n, int threads)
{
    struct ply_parts parts = {.rows = rows};
    for (int k = 0; k < PARTS; k++)
        parts.memory[k] = out_memory();
    for (; parts.from < n; parts.from = parts.to) {
        size_t left = n - parts.from;
        parts.to = left < PART * PARTS ? n : parts.from + PART * PARTS;
        parallel_for(threads, (parts.to - parts.from + PART - 1) / PART, write_parts, &parts);
        for (int k = 0; k < PARTS; k++)
            out_join(out, parts.memory[k]);
    }
    for (int k = 0; k < PARTS; k++)
        out_close(parts.memory[k]);
}

void ply_write(struct out *out, const struct mesh *mesh, int threads)
{
    size_t n = mesh->vertex.n, rows_n = n + mesh->face.n;
    const struct ply_rows rows = {
        mesh,
        {.vertices = n,
         .faces = mesh->face.n,
         .normals = n && mesh->normal.n == n,
         .kmax = n && mesh->kmax.n == n,
         .rows = n && mesh->row.n == n && mesh->col.n == n,
         .surfaces = mesh->origin.surface.n > 1 && mesh->surface.n == mesh->face.n}};

    ply_head_write(out, &mesh->origin, &rows.shape);
    if (threads == 1 || rows_n <= PART)
        write_rows(out, &rows, 0, rows_n);
    else
        write_by_threads(out, &rows, rows_n, threads);
}
