/* verdict - see verdict.h. */
#include "verify/verdict.h"

#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "simulate/excursion.h"

enum { LEAN_STEPS = 4 };

#define JUMP 5.0  /* degrees */
#define STILL 0.5 /* degrees of rotary axes, or mm of a second point, that need no look */
#define ROLLS 1.5 /* times as fast as the ball rolls over an edge */

static void find(struct verdict *v, bool fault, size_t piece, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

static void find(struct verdict *v, bool fault, size_t piece, const char *format, ...)
{
    struct finding *finding = array_push(&v->finding);
    char place[60], what[FINDING_TEXT - 64];
    va_list arguments;
    ncread_place(&v->nc_motion->piece.item[piece], place, sizeof place);
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    finding->fault = fault;
    snprintf(finding->text, sizeof finding->text, "%s: %s", place, what);
}

static void sum_pieces(struct verdict *v)
{
    const struct nc_motion *nc_motion = v->nc_motion;
    bool cut = false;
    v->piece = mem_alloc(nc_motion->piece.n, sizeof *v->piece);
    for (size_t i = 0; i < nc_motion->piece.n; i++) {
        if (!nc_motion->piece.item[i].rapid && !cut)
            v->passes++;
        cut = !nc_motion->piece.item[i].rapid;
        v->piece[i].pass = v->passes;
    }
    for (size_t i = 0; i < v->roll.points; i++) {
        if (!v->roll.region[i])
            continue;
        struct verdict_piece *piece = &v->piece[v->cut->item[v->roll.segment[i]].piece];
        float deviation = (float)v->roll.deviation[i];
        if (-deviation > piece->gouge)
            piece->gouge = -deviation;
        if (deviation > piece->over)
            piece->over = deviation;
    }
}

static size_t piece_at(const struct verdict *v, size_t point)
{
    return v->cut->item[v->roll.segment[point]].piece;
}

static void judge_surface(struct verdict *v)
{
    const struct deviation_map *r = &v->roll;
    struct vec3 p = v->point->item[r->gouge_at];
    if (r->gouge > v->tolerance)
        find(v, true, piece_at(v, r->gouge_at),
             "the ball is %.4f mm deep in the part at %.3f %.3f %.3f, tolerance %g", r->gouge, p.x,
             p.y, p.z, v->tolerance);
    p = v->point->item[r->over_at];
    if (r->over > v->left)
        find(v, true, piece_at(v, r->over_at),
             "%.4f mm of material is left at %.3f %.3f %.3f, at most %g", r->over, p.x, p.y, p.z,
             v->left);
    p = v->point->item[v->rapid_at];
    if (v->rapid > 0)
        find(v, true, v->rapid_piece,
             "a rapid move goes %.3f mm deep through the part at %.3f %.3f %.3f", v->rapid, p.x,
             p.y, p.z);
}

/* Shank or holder in the part, or in the stock. */
static void judge_holder(struct verdict *v, const struct holder_collision *way, const char *what)
{
    if (!way || !(way->depth > 0))
        return;
    bool fast = v->nc_motion->piece.item[way->piece].rapid;
    find(v, true, way->piece,
         "shank or holder goes %.3f mm deep into the %s at %.3f %.3f %.3f%s (blocks: %zu)",
         way->depth, what, way->at.x, way->at.y, way->at.z, fast ? ", in a rapid move" : "",
         way->pieces);
}

static void judge_stock(struct verdict *v)
{
    const struct stock_simulate *run = v->stock;
    if (run && run->rapid > 0)
        find(v, true, run->rapid_piece,
             "a rapid move goes %.3f mm deep into the stock at %.3f %.3f %.3f (blocks: %zu)",
             run->rapid, run->rapid_at.x, run->rapid_at.y, run->rapid_at.z, run->rapids);
}

/* How the tool axis turns over one piece, radians, and how far the tip goes. */
struct lean {
    struct vec3 from, to; /* the axis at its ends */
    double most;          /* furthest from where it was */
    double way;
    bool on; /* the ball touches the part in it */
};

static struct lean lean(const struct nc_motion *nc_motion, const struct nc_piece *piece)
{
    struct nc_motion_pose a = nc_motion_at(nc_motion, piece, 0),
                          b = nc_motion_at(nc_motion, piece, 1);
    struct lean lean = {a.a, b.a, vec_angle(a.a, b.a), vec_distance(a.p, b.p), false};
    if (vec_distance(piece->q[0], piece->q[1]) < STILL && piece->shape == SHAPE_LINE)
        return lean;
    for (int i = 1; i < LEAN_STEPS; i++) {
        struct vec3 axis = nc_motion_at(nc_motion, piece, (double)i / LEAN_STEPS).a;
        lean.most = fmax(lean.most, vec_angle(a.a, axis));
    }
    return lean;
}

/*
 * Jumps of the tool axis with the ball on the part: it turns, in one block or two, and comes back
 * by more than half, half as fast again as where the ball rolls over an edge, 1 / R for each mm of
 * the tip.
 */
static void judge_jumps(struct verdict *v)
{
    const struct centre_path *cut = v->cut;
    size_t jumps = 0, worst = 0, last = SIZE_MAX - 1;
    double most = 0;
    struct lean before = {0};
    for (size_t i = 0; i < cut->n;) {
        size_t piece = cut->item[i].piece;
        struct lean at = lean(v->nc_motion, &v->nc_motion->piece.item[piece]);
        for (; i < cut->n && cut->item[i].piece == piece; i++)
            at.on = at.on || cut->item[i].on;
        bool follows = piece == last + 1;
        double turn = follows ? fmax(at.most, before.most) : at.most;
        double back = vec_angle(follows ? before.from : at.from, at.to);
        double way = at.way + (follows ? before.way : 0);
        if ((at.on || (follows && before.on)) && turn > RADIANS(JUMP) && back < turn / 2 &&
            turn * v->radius > ROLLS * way) {
            jumps++;
            worst = turn > most ? piece : worst;
            most = fmax(most, turn);
        }
        last = piece;
        before = at;
    }
    if (jumps > 0)
        find(v, true, worst,
             "the tool axis swings out by %.3f degrees and back on the part (blocks: %zu)",
             DEGREES(most), jumps);
}

/* Curves that leave the part and come back. */
static void judge_leaps(struct verdict *v)
{
    const struct excursion_options setup = {v->radius, v->band};
    struct excursion leap =
        excursion_find(v->nc_motion, v->cut, v->point->item, v->point->n, &setup);
    if (leap.leaps > 0)
        find(v, true, leap.piece,
             "the ball leaves the part amid a cut, %.3f mm off it at %.3f %.3f %.3f (times: %zu)",
             leap.height, leap.at.x, leap.at.y, leap.at.z, leap.leaps);
}

static void judge_axes(struct verdict *v)
{
    static const char letter[] = "XYZABC";
    const struct axis_limits *load = &v->load;
    if (load->beyond)
        find(v, true, load->travel.piece, "axis %c at %.3f is beyond its travel (blocks: %zu)",
             letter[load->travel.axis], load->travel.value, load->beyond);
    if (load->unreachable)
        find(v, true, load->unreachable_at, "a tool axis that the machine's axes cannot reach");
    if (load->fast)
        find(v, load->speed.value > 0 && v->nc_motion->piece.item[load->speed.piece].inverse,
             load->speed.piece,
             "axis %c would have to move at %.2f of its largest speed "
             "(blocks: %zu)",
             letter[load->speed.axis], load->speed.value, load->fast);
}

void verdict_judge(struct verdict *v)
{
    sum_pieces(v);
    if (v->roll.points > 0)
        judge_surface(v);
    judge_holder(v, v->holder, "part");
    judge_stock(v);
    judge_holder(v, v->stock_holder, "stock");
    judge_axes(v);
    judge_jumps(v);
    judge_leaps(v);
    if (v->cut->n == 0 && v->nc_motion->piece.n > 0)
        find(v, v->left < HUGE_VAL, 0, "nothing is cut, all moves are rapid"); /* a part of many */
    else if (v->roll.cut == 0 && v->nc_motion->piece.n > 0)
        find(v, true, 0, "the ball comes near no point of the part");
}

static double depth(const struct verdict *v, bool gouge, size_t piece)
{
    return gouge ? v->piece[piece].gouge : v->piece[piece].over;
}

size_t verdict_worst(const struct verdict *v, bool gouge, size_t most, size_t *piece)
{
    size_t n = 0;
    for (size_t i = 0; i < v->nc_motion->piece.n; i++) {
        double value = depth(v, gouge, i);
        if (value <= 0 || (n == most && value <= depth(v, gouge, piece[n - 1])))
            continue;
        size_t k = n < most ? n++ : n - 1;
        for (; k > 0 && depth(v, gouge, piece[k - 1]) < value; k--)
            piece[k] = piece[k - 1];
        piece[k] = i;
    }
    return n;
}

bool verdict_refused(const struct verdict *v)
{
    for (size_t i = 0; i < v->finding.n; i++)
        if (v->finding.item[i].fault)
            return true;
    return false;
}

void verdict_free(struct verdict *v)
{
    deviation_map_free(&v->roll);
    free(v->piece);
    array_free(&v->finding);
}
