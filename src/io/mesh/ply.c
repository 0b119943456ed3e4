/* ply - see ply.h. */
#include "io/mesh/ply.h"

#include <stdlib.h>
#include <string.h>

#include "ply_head.h"
#include "ply_origin.h"
#include "ply_rows.h"
#include "ply_source.h"

/* Everything behind the head, element by element. */
static int read_elements(struct reader *r, const struct ply_head *head, enum ply_purpose purpose,
                         struct mesh *mesh, struct error *error)
{
    struct ply_source s = {.reader = r, .format = head->format};
    for (size_t i = 0; i < head->element.n; i++) {
        int got = 0;
        s.element = &head->element.item[i];
        if (strcmp(s.element->name, "vertex") == 0)
            got = ply_vertices(&s, purpose, mesh, error);
        else if (s.element->property.n == 0)
            continue; /* rows of nothing */
        else if (strcmp(s.element->name, "face") == 0 && purpose == PLY_MESH)
            got = ply_faces(&s, mesh, error);
        else
            got = ply_passed_over(&s, error);
        if (got < 0)
            return -1;
    }
    return s.element ? ply_finish(&s, error) : 0;
}

static int read_all(struct reader *r, enum ply_purpose purpose, struct mesh *mesh,
                    struct error *error)
{
    struct ply_head head;
    int status = ply_head_read(r, &head, &mesh->origin, error);
    if (status == 0)
        status = read_elements(r, &head, purpose, mesh, error);
    if (status == 0 && !ply_head_element(&head, "vertex"))
        status = error_at(error, r->name, 0, "a PLY file without element vertex, expected one");
    ply_head_free(&head);
    return status;
}

int ply_read_mesh(struct reader *r, struct mesh *mesh, struct error *error)
{
    *mesh = (struct mesh){.origin = ply_origin_none()};
    int status = read_all(r, PLY_MESH, mesh, error);
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

int ply_read_points(struct reader *r, struct vec3s *points, struct error *error)
{
    struct mesh mesh = {.vertex = *points, .origin = ply_origin_none()};
    int status = read_all(r, PLY_POINTS, &mesh, error);
    *points = mesh.vertex;
    mesh.vertex = (struct vec3s){0};
    mesh_free(&mesh);
    return status;
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

void ply_write(struct out *out, const struct mesh *mesh)
{
    size_t n = mesh->vertex.n;
    bool normals = n && mesh->normal.n == n, kmax = n && mesh->kmax.n == n;
    bool rows = n && mesh->row.n == n && mesh->col.n == n;

    out_text(out, "ply\nformat ascii 1.0\n");
    ply_origin_write(out, &mesh->origin);
    out_printf(out, "element vertex %zu\n", n);
    write_properties(out, "double", normals ? "x y z nx ny nz" : "x y z");
    write_properties(out, "int", rows ? "row col" : "");
    write_properties(out, "double", kmax ? "kmax" : "");
    out_printf(out, "element face %zu\n", mesh->face.n);
    out_text(out, "property list uchar int vertex_indices\nend_header\n");

    for (size_t i = 0; i < n; i++) {
        write_vec(out, mesh->vertex.item[i], 6);
        if (normals) {
            out_bytes(out, " ", 1);
            write_vec(out, mesh->normal.item[i], 9);
        }
        if (rows) {
            out_bytes(out, " ", 1);
            out_int(out, mesh->row.item[i]);
            out_bytes(out, " ", 1);
            out_int(out, mesh->col.item[i]);
        }
        if (kmax) {
            out_bytes(out, " ", 1);
            out_num(out, mesh->kmax.item[i], 9);
        }
        out_bytes(out, "\n", 1);
    }
    for (size_t i = 0; i < mesh->face.n; i++) {
        out_bytes(out, "3", 1);
        for (int k = 0; k < 3; k++) {
            out_bytes(out, " ", 1);
            out_int(out, mesh->face.item[i].v[k]);
        }
        out_bytes(out, "\n", 1);
    }
}
