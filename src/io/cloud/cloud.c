/* cloud - see cloud.h. */
#include "io/cloud/cloud.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "cloud_source.h"
#include "io/mesh/ply.h"
#include "io/mesh/meshfile.h"
#include "io/mesh/stl.h"

int cloud_error(const struct cloud_source *s, struct error *error, const char *format, ...)
{
    char text[200];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return error_at(error, s->reader->name, s->reader->line, "%s", text);
}

int cloud_line(struct cloud_source *s, char **line, size_t *n, struct error *error)
{
    int got = reader_line(s->reader, line, n, error);
    if (got > 0 && memchr(*line, '\0', *n))
        return cloud_error(s, error, "a NUL byte, expected text and no binary data");
    return got;
}

int cloud_take(struct cloud_source *s, const struct cloud_row *row, struct error *error)
{
    if (row->kind == CLOUD_WORD)
        return cloud_error(s, error, "'%.*s' is no number, expected a row of x y z", row->word_n,
                           row->word);
    if (row->kind != CLOUD_POINT && row->kind != CLOUD_NOT_FINITE)
        return cloud_error(s, error, "%zu column%s in the row, expected the three of x y z",
                           row->columns, row->columns == 1 ? "" : "s");
    if (row->columns > s->count->columns)
        s->count->columns = row->columns;
    s->count->open_end = s->reader->ended ? 0 : s->reader->line;
    if (row->kind == CLOUD_POINT) {
        *array_push(s->points) = row->p;
        s->count->points++;
    } else if (s->count->not_finite++ == 0) {
        s->count->first_not_finite = s->reader->line;
    }
    return 0;
}

void cloud_take_point(struct cloud_source *s, struct vec3 p)
{
    if (!(fabs(p.x) <= CLOUD_TOO_LARGE && fabs(p.y) <= CLOUD_TOO_LARGE &&
          fabs(p.z) <= CLOUD_TOO_LARGE)) {
        s->count->not_finite++;
        return;
    }
    *array_push(s->points) = p;
    s->count->points++;
}

enum { HEAD = 4096 }; /* bytes that tell what a file is */

enum format {
    FORMAT_TEXT,
    FORMAT_PTX,
    FORMAT_OBJ,
    FORMATS_OF_TEXT, /* those before it are text throughout */
    FORMAT_PCD = FORMATS_OF_TEXT,
    FORMAT_PLY,
    FORMAT_STL,
    FORMAT_OFF,
    FORMAT_LAS
};

/* Files that begin so are known, and are no text of points. */
static const struct {
    const char *bytes;
    size_t n;
    const char *what;
} known[] = {
    {"\xFF\xFE", 2, "text in UTF-16 encoding, expected UTF-8 or ASCII"},
    {"\xFE\xFF", 2, "text in UTF-16 encoding, expected UTF-8 or ASCII"},
    {"\x1F\x8B", 2, "compressed by gzip, expected text: gunzip it first"},
    {"PK\003\004", 4, "compressed by zip, expected text: unzip it first"},
    {"BZh", 3, "compressed by bzip2, expected text: bunzip2 it first"},
    {"\xFD"
     "7zXZ",
     5, "compressed by xz, expected text: unxz it first"},
    {"\x28\xB5\x2F\xFD", 4, "compressed by zstd, expected text: unzstd it first"},
    {"ASTM-E57", 8,
     "an E57 file, expected text, PLY, PCD or LAS: convert it first, as by `pdal translate IN.e57 "
     "OUT.las` or CloudCompare"},
    {"# vtk ", 6, "a VTK file, expected points: convert it to PLY"},
    {"ISO-10303-21", 12, "a STEP file, expected points"},
};

/* IGES has 80 columns, the 73rd of the first line an S. */
static bool is_iges(const char *head, size_t n)
{
    return n >= 80 && head[72] == 'S' && strspn(head + 73, " 0") >= 6 && !memchr(head, '\n', 80);
}

/* Text in UTF-16 without its mark: every other byte of the first ones is nought. */
static bool is_utf16(const char *head, size_t n)
{
    size_t noughts[2] = {0, 0};
    if (n < 16)
        return false;
    for (size_t i = 0; i < 16; i++)
        noughts[i % 2] += head[i] == '\0';
    return (noughts[0] == 8 && noughts[1] == 0) || (noughts[1] == 8 && noughts[0] == 0);
}

/* A text has no control characters; a few odd ones are left for the line they stand in. */
static bool is_binary(const char *head, size_t n)
{
    size_t odd = 0;
    for (size_t i = 0; i < n; i++)
        odd += (unsigned char)head[i] < ' ' && !memchr("\t\n\v\f\r", head[i], 5);
    return odd > n / 16;
}

/* Refuses by name what is no text. */
static int check_text(const struct reader *r, const char *head, size_t n, struct error *error)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (n >= known[i].n && memcmp(head, known[i].bytes, known[i].n) == 0)
            return error_at(error, r->name, 0, "%s", known[i].what);
    if (is_iges(head, n))
        return error_at(error, r->name, 0, "an IGES file, expected points");
    if (is_utf16(head, n))
        return error_at(error, r->name, 0, "text in UTF-16 encoding, expected UTF-8 or ASCII");
    if (is_binary(head, n))
        return error_at(error, r->name, 0, "binary data, expected text");
    return 0;
}

/* The next line of the head that is neither empty nor a comment; false when there is none. */
static bool next_line(const char **s, const char *end, const char **line, size_t *n)
{
    while (*s < end) {
        const char *p = *s;
        while (p < end && (*p == ' ' || *p == '\t'))
            p++;
        const char *to = p;
        while (to < end && *to != '\n' && *to != '\r')
            to++;
        *line = p;
        *n = (size_t)(to - p);
        *s = to < end ? to + 1 : end;
        if (*n > 0 && *p != '#')
            return true;
    }
    return false;
}

static bool line_begins(const char *line, size_t n, const char *word)
{
    size_t length = strlen(word);
    return n >= length && memcmp(line, word, length) == 0 &&
           (n == length || line[length] == ' ' || line[length] == '\t');
}

static bool is_whole_number(const char *line, size_t n)
{
    size_t digits = 0;
    while (digits < n && line[digits] >= '0' && line[digits] <= '9')
        digits++;
    for (size_t i = digits; i < n; i++)
        if (line[i] != ' ' && line[i] != '\t')
            return false;
    return digits > 0;
}

/* All whole lines of the head are statements of an OBJ file, and one of them a vertex. */
static bool is_obj(const char *head, const char *end)
{
    const char *line;
    size_t n;
    bool vertex = false, continued = false;
    while (next_line(&head, end, &line, &n) && (head < end || !vertex)) {
        if (!continued && !cloud_obj_statement(line, n))
            return false;
        vertex = vertex || line_begins(line, n, "v");
        continued = line[n - 1] == '\\';
    }
    return vertex;
}

static enum format find_format(const struct reader *r, const char *head, size_t n)
{
    const char *end = head + n, *s = head, *line;
    size_t length;
    if (n >= 4 && memcmp(head, "LASF", 4) == 0)
        return FORMAT_LAS;
    if (stl_is_binary(r, head, n))
        return FORMAT_STL;
    if (!next_line(&s, end, &line, &length))
        return FORMAT_TEXT;
    if (line_begins(line, length, "ply"))
        return FORMAT_PLY;
    if (mesh_says_off(head, n))
        return FORMAT_OFF;
    if (stl_begins(line, length, "solid") && next_line(&s, end, &line, &length) &&
        (stl_begins(line, length, "facet") || stl_begins(line, length, "endsolid")))
        return FORMAT_STL;
    if (line_begins(line, length, "VERSION") || line_begins(line, length, "FIELDS"))
        return FORMAT_PCD;
    if (is_whole_number(line, length) && next_line(&s, end, &line, &length) &&
        is_whole_number(line, length))
        return FORMAT_PTX;
    return is_obj(head, end) ? FORMAT_OBJ : FORMAT_TEXT;
}

/* The vertices of a PLY file, those that are not finite taken out again. */
static int read_ply(struct cloud_source *s, struct error *error)
{
    size_t first = s->points->n;
    if (ply_read_points(s->reader, s->points, &s->count->facets, error) < 0)
        return -1;
    size_t end = s->points->n;
    s->points->n = first;
    for (size_t i = first; i < end; i++)
        cloud_take_point(s, s->points->item[i]);
    s->count->columns = 3;
    return 0;
}

/* The corners of a mesh's facets. */
static int read_mesh(struct cloud_source *s, struct error *error)
{
    struct mesh mesh;
    int status = mesh_read_from(s->reader, &mesh, error);
    for (size_t i = 0; status == 0 && i < mesh.vertex.n; i++)
        cloud_take_point(s, mesh.vertex.item[i]);
    s->count->facets = mesh.face.n;
    s->count->columns = 3;
    mesh_free(&mesh);
    return status;
}

size_t cloud_left_out(const struct cloud_count *count)
{
    return count->not_finite + count->not_measured + count->no_data + count->withheld;
}

/* Heights that grids are filled with where nothing was measured: of ESRI and GDAL, and of whole
 * numbers of 16 bits. */
static bool is_no_data(double z)
{
    return z < -9998 && (z == -9999 || z == -99999 || z == -32767 || z == -32768);
}

/* Of the points of this file that were not handed on. */
static void leave_no_data(struct cloud_source *s)
{
    struct vec3s *points = s->points;
    size_t kept = s->first;

    while (kept < points->n && !is_no_data(points->item[kept].z))
        kept++;
    for (size_t i = kept; i < points->n; i++) {
        if (!is_no_data(points->item[i].z))
            points->item[kept++] = points->item[i];
        else if (s->count->no_data++ == 0)
            s->count->mark = points->item[i].z;
    }
    s->count->points -= points->n - kept;
    points->n = kept;
}

static int read_source(struct cloud_source *s, struct error *error)
{
    const char *head;
    long n = reader_peek(s->reader, &head, HEAD, error);
    if (n < 0)
        return -1;
    if (n == 0)
        return error_at(error, s->reader->name, 0, "is empty, expected rows of x y z");
    enum format format = find_format(s->reader, head, (size_t)n);
    if (format < FORMATS_OF_TEXT && check_text(s->reader, head, (size_t)n, error) < 0)
        return -1;
    static int (*const read[])(struct cloud_source *, struct error *) = {
        [FORMAT_TEXT] = cloud_text_read, [FORMAT_PTX] = cloud_ptx_read,
        [FORMAT_PCD] = cloud_pcd_read,   [FORMAT_OBJ] = cloud_obj_read,
        [FORMAT_PLY] = read_ply,         [FORMAT_STL] = read_mesh,
        [FORMAT_LAS] = cloud_las_read,   [FORMAT_OFF] = read_mesh,
    };
    if (read[format](s, error) < 0)
        return -1;
    leave_no_data(s);
    if (s->count->points == 0)
        return error_at(error, s->reader->name, 0,
                        "no points (%zu rows left out), expected rows of x y z",
                        cloud_left_out(s->count));
    return 0;
}

static void take_aside(void *context)
{
    const struct cloud_source *s = context;
    s->take(s->context, s->taken->item, s->taken->n);
}

static void hand_on_all(struct cloud_source *s)
{
    leave_no_data(s);
    aside_wait(s->aside);
    struct vec3s swap = *s->taken;
    *s->taken = *s->points;
    *s->points = swap;
    s->points->n = 0;
    aside_do(s->aside, take_aside, s);
}

void cloud_hand_on(struct cloud_source *s)
{
    enum { MANY = 8192 }; /* points that are worth it, and that stay in a processor's own memory */
    if (s->take && s->points->n >= MANY)
        hand_on_all(s);
}

static int read_file(const char *file, struct cloud_source *s, struct error *error)
{
    struct reader r;
    *s->count = (struct cloud_count){0};
    if (reader_open(&r, file, error) < 0)
        return -1;
    s->reader = &r; // cppcheck-suppress autoVariables
    int status = read_source(s, error);
    s->reader = NULL;
    reader_close(&r);
    return status;
}

int cloud_read(const char *file, int threads, struct vec3s *points, struct cloud_count *count,
               struct error *error)
{
    struct cloud_source source = {
        .points = points, .first = points->n, .count = count, .threads = threads};
    return read_file(file, &source, error);
}

int cloud_read_blocks(const char *file,
                      void (*take)(void *context, const struct vec3 *point, size_t n),
                      void *context, int threads, struct cloud_count *count, struct error *error)
{
    struct vec3s points = {0}, taken = {0};
    struct cloud_source source = {.points = &points,
                                  .count = count,
                                  .threads = 1,
                                  .take = take,
                                  .context = context,
                                  .aside = aside_begin(threads),
                                  .taken = &taken};
    int status = read_file(file, &source, error);
    hand_on_all(&source);
    aside_end(source.aside);
    array_free(&points);
    array_free(&taken);
    return status;
}

double cloud_unit(const char *name)
{
    static const struct {
        const char *name;
        double mm;
    } unit[] = {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"um", 0.001}, {"inch", 25.4}, {"in", 25.4}};
    for (size_t i = 0; i < sizeof unit / sizeof *unit; i++)
        if (strcmp(name, unit[i].name) == 0)
            return unit[i].mm;
    return 0;
}
