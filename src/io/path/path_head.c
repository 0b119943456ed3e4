/* path_head - the head of a path, and comments that carry data; see path_parse.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cl_dialect.h"
#include "gouge/holder_text.h"
#include "math/elementary.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static int read_partno(struct path_parse *p)
{
    const char *text = p->apt.raw + strlen("PARTNO");
    text += strspn(text, " \t/");
    if (p->path->head.partno)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.partno = mem_string(text, strlen(text));
    return 0;
}

/* -1: the unit is another than the one that was asked for. */
static int set_unit(struct path_parse *p, double unit)
{
    if (p->unit_asked && p->unit != unit)
        return error_at(AT(p), "found UNITS/%.20s, expected %s, as asked for",
                        p->apt.argument.item[0].text, p->unit > 1 ? "INCHES" : "MM");
    p->unit = unit;
    p->unit_said = true;
    p->unit_line = p->apt.line;
    return path_unit_agrees(p);
}

static int read_units(struct path_parse *p)
{
    if (apt_is(&p->apt, 0, "MM"))
        return set_unit(p, 1);
    if (apt_is(&p->apt, 0, "INCHES") || apt_is(&p->apt, 0, "INCH"))
        return set_unit(p, 25.4);
    if (apt_is(&p->apt, 0, "CM"))
        return set_unit(p, 10);
    return error_at(AT(p), "found units `%.40s`, expected MM, CM or INCHES",
                    p->apt.argument.n ? p->apt.argument.item[0].text : "");
}

static int read_multax(struct path_parse *p)
{
    if (!apt_is(&p->apt, 0, "OFF"))
        p->path->head.multax = true;
    else
        p->axis = vec(0, 0, 1);
    return 0;
}

static int read_coolant(struct path_parse *p)
{
    const char *word = p->apt.argument.n ? p->apt.argument.item[0].text : "";
    enum path_coolant coolant = path_coolant_of(word);
    if (coolant == COOLANT_NOT_GIVEN) {
        char said[60];
        snprintf(said, sizeof said, "COOLNT/%.40s", word);
        path_count_unknown(p, said);
    } else if (p->path->head.coolant || p->moved) {
        path_add_text(p->path, p->apt.raw);
    } else {
        p->path->head.coolant = coolant;
    }
    return 0;
}

static int read_pass(struct path_parse *p)
{
    double n;
    if (path_numbers(p, 0, 1, &n, "number of the pass") < 0)
        return -1;
    if (n < 0 || n > PATH_PASS_MOST || n != floor(n))
        return error_at(AT(p), "found PASS/%g, expected a whole number", n);
    if (p->listener)
        p->listener->pass(p->listener->context, p->path);
    path_add_pass(p->path, (size_t)n);
    return 0;
}

static int read_track(struct path_parse *p)
{
    struct path_head *head = &p->path->head;
    if (apt_is(&p->apt, 0, "TIP"))
        head->track = TRACK_TIP;
    else if (apt_is(&p->apt, 0, "CENTER") || apt_is(&p->apt, 0, "CENTRE"))
        head->track = TRACK_CENTRE;
    else if (apt_is(&p->apt, 0, "CONTACT"))
        head->track = TRACK_CONTACT;
    else
        return error_at(AT(p), "found TRACK/%.40s, expected TIP, CENTER or CONTACT",
                        p->apt.argument.n ? p->apt.argument.item[0].text : "");
    return 0;
}

/* The entry of a stage that says pass by pass what it spent. */
static struct ledger_entry *entry_by_pass(struct path *path, const char *stage)
{
    for (size_t i = 0; i < path->head.ledger.n; i++) {
        struct ledger_entry *entry = &path->head.ledger.item[i];
        if (entry->by_pass && strcmp(entry->stage, stage) == 0)
            return entry;
    }
    path_spend(path, stage, 0);
    path->head.ledger.item[path->head.ledger.n - 1].by_pass = true;
    return &path->head.ledger.item[path->head.ledger.n - 1];
}

static int read_ledger(struct path_parse *p)
{
    double spent;
    if (path_numbers(p, 1, 1, &spent, "mm spent") < 0)
        return -1;
    if (!(spent >= 0))
        return error_at(AT(p), "found %g mm in LEDGER, expected 0 or more", spent);
    /* the stage's name as it was written, not in upper case */
    const char *name = strchr(p->apt.raw, '/') + 1;
    name += strspn(name, " \t");
    char *stage = mem_string(name, strcspn(name, ", \t"));
    if (p->path->item.n == 0) {
        path_spend(p->path, stage, spent);
    } else {
        struct ledger_entry *entry = entry_by_pass(p->path, stage);
        entry->spent = fmax(entry->spent, spent);
    }
    free(stage);
    return 0;
}

/* Stage, text: as it was written, to the end of the line. */
static int read_said(struct path_parse *p, const char *word, struct unmets *said)
{
    const char *name = strchr(p->apt.raw, '/');
    size_t n = name ? strcspn(++name, ",") : 0;
    if (n == 0 || name[n] != ',')
        return error_at(AT(p), "found `%.60s`, expected %s/stage, what it could not keep",
                        p->apt.raw, word);
    char *stage = mem_string(name, n);
    unmets_add(said, stage, name + n + 1);
    free(stage);
    return 0;
}

static int read_unmet(struct path_parse *p)
{
    return read_said(p, "UNMET", &p->path->head.unmet);
}

static int read_unfitted(struct path_parse *p)
{
    return read_said(p, "UNFITTED", &p->path->head.unfitted);
}

static int read_chord(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.chord, "mm");
}

static int read_clear(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.clearance, "z of the clearance plane");
}

static int read_scallop(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.scallop, "mm");
}

static int read_noise(struct path_parse *p)
{
    double *noise = &p->path->head.noise;

    if (path_numbers(p, 0, 1, noise, "mm") < 0)
        return -1;
    p->path->head.noise_given = *noise >= 0;
    return *noise >= 0 ? 0 : error_at(AT(p), "found NOISE/%g, expected no less than 0", *noise);
}

/* Corners of a polygon: of the last one, or of another. */
static int read_corners(struct path_parse *p, bool another)
{
    struct region_polygons *polygons = &p->path->head.region.polygons;
    size_t n = p->apt.argument.n;

    if (n < 3 || n % 2 == 0 || (!another && polygons->from.n == 0))
        return error_at(AT(p),
                        "found `%.60s`, expected REGION/POLYGON,x,y, more corners, and more "
                        "in REGION/CORNERS",
                        p->apt.raw);
    if (another)
        *array_push(&polygons->from) = (int)polygons->corner.n;
    for (size_t i = 1; i < n; i += 2) {
        double v[2];
        if (path_numbers(p, i, 2, v, "x, y of a corner") < 0)
            return -1;
        *array_push(&polygons->corner) = vec(v[0], v[1], 0);
    }
    return 0;
}

/* Of a path after others nobody knows which part of them is whose. */
static int begin_region(struct path_parse *p)
{
    struct path_head *head = &p->path->head;

    if (region_given(&head->region) || p->path->item.n > 0)
        head->regions = true;
    if (head->regions) {
        region_polygons_free(&head->region.polygons);
        head->region = (struct region){0};
        return 0;
    }
    return path_numbers(p, 1, 1, &head->region.border, "mm");
}

static int read_region(struct path_parse *p)
{
    struct region *region = &p->path->head.region;
    double v[6];

    if (apt_is(&p->apt, 0, "BORDER"))
        return begin_region(p);
    if (apt_is(&p->apt, 0, "POLYGON") || apt_is(&p->apt, 0, "CORNERS"))
        return p->path->head.regions ? 0 : read_corners(p, apt_is(&p->apt, 0, "POLYGON"));
    if (!apt_is(&p->apt, 0, "BOX"))
        return error_at(AT(p), "found `%.60s`, expected REGION/BORDER, BOX, POLYGON or CORNERS",
                        p->apt.raw);
    if (path_numbers(p, 1, 6, v, "x, y, z of two corners") < 0)
        return -1;
    if (!p->path->head.regions) {
        region->boxed = true;
        region->box = (struct box){vec(v[0], v[1], v[2]), vec(v[3], v[4], v[5])};
    }
    return 0;
}

static int read_runs(struct path_parse *p)
{
    double v[2];
    if (path_numbers(p, 0, 2, v, "points of the cutting runs, largest feed") < 0)
        return -1;
    if (!(v[0] >= 1 && v[0] <= 1e15) || v[0] != floor(v[0]) || !(v[1] > 0))
        return error_at(AT(p), "found RUNS/%g,%g, expected a number of points and a feed", v[0],
                        v[1]);
    p->path->head.runs = (struct path_runs){(size_t)v[0], p->unit * v[1]};
    return 0;
}

/* TOOL/BALL-ONLY; TOOL/FLUTE,length,HOLDER,cones: what the tool is above its ball. */
static int read_body(struct path_parse *p)
{
    struct tool_body body = {.ball_only = apt_is(&p->apt, 0, "BALL-ONLY")};
    size_t n = p->apt.argument.n;
    struct error why;
    if (body.ball_only
            ? n != 1
            : !apt_is(&p->apt, 0, "FLUTE") || (n != 2 && (n != 4 || !apt_is(&p->apt, 2, "HOLDER"))))
        return error_at(AT(p),
                        "found `%.60s`, expected TOOL/BALL-ONLY or "
                        "TOOL/FLUTE,length,HOLDER,cones",
                        p->apt.raw);
    if (!body.ball_only && path_numbers(p, 1, 1, &body.flute, "length of the flute") < 0)
        return -1;
    if (!(body.flute >= 0 && body.flute <= 1e4))
        return error_at(AT(p), "found a flute of %g mm, expected 0 to 10000", body.flute);
    if (n == 4 && holder_text_read(p->apt.argument.item[3].text, &body.above, &why) < 0)
        return error_at(AT(p), "TOOL: %s", why.text);
    p->path->head.body = body;
    p->path->head.body_given = true;
    return 0;
}

/* Points, hash, name: as it was written, to the end of the line. */
static int read_source(struct path_parse *p, struct scan_sources *sources, const char *what)
{
    const char *text = strchr(p->apt.raw, '/');
    if (!text || !scan_sources_read(sources, text + 1, ','))
        return error_at(AT(p), "found `%.60s`, expected %s", p->apt.raw, what);
    char *name = sources->item[sources->n - 1].name;
    size_t n = strlen(name);
    if (n > 2 && strcmp(name + n - 2, "$$") == 0) /* doubled, so that it continues nothing */
        name[n - 1] = '\0';
    return 0;
}

static int read_scan(struct path_parse *p)
{
    return read_source(p, &p->path->head.scan, "SCAN/points, hash, name of the scan");
}

static int read_mesh(struct path_parse *p)
{
    return read_source(p, &p->path->head.mesh, "MESH/vertices, hash, name of the mesh");
}

/* PLACE/row, and its four numbers; the rows come in order. */
static int read_place(struct path_parse *p)
{
    struct scan_sources *scan = &p->path->head.scan;
    double v[5];
    if (path_numbers(p, 0, 5, v, "a row of the matrix that placed the scan") < 0)
        return -1;
    if (!(v[0] >= 1 && v[0] <= 3) || v[0] != floor(v[0]))
        return error_at(AT(p), "found row %g in PLACE, expected 1, 2 or 3", v[0]);
    if (!scan->placed)
        scan->place = transform_identity();
    scan->placed = true;
    memcpy(scan->place.m[(int)v[0] - 1], v + 1, 4 * sizeof *v);
    return 0;
}

int path_ignore(struct path_parse *p)
{
    (void)p;
    return 0;
}

/* A stream of this suite has no words of other systems. */
static int read_own(struct path_parse *p)
{
    p->sniffed = p->own = true;
    return 0;
}

/* ORIGIN: the machine's zero in the coordinates of the stream; TRANS: an offset added to them. */
static int read_shift(struct path_parse *p, struct vec3 *shift)
{
    double v[3];
    if (p->apt.argument.n != 3)
        return error_at(AT(p), "found %zu arguments in %s, expected x, y, z", p->apt.argument.n,
                        p->apt.word);
    if (path_numbers(p, 0, 3, v, "x, y, z") < 0)
        return -1;
    *shift = vec_scale(p->unit, vec(v[0], v[1], v[2]));
    p->shift = vec_sub(p->trans, p->origin);
    return 0;
}

static int read_origin(struct path_parse *p)
{
    return read_shift(p, &p->origin);
}

static int read_trans(struct path_parse *p)
{
    return read_shift(p, &p->trans);
}

/* MODE/INCR, SET/MODE,INCR: incremental coordinates. */
static int read_mode(struct path_parse *p)
{
    for (size_t i = 0; i < p->apt.argument.n; i++)
        if (strncmp(p->apt.argument.item[i].text, "INCR", 4) == 0)
            return error_at(AT(p), "found %s with incremental coordinates, expected absolute ones",
                            p->apt.word);
    return path_keep_text(p);
}

int path_keep_text(struct path_parse *p)
{
    path_add_text(p->path, p->apt.raw);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
    return 0;
}

static const struct path_row head_words[] = {
    {"FEDRAT", path_read_feed},
    {"PARTNO", read_partno},
    {"UNITS", read_units},
    {"UNIT", read_units},
    {"MULTAX", read_multax},
    {"CUTTER", path_read_cutter},
    {"LOADTL", path_read_tool},
    {"TOOLNO", path_read_tool},
    {"TLCHG", path_read_tool},
    {"LOAD", path_read_load},
    {"SPINDL", path_read_spindle},
    {"COOLNT", read_coolant},
    {"DELAY", path_read_delay},
    {"ORIGIN", read_origin},
    {"TRANS", read_trans},
    {"MODE", read_mode},
    {"SET", read_mode},
};

static const struct path_row comments[] = {
    {"CONTCT", path_read_contact}, {"PASS", read_pass},          {"TRACK", read_track},
    {"LEDGER", read_ledger},       {"CHORD", read_chord},        {"CLEAR", read_clear},
    {"CLOUDMILL", read_own},       {"CUTTER", path_read_cutter}, {"SCALLOP", read_scallop},
    {"TOOL", read_body},           {"SCAN", read_scan},          {"PLACE", read_place},
    {"UNMET", read_unmet},         {"UNFITTED", read_unfitted},  {"RUNS", read_runs},
    {"NOISE", read_noise},         {"REGION", read_region},      {"PASSES", path_read_passes},
    {"MESH", read_mesh},
};

const struct path_row *path_row_of_word(const struct path_row *rows, size_t n, const char *word)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(rows[i].word, word) == 0)
            return &rows[i];
    return NULL;
}

const struct path_row *path_head_row(const char *word)
{
    return path_row_of_word(head_words, sizeof head_words / sizeof *head_words, word);
}

const struct path_row *path_comment_row(const char *word)
{
    return path_row_of_word(comments, sizeof comments / sizeof *comments, word);
}
