/*
 * cl_dialect - the table of CAM systems, and those with few words of their own: Creo, SolidWorks
 * CAM and MAKINO-FF.  See cl_dialect.h.
 */
#include "cl_dialect.h"

#include <stdlib.h>
#include <string.h>

#include "curve/flatten.h"

static const double fallback_chord = 0.005; /* mm */

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const struct cl_dialect *const dialects[] = {&cl_creo, &cl_nx, &cl_catia, &cl_solidworks,
                                                    &cl_makino};

/* SolidWorks CAM: INSERT says what a tool is called: a comment, no block for the control. */
static void comment_inserts(struct path *path)
{
    for (size_t i = 0; i < path->text.n; i++)
        if (strncmp(path->text.item[i], "INSERT", 6) == 0)
            memcpy(path->text.item[i], "PPRINT", 6);
}

void cl_sniff(struct path_parse *p)
{
    for (size_t i = 0; i < sizeof dialects / sizeof *dialects; i++)
        if (dialects[i]->recognize(&p->apt)) {
            p->dialect = dialects[i];
            p->sniffed = true;
            if (p->dialect == &cl_solidworks)
                comment_inserts(p->path);
            return;
        }
}

int cl_add_curve(struct path_parse *p, struct bspline c)
{
    size_t knots = c.poles + (size_t)c.degree + 1;
    struct vec3 axis = p->axis;
    if (c.head)
        axis = vec_unit(vec_sub(c.head[c.poles - 1], c.pole[c.poles - 1]));
    struct pose end = {c.pole[c.poles - 1], axis};
    struct motion motion = motion_spline(p->at, end, &c);
    double length = motion_length(&motion), whole = c.knot[knots - 1];
    for (size_t i = 0; i < knots; i++)
        c.knot[i] *= (length > 0 ? length : 1) / whole;
    struct flat flat = {0};
    bool fine = flatten(&c, 0, axis, fallback_chord, &flat);
    struct path_spline spline = {.curve = c};
    for (size_t i = 1; fine && i < flat.point.n; i++)
        *array_push(&spline.fallback) =
            (struct pose){flat.point.item[i], c.head ? flat.axis.item[i] : axis};
    flat_free(&flat);
    if (fine && path_expect_speed(p) < 0) {
        bspline_free(&c);
        array_free(&spline.fallback);
        return -1;
    }
    if (!fine) {
        bspline_free(&c);
        array_free(&spline.fallback);
        return error_at(AT(p),
                        "found a NURBS too long or too bent for straight lines, expected a path");
    }
    path_tool_move(p);
    path_feed_inverse(p, length);
    path_add_spline(p->path, end, spline)->line = p->apt.line;
    p->at = end;
    p->last_point = end.p;
    p->axis = axis;
    return 0;
}

/* ---- Creo: $$* Pro/CLfile */
static bool recognize_creo(const struct apt *apt)
{
    return apt->comment && strncmp(apt->raw, "$$*", 3) == 0 && strstr(apt->raw, "Pro/CLfile");
}

const struct cl_dialect cl_creo = {"Creo", recognize_creo, NULL, 0};

/* ---- SolidWorks CAM: coordinates are the part's, CSYS gives the tool axis */
static bool recognize_solidworks(const struct apt *apt)
{
    return !apt->comment &&
           (strcmp(apt->word, "TRNTYP") == 0 || strncmp(apt->word, "CSI_", 4) == 0 ||
            (strcmp(apt->word, "CSYS") == 0 && apt->argument.n == 12));
}

/* CSYS/ three rows of four: the third column is the tool axis until a GOTO gives another. */
static int read_csys(struct path_parse *p)
{
    double v[12];
    if (path_numbers(p, 0, 12, v, "three rows of four") < 0)
        return -1;
    const double axis[] = {v[2], v[6], v[10]};
    return path_direction(p, axis, "a CSYS axis", &p->axis);
}

static int read_trntyp(struct path_parse *p)
{
    double v[3] = {0};
    if (!apt_is(&p->apt, 0, "WORLD"))
        return error_at(AT(p), "found TRNTYP/%.20s, expected TRNTYP/WORLD: coordinates of the part",
                        p->apt.argument.n ? p->apt.argument.item[0].text : "");
    if (p->apt.argument.n > 1 && path_numbers(p, 1, 3, v, "x, y, z") < 0)
        return -1;
    if (v[0] != 0 || v[1] != 0 || v[2] != 0)
        return error_at(AT(p), "found TRNTYP/WORLD,%g,%g,%g, expected 0,0,0", v[0], v[1], v[2]);
    return 0;
}

static int read_insert(struct path_parse *p)
{
    char *text = mem_string(p->apt.raw, strlen(p->apt.raw));
    memcpy(text, "PPRINT", 6);
    path_add_text(p->path, text);
    free(text);
    return 0;
}

static const struct path_row solidworks_rows[] = {
    {"INSERT", read_insert},
    {"CSYS", read_csys},
    {"TRNTYP", read_trntyp},
    {"CSI_SET_FLUTE_LENGTH", path_ignore},
    {"CSI_SET_EXTENSION_LENGTH", path_ignore},
};

const struct cl_dialect cl_solidworks = {"SolidWorks CAM", recognize_solidworks, solidworks_rows,
                                         sizeof solidworks_rows / sizeof *solidworks_rows};

/* ---- MAKINO-FF: sections in PPRINT, no FINI */
static bool recognize_makino(const struct apt *apt)
{
    return strcmp(apt->word, "PPRINT") == 0 && strstr(apt->raw, "MAKINO-FF");
}

/* The stream is complete when its last section has ended and none is open. */
static int read_section(struct path_parse *p)
{
    if (strstr(p->apt.raw, "BEGIN-SECTION"))
        p->depth++;
    else if (strstr(p->apt.raw, "END-SECTION") && p->depth > 0)
        p->depth--;
    const char *end = strstr(p->apt.raw, "END-SECTION");
    if (end)
        end += strlen("END-SECTION");
    p->whole = end && strncmp(end + strspn(end, " ,\t"), "PROCESS-END-PATH", 16) == 0;
    return 0;
}

static const struct path_row makino_rows[] = {{"PPRINT", read_section}};

const struct cl_dialect cl_makino = {"MAKINO-FF", recognize_makino, makino_rows, 1};
