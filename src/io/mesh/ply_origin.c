/* ply_origin - see ply_origin.h. */
#include "ply_origin.h"

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "math/elementary.h"
#include "base/num.h"

struct mesh_origin ply_origin_none(void)
{
    return (struct mesh_origin){.ledger = NAN};
}

/* PLY parts words by blanks; a program that writes tabs loses nothing. */
static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* The text after `key` and a blank, or NULL when the comment does not begin so; `key` may have a
 * blank itself. */
static const char *text_after(const char *comment, const char *key)
{
    for (; *key; key++, comment++)
        if (*comment != *key && !(*key == ' ' && is_blank(*comment)))
            return NULL;
    return is_blank(*comment) ? comment + 1 : NULL;
}

static int read_number(const char *key, const char *text, double *value, struct error *error)
{
    if (num_whole(text, value))
        return 0;
    return error_set(error, "comment %s with '%.40s', expected one number", key, text);
}

static int read_place(const char *text, struct mesh_origin *origin, struct error *error)
{
    for (int i = 0; i < 16; i++) {
        double *to = &origin->place.m[i / 4][i % 4];
        text += strspn(text, " \t");
        if (!num_read(&text, to) || !isfinite(*to) || !strchr(" \t", *text))
            return error_set(error, "comment place with %d numbers, expected 16", i);
    }
    if (text[strspn(text, " \t")])
        return error_set(error, "comment place followed by '%.40s', expected 16 numbers", text);
    origin->placed = true;
    return 0;
}

static int read_ledger(const char *text, struct mesh_origin *origin, struct error *error)
{
    size_t n = strcspn(text, " \t");
    if (read_number("ledger", text + n, &origin->ledger, error) < 0)
        return -1;
    free(origin->maker);
    origin->maker = mem_string(text, n);
    return 0;
}

/* The smallest concave radius and its place, or `none`; then the surface's name. */
static int read_surface(const char *text, struct mesh_origin *origin, struct error *error)
{
    struct mesh_surface s = {0};
    double *to[] = {&s.radius, &s.at.x, &s.at.y, &s.at.z};
    const char *rest = text_after(text, "none");
    for (int i = 0; i < 4 && !rest; i++) {
        text += strspn(text, " \t");
        if (!num_read(&text, to[i]) || !isfinite(*to[i]) || !is_blank(*text))
            return error_set(error, "comment surface with %d numbers, expected 4 or none", i);
    }
    rest = rest ? rest : text + 1;
    if (s.radius < 0)
        return error_set(error, "comment surface with radius %g, expected a positive one",
                         s.radius);
    s.name = mem_string(rest, strlen(rest));
    *array_push(&origin->surface) = s;
    return 0;
}

/* How many points, their hash, the name. */
static int read_scan(const char *text, struct mesh_origin *origin, struct error *error)
{
    if (scan_sources_read(&origin->scan, text, text[strcspn(text, " \t")]))
        return 0;
    return error_set(error, "comment scan with '%.40s', expected points, hash and name", text);
}

/* The stage, and what it could not keep. */
static int read_unmet(const char *text, struct mesh_origin *origin, struct error *error)
{
    size_t n = strcspn(text, " \t");
    if (n == 0 || !text[n])
        return error_set(error, "comment unmet with '%.40s', expected a stage and a text", text);
    char *stage = mem_string(text, n);
    unmets_add(&origin->unmet, stage, text + n + 1);
    free(stage);
    return 0;
}

/* The first row, along and up. */
static int read_part(const char *text, struct mesh_origin *origin, struct error *error)
{
    double value[7];
    for (int i = 0; i < 7; i++) {
        text += strspn(text, " \t");
        if (!num_read(&text, &value[i]) || !isfinite(value[i]))
            return error_set(error, "comment part with %d numbers, expected 7", i);
    }
    struct mesh_part part = {(int)fmin(fmax(value[0], 0), INT_MAX),
                             vec_unit(vec(value[1], value[2], value[3])),
                             vec_unit(vec(value[4], value[5], value[6]))};
    if (text[strspn(text, " \t")] || fabs(vec_dot(part.along, part.up)) > 1e-3 ||
        !(vec_length(part.along) > 0) || !(vec_length(part.up) > 0))
        return error_set(error, "comment part, expected a row and two perpendicular directions");
    *array_push(&origin->part) = part;
    return 0;
}

/* What a comment of another program calls the unit: `units: inch`, `unit=in`; NULL: it does not. */
static const char *unit_of(const char *comment)
{
    static const char word[] = "unit", between[] = " \t:=";
    const char *p = comment + strlen(word);

    if (strncasecmp(comment, word, strlen(word)) != 0)
        return NULL;
    p += *p == 's' || *p == 'S';
    return *p && strchr(between, *p) && p[strspn(p, between)] ? p + strspn(p, between) : NULL;
}

int ply_origin_read(struct mesh_origin *origin, const char *comment, struct error *error)
{
    const char *text;
    if ((text = text_after(comment, "cloudmill mesh"))) {
        if (strcmp(text, "1") != 0)
            return error_set(error, "mesh stream of version '%.40s', expected 1", text);
        origin->own = true;
    } else if ((text = text_after(comment, "spacing"))) {
        return read_number("spacing", text, &origin->spacing, error);
    } else if ((text = text_after(comment, "direction"))) {
        return read_number("direction", text, &origin->direction, error);
    } else if ((text = text_after(comment, "noise"))) {
        return read_number("noise", text, &origin->noise, error);
    } else if ((text = text_after(comment, "extended"))) {
        return read_number("extended", text, &origin->extended, error);
    } else if ((text = text_after(comment, "place"))) {
        return read_place(text, origin, error);
    } else if ((text = text_after(comment, "ledger"))) {
        return read_ledger(text, origin, error);
    } else if ((text = text_after(comment, "part"))) {
        return read_part(text, origin, error);
    } else if ((text = text_after(comment, "scan"))) {
        return read_scan(text, origin, error);
    } else if ((text = text_after(comment, "unmet"))) {
        return read_unmet(text, origin, error);
    } else if ((text = text_after(comment, "surface"))) {
        return read_surface(text, origin, error);
    } else if ((text = text_after(comment, "source"))) {
        free(origin->source);
        origin->source = mem_string(text, strlen(text));
    } else if (!origin->own && (text = unit_of(comment))) {
        free(origin->unit);
        origin->unit = mem_string(text, strlen(text));
    }
    return 0;
}

static void write_said(struct out *out, const char *key, double x)
{
    out_printf(out, "comment %s ", key);
    out_exact(out, x);
    out_text(out, "\n");
}

/* A file may be called anything; a line of the head may not hold a line end. */
static void write_name(struct out *out, const char *name)
{
    for (const char *p = name; *p; p++)
        out_bytes(out, (unsigned char)*p < ' ' ? "?" : p, 1);
    out_text(out, "\n");
}

static void write_surface(struct out *out, const struct mesh_surface *s)
{
    double number[] = {s->radius, s->at.x, s->at.y, s->at.z};
    out_text(out, "comment surface ");
    for (int i = 0; i < 4 && s->radius > 0; i++) {
        out_num(out, number[i], 6);
        out_text(out, " ");
    }
    if (!(s->radius > 0))
        out_text(out, "none ");
    write_name(out, s->name);
}

void ply_origin_write(struct out *out, const struct mesh_origin *origin)
{
    out_text(out, "comment cloudmill mesh 1\n");
    if (origin->spacing > 0) {
        write_said(out, "spacing", origin->spacing);
        if (isfinite(origin->direction))
            write_said(out, "direction", origin->direction);
    }
    if (origin->source) {
        out_text(out, "comment source ");
        write_name(out, origin->source);
    }
    for (size_t i = 0; i < origin->scan.n; i++) {
        const struct scan_source *s = &origin->scan.item[i];
        out_printf(out, "comment scan %" PRIu64 " %016" PRIx64 " ", s->points, s->hash);
        write_name(out, s->name);
    }
    for (size_t i = 0; i < origin->surface.n; i++)
        write_surface(out, &origin->surface.item[i]);
    for (size_t i = 0; i < origin->part.n; i++) {
        const struct mesh_part *p = &origin->part.item[i];
        const double value[] = {p->along.x, p->along.y, p->along.z, p->up.x, p->up.y, p->up.z};
        out_printf(out, "comment part %d", p->row);
        for (int k = 0; k < 6; k++) {
            out_text(out, " ");
            out_num(out, value[k], 9);
        }
        out_text(out, "\n");
    }
    if (origin->placed) {
        out_text(out, "comment place");
        for (int i = 0; i < 16; i++) {
            out_text(out, " ");
            out_exact(out, origin->place.m[i / 4][i % 4]);
        }
        out_text(out, "\n");
    }
    if (origin->extended > 0) {
        out_text(out, "comment extended ");
        out_num(out, origin->extended, 4);
        out_text(out, "\n");
    }
    if (origin->noise > 0) {
        out_text(out, "comment noise ");
        out_num(out, origin->noise, 4);
        out_text(out, "\n");
    }
    if (origin->maker && isfinite(origin->ledger)) {
        out_printf(out, "comment ledger %s ", origin->maker);
        out_num(out, ceil(origin->ledger * 1e4 - 1e-6) / 1e4, 4);
        out_text(out, "\n");
    }
    for (size_t i = 0; i < origin->unmet.n; i++) {
        out_printf(out, "comment unmet %s ", origin->unmet.item[i].stage);
        write_name(out, origin->unmet.item[i].text);
    }
}
