/* post_head - see post_head.h. */
#include "post_head.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "post_statement.h"

enum { PLANES_SHOWN = 12 };

double nc_ledger_sum(const struct path *path, const struct nc_plan *plan)
{
    double sum = path_spent(path) + plan->total.spent.point * plan->ability.unit;
    sum += plan->ability.smoothing;
    return isnan(path->head.chord) ? sum : sum + path->head.chord;
}

static void tool_line(struct nc_program *p, int number, const double *cutter, int n, double ball)
{
    double unit = p->plan->ability.unit;
    char d[NUM_MAX], r[NUM_MAX];
    if (n == 0)
        return;
    num_write_short(d, unit * cutter[0], 3, false);
    num_write_short(r, n > 1 ? unit * cutter[1] : 0, 3, false);
    nc_comment(&p->w, "Tool %d: %s D %.20s R %.20s", number, ball > 0 ? "ball nose" : "cutter", d,
               r);
}

/* KEY: text, in further lines KEY+: where it is too long for one; a line ends before a blank, which
 * is left out, or where it is full. */
static void key_line(struct nc_program *p, const char *key, const char *text)
{
    size_t frame = strlen(p->w.style.open) + strlen(p->w.style.close) + strlen(key) + 3;
    size_t room = p->w.style.comment_width - frame;
    for (const char *more = ""; *text; more = "+") {
        size_t n = strlen(text);
        if (n > room) {
            n = room;
            while (n > room / 2 && text[n] != ' ')
                n--;
            n = text[n] == ' ' ? n : room;
        }
        nc_comment(&p->w, "%s%s: %.*s", key, more, (int)n, text);
        text += n;
        text += strspn(text, " ");
    }
}

/* " FLUTE 20 HOLDER 5:60" */
static void body_text(const struct tool_body *body, char *text, size_t size)
{
    char r0[NUM_MAX], r1[NUM_MAX], length[NUM_MAX];
    num_write_short(length, body->flute, 4, false);
    size_t n = (size_t)snprintf(text, size, body->ball_only ? " BALL-ONLY" : " FLUTE %s", length);
    for (int i = 0; i < body->above.n && !body->ball_only && n < size; i++) {
        const struct holder_part *part = &body->above.part[i];
        bool cone = part->low != part->high;
        num_write_short(r0, part->low, 4, false);
        num_write_short(r1, part->high, 4, false);
        num_write_short(length, part->length, 4, false);
        n += (size_t)snprintf(text + n, size - n, "%s%s%s%s:%s", i ? "+" : " HOLDER ", r0,
                              cone ? ":" : "", cone ? r1 : "", length);
    }
}

/* What ncverify reads back of the tool, of the first one: TOOL: BALL R5 FLUTE 20 HOLDER 5:60. */
static void tool_key(struct nc_program *p)
{
    const struct path_head *head = &p->path->head;
    double unit = p->plan->ability.unit, ball = path_ball(p->path);
    char text[1200], body[1000] = "", d[NUM_MAX], r[NUM_MAX];
    if (!head->cutter_n)
        return;
    num_write_short(d, unit * head->cutter[0], 4, false);
    num_write_short(r,
                    unit * (ball > 0             ? ball
                            : head->cutter_n > 1 ? head->cutter[1]
                                                 : 0),
                    4, false);
    if (head->body_given)
        body_text(&head->body, body, sizeof body);
    if (ball > 0)
        snprintf(text, sizeof text, "BALL R%.20s%s", r, body);
    else
        snprintf(text, sizeof text, "CUTTER D%.20s R%.20s", d, r);
    key_line(p, "TOOL", text);
}

/* The kinematics is solved here, so that it must be the machine's. */
static bool solved(const struct nc_program *p)
{
    return p->plan->ability.mode == INTERPOLATE_JOINT && p->machine->chain.n > 0;
}

/* Centres and tool lengths with which the linear axes were computed, mm. */
static void assumed_kinematics(struct nc_program *p)
{
    const struct machine *m = p->machine;
    double unit = p->plan->ability.unit;
    bool lengths = machine_has_lengths(m);
    for (int i = 0; i < m->chain.n; i++) {
        const struct rotary *r = &m->chain.rotary[i];
        char x[NUM_MAX], y[NUM_MAX], z[NUM_MAX];
        num_write_short(x, unit * r->centre.x, 4, false);
        num_write_short(y, unit * r->centre.y, 4, false);
        num_write_short(z, unit * r->centre.z, 4, false);
        nc_comment(&p->w, "ASSUMED: CENTRE %c %.15s %.15s %.15s from the %s",
                   machine_letter(m->letter[i]), x, y, z,
                   r->table  ? "work offset"
                   : lengths ? "spindle's nose"
                             : "tip of every tool");
    }
    for (size_t i = 0; i < m->tools && lengths; i++) {
        char length[NUM_MAX];
        if (isnan(m->tool[i].length))
            continue;
        num_write_short(length, m->tool[i].length, 4, false);
        nc_comment(&p->w, "ASSUMED: LENGTH OF TOOL %d %.20s", m->tool[i].number, length);
    }
}

/* By what names ncverify and ncplot find control and machine again: those of -c, -m and --set. */
static void machine_keys(struct nc_program *p)
{
    const struct machine *m = p->machine;
    if (*m->used)
        key_line(p, "CONTROL", m->used);
    if (*m->file)
        key_line(p, "MACHINE", m->file);
    if (*m->set)
        key_line(p, "SET", m->set);
}

/* What the path or the machine does not say and the program rests on. */
static void assumptions(struct nc_program *p)
{
    const struct nc_total *total = &p->plan->total;
    char feed[NUM_MAX], top[NUM_MAX];
    if (solved(p))
        assumed_kinematics(p);
    if (p->path->inches_taken)
        nc_comment(&p->w, "ASSUMED: THE PATH IS IN INCHES, as its feeds are");
    if (total->feed_assumed) {
        num_write_short(feed, p->options.feed, 3, false);
        nc_comment(&p->w, "ASSUMED: FEED %.20s where the path gives none", feed);
    }
    if (isfinite(p->plan->top)) {
        num_write_short(top, p->plan->top, p->plan->ability.digits.linear, false);
        nc_comment(&p->w, "ASSUMED: HOME IS ABOVE Z%.20s, and all that stands there is below", top);
    }
}

/* AMID: what would look like a fault to who reads the program without its path. */
static void amid_key(struct nc_program *p)
{
    bool said = p->path->head.spindle > 0, skips = path_statements(p->path, "OPSKIP") > 0;
    bool speeds = path_statements(p->path, "SPINDL") > (said ? 0 : 1);

    if (speeds || skips)
        key_line(p, "AMID", !skips ? "SPEEDS" : speeds ? "SPEEDS SKIPS" : "SKIPS");
}

static void head_tool(struct nc_program *p)
{
    const struct path *path = p->path;
    tool_line(p, path->head.tool, path->head.cutter, path->head.cutter_n, path_ball(path));
    for (size_t i = 0; i < path->tool.n; i++) {
        const struct path_tool *tool = &path->tool.item[i];
        tool_line(p, tool->number, tool->cutter, tool->cutter_n, path_tool_ball(tool));
    }
    if (path->head.track == TRACK_CENTRE) {
        nc_comment(&p->w, "*** ATTENTION: X Y Z ARE THE CENTRE OF THE BALL, NOT THE TIP ***");
        nc_comment(&p->w, "*** the tool's length must be measured to the ball's centre ***");
    } else if (solved(p)) {
        nc_comment(&p->w, "X Y Z are the linear axes, not the tip: no tool-centre-point control");
    } else {
        nc_comment(&p->w, "X Y Z are the tool tip");
    }
    tool_key(p);
    if (nc_cuts_dry(p))
        key_line(p, "COOLANT", "NONE");
    if (nc_cuts_anticlockwise(p))
        key_line(p, "SPINDLE", "CCLW");
    amid_key(p);
}

/* To four decimals, never too small. */
static double rounded_up(double mm)
{
    return fmax(0, ceil(mm * 1e4 - 1e-6)) / 1e4 + 0.0;
}

static void head_ledger(struct nc_program *p)
{
    const struct path_head *head = &p->path->head;
    const struct nc_total *total = &p->plan->total;
    for (size_t i = 0; i < head->ledger.n; i++)
        nc_comment(&p->w, "Tolerance %-12s %.4f", head->ledger.item[i].stage,
                   rounded_up(head->ledger.item[i].spent));
    if (!isnan(head->chord))
        nc_comment(&p->w, "Tolerance %-12s %.4f", "chord", rounded_up(head->chord));
    nc_comment(&p->w, "Tolerance %-12s %.4f", "ncpost",
               rounded_up(total->spent.point * p->plan->ability.unit));
    if (p->plan->ability.smoothing > 0)
        nc_comment(&p->w, "Tolerance %-12s %.4f", "smoothing",
                   rounded_up(p->plan->ability.smoothing));
    nc_comment(&p->w, "Tolerance %-12s %.4f mm, axis %.4f deg", "sum",
               rounded_up(nc_ledger_sum(p->path, p->plan)), rounded_up(DEGREES(total->spent.axis)));
}

/* PLACE1: to PLACE3:, the rows of the matrix from the numbers of the scans to mm of the path. */
static void place_keys(struct nc_program *p, const struct transform *place)
{
    for (int row = 0; row < 3; row++) {
        char text[4 * (NUM_MAX + 1)] = "", value[NUM_MAX];
        size_t n = 0;
        for (int k = 0; k < 4; k++) {
            num_write_short(value, place->m[row][k], k < 3 ? 12 : 7, false);
            n += (size_t)snprintf(text + n, sizeof text - n, "%s%.40s", k ? " " : "", value);
        }
        key_line(p, (const char *const[]){"PLACE1", "PLACE2", "PLACE3"}[row], text);
    }
}

/* Corners of the polygons of a region: more would be a program of comments.  A number is no longer
 * than that, and no coordinate beyond FAR. */
enum { CORNERS_SAID = 1000, NUMBER = 16 };
static const double FAR = 1e9;

/* " x y"; returns its length. */
static size_t put_place(char *text, double x, double y)
{
    char a[NUM_MAX], b[NUM_MAX];

    num_write_short(a, fmax(-FAR, fmin(x, FAR)), 4, false);
    num_write_short(b, fmax(-FAR, fmin(y, FAR)), 4, false);
    return (size_t)sprintf(text, " %.*s %.*s", NUMBER, a, NUMBER, b);
}

/* REGION: BORDER 0.75 BOX 0 0 -5 40 30 10 POLYGON 0 0 10 0 10 10, that is cut; mm. */
static void region_key(struct nc_program *p, const struct region *region)
{
    const struct region_polygons *polygons = &region->polygons;
    const struct vec3 low = region->box.low, high = region->box.high;
    char text[CORNERS_SAID * (sizeof " POLYGON" + 2 * (NUMBER + 1)) + 200], border[NUM_MAX];
    size_t n, next = 0;

    num_write_short(border, fmin(region->border, FAR), 4, false);
    n = (size_t)sprintf(text, "BORDER %.*s", NUMBER, border);
    if (region->boxed) {
        n += (size_t)sprintf(text + n, " BOX");
        n += put_place(text + n, low.x, low.y);
        n += put_place(text + n, low.z, high.x);
        n += put_place(text + n, high.y, high.z);
    }
    for (size_t i = 0; i < polygons->corner.n; i++) {
        if (next < polygons->from.n && (size_t)polygons->from.item[next] == i) {
            n += (size_t)sprintf(text + n, " POLYGON");
            next++;
        }
        n += put_place(text + n, polygons->corner.item[i].x, polygons->corner.item[i].y);
    }
    key_line(p, "REGION", text);
}

/* SCALLOP: 0.02 TOLERANCE: 0.01, and the scans by which the path was guarded, with the noise that
 * they were said to have; mm. */
static void surface_keys(struct nc_program *p)
{
    if (p->options.contact_feed)
        nc_comment(&p->w, "FEED: CONTACT");
    double scallop = p->path->head.scallop;
    const struct scan_sources *scan = &p->path->head.scan;
    const struct region *region = &p->path->head.region;
    char said[NUM_MAX], sum[NUM_MAX];
    num_write_short(sum, rounded_up(nc_ledger_sum(p->path, p->plan)), 4, false);
    if (scallop > 0) {
        num_write_short(said, scallop, 4, false);
        nc_comment(&p->w, "SCALLOP: %.20s TOLERANCE: %.20s", said, sum);
    } else {
        nc_comment(&p->w, "TOLERANCE: %.20s", sum);
    }
    if (region_given(region) && region->polygons.corner.n <= CORNERS_SAID)
        region_key(p, region);
    if (p->path->head.noise_given) {
        num_write_short(said, p->path->head.noise, 6, false);
        nc_comment(&p->w, "NOISE: %.20s", said);
    }
    for (size_t i = 0; i < scan->n; i++) {
        const struct scan_source *s = &scan->item[i];
        char text[400];
        snprintf(text, sizeof text, "%" PRIu64 ",%016" PRIx64 ",%.300s", s->points, s->hash,
                 s->name);
        key_line(p, "SCAN", text);
    }
    if (scan->n > 0 && scan->placed)
        place_keys(p, &scan->place);
}

/* What the stages before could not keep: nobody who reads the program alone shall miss it. */
static void unmet_lines(struct nc_program *p)
{
    const struct unmets *unmet = &p->path->head.unmet;
    for (size_t i = 0; i < unmet->n; i++) {
        char text[500];
        snprintf(text, sizeof text, "%.40s: %.400s", unmet->item[i].stage, unmet->item[i].text);
        key_line(p, "UNMET", text);
    }
}

void nc_head(struct nc_program *p)
{
    const struct nc_total *total = &p->plan->total;
    const char *partno = p->path->head.partno;
    if (partno && *partno)
        nc_comment(&p->w, "%.70s", partno);
    nc_comment(&p->w, "cloudmill ncpost for %s, %.50s", p->machine->text.title, p->machine->name);
    machine_keys(p);
    if (p->from)
        nc_comment(&p->w, "From pass %d on; figures below are those of the whole", *p->from);
    if (p->parts)
        nc_comment(&p->w, "Part %zu of %zu; figures below are those of the whole", p->part,
                   p->parts);
    if (p->plan->ability.unit > 1)
        nc_comment(&p->w, "Inches; all figures in these lines are mm");
    if (p->plane)
        nc_comment(&p->w, "X Y Z in the tilted plane%s", p->planes.n > 1 ? "s" : "");
    for (size_t i = 0; p->plane && i < p->planes.n && i < PLANES_SHOWN; i++)
        nc_comment(&p->w, "Z along %.6f %.6f %.6f", p->planes.item[i].axis.x,
                   p->planes.item[i].axis.y, p->planes.item[i].axis.z);
    head_tool(p);
    head_ledger(p);
    surface_keys(p);
    unmet_lines(p);
    assumptions(p);
    double unit = p->plan->ability.unit;
    nc_comment(&p->w, "Cut %.1f mm, rapid %.1f mm, %.1f min", total->cut * unit,
               total->rapid * unit, total->minutes);
    nc_comment(&p->w, "Passes %zu, lines %zu, arcs %zu, splines %zu, rapids %zu", total->passes,
               total->lines, total->arcs, total->splines, total->rapids);
    if (total->holes)
        nc_comment(&p->w, "Holes in drilling cycles %zu", total->holes);
}
