/* verify_judge - see verify_judge.h. */
#include "verify_judge.h"

#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "cloud/judged_scan.h"
#include "ncread/ncread.h"
#include "verify_finding.h"
#include "verify_made.h"
#include "verify_rapid.h"
#include "verify_swerve.h"

/* Steps of a piece, for its tool axis; parts of a curve that count as blocks. */
enum { TURN_STEPS = 4, CURVE_PARTS = 4, AWAY_PLACES = 4 };

#define PATH_TIP 0.008 /* mm that the tip may be off the path, where the head does not say it */
#define PATH_AXIS 0.25 /* degrees that the tool axis may be off the path's, likewise */
#define PATH_TIP_MORE 0.0005 /* mm besides what the head says: both are followed in lines */
#define PATH_AXIS_MORE 0.01  /* degrees, likewise */
#define PATH_FAST 1.5        /* times the path's feed; more slowly it may go where the axes turn */
#define PATH_SLOW 20
#define TIP_ROUNDED 0.00005   /* mm: what is printed as no more than may be is no more; ... */
#define AXIS_ROUNDED 0.0005   /* ... degrees, ... */
#define FEED_ROUNDED 0.00025  /* ... of the ratio, ... */
#define SHARE_ROUNDED 0.00005 /* ... of points, as who makes a path prints it in percent */
#define PATH_CONTACT 10       /* times slower or faster than the contact point the tip may go */
#define JUMP 5.0              /* degrees: less is no jump of the tool axis */
#define STILL 0.5          /* degrees of rotary axes, or mm of a second point, that need no look */
#define ROLLS 1.5          /* times as fast as the ball rolls over an edge */
#define THICKER 0.01       /* of the ball's radius: so much thicker than it, a tool is a holder */
#define RIM 0.25           /* times the root of the points of a region: one in 16 at its border */
#define UNSEEN 3           /* times what points are apart: so far an edge may be beyond them */
#define LOW_RADII 10       /* below all of the part rows may run out so many radii, ... */
#define LOW_MORE 20        /* ... and mm more, but no farther */
#define FAR_RADII 20       /* so many radii, ... */
#define FAR_MORE 50        /* ... and mm, and as far as the part is long, a link may go beside it */
#define ROUNDING_EVEN 0.02 /* of a tolerance: numbers in a program are rounded */
#define BORDER 1.5 /* times what may be left: so much at few points of a region that is cut */

static void sum_pieces(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    bool cut = false;
    v->piece = mem_alloc(motion->piece.n, sizeof *v->piece);
    for (size_t i = 0; i < motion->piece.n; i++) {
        if (!motion->piece.item[i].rapid && !cut)
            v->passes++;
        cut = !motion->piece.item[i].rapid;
        v->piece[i].pass = v->passes;
    }
    for (size_t i = 0; i < v->map.points; i++) {
        if (!v->map.region[i])
            continue;
        struct verdict_piece *piece = &v->piece[v->cut.item[v->map.segment[i]].piece];
        float deviation = (float)v->map.deviation[i];
        if (-deviation > piece->gouge)
            piece->gouge = -deviation;
        if (deviation > piece->over)
            piece->over = deviation;
    }
}

static size_t piece_at(const struct verdict *v, size_t point)
{
    return v->cut.item[v->map.segment[point]].piece;
}

/* True if the ball is at the part anywhere. */
static bool comes_near(const struct verdict *v)
{
    for (size_t i = 0; i < v->map.points; i++)
        if (v->map.region[i] && v->map.deviation[i] <= v->options.band)
            return true;
    return false;
}

/* A length that is more than another, both in so many digits that this is seen. */
struct more_than {
    char more[40], limit[40];
};

static struct more_than more_than(double more, double limit)
{
    struct more_than text;
    for (int digits = 4; digits < 10; digits++) {
        snprintf(text.more, sizeof text.more, "%.*f", digits, more);
        snprintf(text.limit, sizeof text.limit, "%.*g", digits, limit);
        if (strtod(text.more, NULL) > strtod(text.limit, NULL))
            break;
    }
    return text;
}

/* What is left beyond the limit in the region that a part of a program cuts: the points that are
 * more than that below the ball. */
static size_t left_in_region(const struct verdict *v)
{
    size_t n = 0;
    for (size_t i = 0; i < v->program.part->n; i++)
        n += v->map.region[i] && v->map.deviation[i] > v->options.left + v->noise;
    return n;
}

/* Of all points that are to be cut, a share of them. */
static double share_of(const struct verdict *v, double all)
{
    return v->options.share > 0 ? (v->options.share + SHARE_ROUNDED) * all : 0;
}

size_t verify_may_be_left(const struct verdict *v)
{
    return (size_t)share_of(v, (double)v->asked);
}

static void say_reached(const struct verdict *v, char *text, size_t size)
{
    double area = v->coverage.sum[COVERAGE_LEFT].area;

    if (v->unseen > 0)
        snprintf(
            text, size,
            ", %.1f mm2 that the tool reaches, %zu only if no edge goes on that no point tells "
            "of, which may be as many again",
            area, v->unseen);
    else
        snprintf(text, size, ", %.1f mm2 that the tool reaches", area);
}

/* What is left beyond the limit, where the tool could have cut: a fault where it is a share of the
 * points that are judged, or at the border of a region far more than that; never of a part of a
 * program, for the others cut beside it. */
static void judge_left(struct verdict *v)
{
    const struct deviation_map *r = &v->map;
    const struct part_coverage_sum *left = &v->coverage.sum[COVERAGE_LEFT];
    bool whole = !v->options.partial;
    size_t at = whole ? left->at : r->over_at, n = whole ? left->points : left_in_region(v);
    double all = (double)(whole ? v->asked : r->cut);
    double border = whole || v->options.share == 0 ? 0 : RIM * sqrt(all);
    size_t most = (size_t)fmax(share_of(v, all), border);
    struct vec3 p = v->program.part->item[at];
    char what[150] = " of the region";
    if (n == 0 || !isfinite(v->options.left) || (whole && !comes_near(v)))
        return;
    if (whole)
        say_reached(v, what, sizeof what);
    double bordering = BORDER * v->options.left + v->noise;
    bool far = !whole && r->over > bordering;
    bool many = n - v->unseen > most || n > JUDGED_SCAN_UNSEEN * most;
    double limit = whole ? v->limit : far && n <= most ? bordering : v->options.left;
    struct more_than text = more_than(whole ? left->worst : r->over, limit);
    finding_add(v, (far || many) && !v->program.of_whole, piece_at(v, at),
                "%s mm of material is left at %.3f %.3f %.3f, at most %s (%zu points%s; %zu points "
                "may be%s)",
                text.more, p.x, p.y, p.z, text.limit, n, what, most,
                v->program.of_whole ? "; another part may cut it" : "");
}

static void judge_surface(struct verdict *v)
{
    const struct deviation_map *r = &v->map;
    struct vec3 p = v->program.part->item[r->gouge_at];
    if (r->gouge > v->options.tolerance + v->noise) {
        struct more_than text = more_than(r->gouge, v->options.tolerance);
        finding_add(v, true, piece_at(v, r->gouge_at),
                    "the ball is %s mm deep in the part at %.3f %.3f %.3f, tolerance %s", text.more,
                    p.x, p.y, p.z, text.limit);
    }
    judge_left(v);
    if (v->steep.depth > 0) {
        struct more_than text = more_than(v->steep.depth, v->options.tolerance);
        p = v->steep.at;
        finding_add(v, true, v->steep.piece,
                    "the ball is %s mm deep between points of a steep flank at %.3f %.3f %.3f, "
                    "tolerance %s",
                    text.more, p.x, p.y, p.z, text.limit);
    }
    p = v->program.part->item[v->rapid.point];
    if (v->rapid.depth > 0)
        finding_add(v, true, v->rapid.piece,
                    "a rapid move goes %.3f mm deep through the part at %.3f %.3f %.3f",
                    v->rapid.depth, p.x, p.y, p.z);
}

static void judge_outliers(struct verdict *v)
{
    const struct verdict_outliers *o = &v->outliers;
    if (o->gouged > 0)
        finding_remark(
            v, false,
            "the ball is up to %.3f mm deep in %zu of %zu points taken for outliers, as at "
            "%.3f %.3f %.3f; they are not judged",
            o->depth, o->gouged, o->points, o->at.x, o->at.y, o->at.z);
}

/* The ball that the program's head says. */
static void judge_ball(struct verdict *v)
{
    double said = v->program.ball;
    if (said > 0 && fabs(said - v->options.radius) > ROUNDED)
        finding_remark(v, true, "the program's head says a ball of radius %g, it is judged with %g",
                       said, v->options.radius);
}

/* Letters and digits alone, of any case, as far as the shorter one goes: controls print few others,
 * and not all of a long name. */
static bool same_name(const char *a, const char *b)
{
    for (;; a++, b++) {
        while (*a && !isalnum((unsigned char)*a))
            a++;
        while (*b && !isalnum((unsigned char)*b))
            b++;
        if (!*a || !*b)
            return true;
        if (tolower((unsigned char)*a) != tolower((unsigned char)*b))
            return false;
    }
}

/* The machine that the program's head says. */
static void judge_machine(struct verdict *v)
{
    const char *said = v->program.made_for;
    if (said && *said && !same_name(said, v->program.machine))
        finding_remark(v, false, "the program's head says the machine %s, it is judged on %s (-m)",
                       said, v->program.machine);
}

/* Shaft (what is no thicker than the ball) or holder in the part, or in the stock. */
static void judge_holder(struct verdict *v, const struct holder_collision *found, const char *what)
{
    if (!(found->depth > 0))
        return;
    bool fast = v->program.motion->piece.item[found->piece].rapid;
    finding_add(v, true, found->piece,
                "the %s goes %.3f mm deep into the %s at %.3f %.3f %.3f%s, %.1f mm up the tool "
                "(blocks: %zu)",
                found->width > v->options.radius * (1 + THICKER) ? "holder" : "shaft", found->depth,
                what, found->at.x, found->at.y, found->at.z, fast ? ", in a rapid move" : "",
                found->height, found->pieces);
}

static void judge_under(struct verdict *v)
{
    const struct under_scan *u = &v->under;
    if (!(u->depth > 0))
        return;
    bool fast = v->program.motion->piece.item[u->piece].rapid;
    finding_add(v, true, u->piece,
                "the %s goes %.3f mm deep under the scan at %.3f %.3f %.3f%s (blocks: %zu)",
                u->height == 0                                 ? "ball"
                : u->width > v->options.radius * (1 + THICKER) ? "holder"
                                                               : "shaft",
                u->depth, u->at.x, u->at.y, u->at.z, fast ? ", in a rapid move" : "", u->pieces);
}

/* Where the ball is farthest off all of the part at feed, and where it is lowest. */
struct away {
    double far, low;
    size_t far_piece, low_piece;
};

static struct away find_away(const struct verdict *v, struct box part)
{
    const struct nc_motion *motion = v->program.motion;
    double radius = v->options.radius;
    struct away away = {.far = 0, .low = HUGE_VAL};
    for (size_t i = 0; i < motion->piece.n; i++)
        for (int k = 1; k <= AWAY_PLACES; k++) {
            struct vec3 c = nc_motion_ball(motion, i, (double)k / AWAY_PLACES, radius).p;
            double far = motion->piece.item[i].rapid ? 0 : sqrt(box_distance2(&part, c));
            double low = motion->piece.item[i].dark ? HUGE_VAL : c.z - radius;
            away.far_piece = far > away.far ? i : away.far_piece;
            away.low_piece = low < away.low ? i : away.low_piece;
            away.far = fmax(away.far, far);
            away.low = fmin(away.low, low);
        }
    return away;
}

/* Far off all of the part no link goes, and no row; far below all of its points nobody knows what
 * is there: the vice, the table.  A program of others may cut more than was scanned. */
static void judge_away(struct verdict *v)
{
    const struct vec3s *point = v->program.part;
    double radius = v->options.radius;
    if (point->n == 0)
        return;
    struct box part = box_around(point->item, point->n);
    struct away away = find_away(v, part);
    double below = isfinite(away.low) ? part.low.z - away.low : 0;
    if (away.far > box_diagonal(&part) + FAR_RADII * radius + FAR_MORE)
        finding_add(v, v->program.post >= 0, away.far_piece,
                    "the ball is %.1f mm off all of the part at feed", away.far);
    if (below > LOW_RADII * radius + LOW_MORE)
        finding_add(v, v->program.post >= 0, away.low_piece,
                    "the ball goes %.1f mm below the lowest point of the part", below);
}

static void judge_stock(struct verdict *v)
{
    const struct stock_simulate *run = &v->stock;
    if (run->rapid > 0)
        finding_add(v, true, run->rapid_piece,
                    "a rapid move goes %.3f mm deep into the stock at %.3f %.3f %.3f (blocks: %zu)",
                    run->rapid, run->rapid_at.x, run->rapid_at.y, run->rapid_at.z, run->rapids);
}

/* How the tool axis turns over one piece, radians. */
struct axis_turn {
    struct vec3 from, to; /* the axis at its ends */
    double most;          /* farthest from where it began */
    double length;        /* of the tip's path */
    bool on;              /* the ball touches the part in it */
};

/* From s0 to s1 of a piece. */
static struct axis_turn turn_of(const struct nc_motion *motion, const struct nc_piece *piece,
                                double s0, double s1)
{
    struct nc_motion_pose a = nc_motion_at(motion, piece, s0), b = nc_motion_at(motion, piece, s1);
    struct axis_turn turn = {a.a, b.a, vec_angle(a.a, b.a), vec_distance(a.p, b.p), false};
    if (vec_distance(piece->q[0], piece->q[1]) < STILL && piece->shape == SHAPE_LINE)
        return turn;
    for (int i = 1; i < TURN_STEPS; i++) {
        struct vec3 axis = nc_motion_at(motion, piece, s0 + (s1 - s0) * i / TURN_STEPS).a;
        turn.most = fmax(turn.most, vec_angle(a.a, axis));
    }
    return turn;
}

/* The jumps so far. */
struct axis_jumps {
    struct axis_turn before; /* ends where the next begins, if `follows` */
    bool follows;
    size_t count, last, worst; /* pieces: how many, the last and the worst of them */
    double most;
};

/* A turn of a piece, which jumps back alone or with the one before. */
static void add_turn(struct axis_jumps *j, struct axis_turn at, double radius, size_t piece)
{
    double turn = j->follows ? fmax(at.most, j->before.most) : at.most;
    double back = vec_angle(j->follows ? j->before.from : at.from, at.to);
    double length = at.length + (j->follows ? j->before.length : 0);
    bool on = at.on || (j->follows && j->before.on);
    j->before = at;
    if (!on || turn <= RADIANS(JUMP) || back >= turn / 2 || turn * radius <= ROLLS * length)
        return;
    j->count += j->count == 0 || j->last != piece;
    j->last = piece;
    j->worst = turn > j->most ? piece : j->worst;
    j->most = fmax(j->most, turn);
}

/*
 * Jumps of the tool axis with the ball on the part: it turns, in one block or two, and comes back
 * by more than half, half as fast again as where the ball rolls over an edge, 1 / R for each mm of
 * the tip.  A curve counts as several blocks: where it takes the axis over a rib and back, as many
 * short lines would, nothing jumps.
 */
static void judge_jumps(struct verdict *v)
{
    const struct centre_path *cut = &v->cut;
    struct axis_jumps jumps = {.before = {.on = false}};
    size_t last = SIZE_MAX - 1;
    for (size_t i = 0; i < cut->n;) {
        size_t piece = cut->item[i].piece;
        const struct nc_piece *p = &v->program.motion->piece.item[piece];
        int parts = p->shape == SHAPE_LINE ? 1 : CURVE_PARTS;
        bool on = false;
        for (; i < cut->n && cut->item[i].piece == piece; i++)
            on = on || cut->item[i].on;
        for (int k = 0; k < parts; k++) {
            struct axis_turn at =
                turn_of(v->program.motion, p, (double)k / parts, (k + 1.0) / parts);
            at.on = on;
            jumps.follows = k > 0 || piece == last + 1;
            add_turn(&jumps, at, v->options.radius, piece);
        }
        last = piece;
    }
    if (jumps.count > 0)
        finding_add(v, true, jumps.worst,
                    "the tool axis swings out by %.3f degrees and back on the part (blocks: %zu)",
                    DEGREES(jumps.most), jumps.count);
}

/* How far a curve may leave the points and come back.  Of a scan by a radius and by what points are
 * apart, where what it leaves is judged: a link over a hollow may be part of it.  Else as far as
 * makers keep the ball off where no point is on an edge, as if the upper side went on. */
static double excursion_band(const struct verdict *v)
{
    double spacing = v->program.surface ? v->program.surface->spacing : 0;
    bool judged = !v->options.partial && isfinite(v->options.left);
    double hollow = v->options.radius + spacing;
    return fmax(v->options.band, judged ? hollow : fmin(hollow, UNSEEN * spacing));
}

static void judge_excursions(struct verdict *v)
{
    const struct verify_surface *scan = v->program.surface;
    const struct excursion_options options = {v->options.radius, excursion_band(v)};
    const struct vec3s *part = v->program.part;
    struct vec3s both = {0};
    if (scan && scan->steep.n > 0) {
        vec3s_add(&both, part->item, part->n);
        vec3s_add(&both, scan->steep.item, scan->steep.n);
        part = &both;
    }
    struct excursion out =
        excursion_find(v->program.motion, &v->cut, part->item, part->n, &options);
    array_free(&both);
    if (out.count > 0)
        finding_add(
            v, true, out.piece,
            "the ball leaves the part amid a cut, %.3f mm off it at %.3f %.3f %.3f (times: %zu)",
            out.height, out.at.x, out.at.y, out.at.z, out.count);
}

static void judge_axes(struct verdict *v)
{
    static const char letter[] = "XYZABC";
    const struct axis_use *use = &v->axes;
    if (use->beyond)
        finding_add(v, true, use->travel.piece,
                    "axis %c at %.3f is beyond its travel (blocks: %zu)", letter[use->travel.axis],
                    use->travel.value, use->beyond);
    if (use->unreachable)
        finding_add(v, true, use->unreachable_at,
                    "a tool axis that the machine's axes cannot reach");
    if (use->fast)
        finding_add(
            v, v->options.limits.strict || v->program.motion->piece.item[use->speed.piece].inverse,
            use->speed.piece,
            "axis %c would have to move at %.2f of its largest speed "
            "(blocks: %zu)",
            letter[use->speed.axis], use->speed.value, use->fast);
}

/* What the reader remarked, but for what the path asks for. */
static void judge_remarks(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    unsigned asked = motion->asked | (v->program.path ? v->program.path->asked : 0);
    for (size_t i = 0; i < motion->remark.n; i++) {
        const struct nc_remark *remark = &motion->remark.item[i];
        struct nc_piece at = {.line = remark->line, .block = remark->block};
        char place[60];
        if (remark->unless & asked)
            continue;
        ncread_place(&at, place, sizeof place);
        finding_remark(v, !remark->notice, "%s: %s", place, remark->text);
    }
}

/* How far the control may leave the path at corners: what -e or -p asks for, or else only told.  A
 * program of ncpost is held against its head by its reader. */
static void judge_rounding(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    double most = motion->rounding.most * (motion->unit > 0 ? motion->unit : 1);
    double may = v->program.rounding;
    struct nc_piece at = {.line = motion->rounding.line, .block = motion->rounding.block};
    char place[60], length[40] = "any length";
    bool more = most > may * (1 + ROUNDING_EVEN) + ROUNDED;
    if (most == 0 || (may > 0 && !more) || (v->program.ours && (may == 0 || most == HUGE_VAL)))
        return;
    ncread_place(&at, place, sizeof place);
    if (most < HUGE_VAL)
        snprintf(length, sizeof length, "%.4g mm", most);
    if (may > 0)
        finding_remark(v, true, "%s: corners may be rounded by %s, expected %.4g mm at most", place,
                       length, may);
    else
        finding_remark(v, false, "%s: corners may be rounded by %s", place, length);
}

/* A program against its path. */
static void judge_path(struct verdict *v)
{
    const struct nc_motion *path = v->program.path;
    double tip = v->program.post >= 0 ? v->program.post + PATH_TIP_MORE : PATH_TIP;
    double axis = v->program.axis >= 0 ? v->program.axis + PATH_AXIS_MORE : PATH_AXIS;
    double more = v->program.contact_feed ? PATH_CONTACT : 1;
    const struct path_compare_options options = {.radius = v->options.radius,
                                                 .tolerance = tip + TIP_ROUNDED,
                                                 .axis = RADIANS(axis + AXIS_ROUNDED),
                                                 .fast = PATH_FAST * more * (1 + FEED_ROUNDED),
                                                 .slow = PATH_SLOW * more * (1 + FEED_ROUNDED),
                                                 .limits = &v->options.limits,
                                                 .part = v->program.of_whole};
    struct path_compare found = path_compare_run(v->program.motion, path, &options);
    if (found.off.count > 0)
        finding_add(v, true, found.off.piece, "the tip is %.4f mm off the path at %.3f %.3f %.3f",
                    found.off.value, found.off.at.x, found.off.at.y, found.off.at.z);
    if (found.turned.count > 0)
        finding_add(v, true, found.turned.piece,
                    "the tool axis is %.3f degrees off the path's at %.3f %.3f %.3f",
                    DEGREES(found.turned.value), found.turned.at.x, found.turned.at.y,
                    found.turned.at.z);
    if (found.missed.count > 0)
        finding_add(v, true, found.missed.near,
                    "the program leaves out line %zu of the path, %.4f mm off it at %.3f %.3f %.3f",
                    path->piece.item[found.missed.piece].line, found.missed.value,
                    found.missed.at.x, found.missed.at.y, found.missed.at.z);
    if (found.beyond.count > 0)
        finding_add(v, false, 0,
                    "the program leaves out line %zu of the path, %.4f mm off it at %.3f %.3f "
                    "%.3f; another part may go there",
                    path->piece.item[found.beyond.piece].line, found.beyond.value,
                    found.beyond.at.x, found.beyond.at.y, found.beyond.at.z);
    if (found.fast.count > 0)
        finding_add(v, true, found.fast.piece, "the feed is %.4g times the path's",
                    found.fast.value);
    if (found.slow.count > 0)
        finding_add(v, true, found.slow.piece, "the feed is 1/%.4g of the path's",
                    found.slow.value);
}

/* What its makers knew of and this judge may not: as where a scan has no point on an edge. */
static void judge_unmet(struct verdict *v)
{
    if (v->program.unmet > 0)
        finding_remark(v, true, "its head says UNMET: %.205s%s", v->program.unmet_first,
                       v->program.unmet > 1 ? ", and more" : "");
}

void verify_judge(struct verdict *v)
{
    sum_pieces(v);
    judge_unmet(v);
    judge_remarks(v);
    judge_rounding(v);
    if (v->program.path)
        judge_path(v);
    verify_made(v);
    verify_rapid(v);
    if (v->map.points > 0)
        judge_surface(v);
    judge_outliers(v);
    judge_ball(v);
    judge_machine(v);
    judge_holder(v, &v->part_holder, "part");
    judge_under(v);
    judge_away(v);
    judge_stock(v);
    judge_holder(v, &v->stock.holder, "stock");
    judge_axes(v);
    judge_jumps(v);
    judge_excursions(v);
    verify_swerve(v);
    if (v->cut.n == 0 && v->program.motion->piece.n > 0)
        finding_add(v, v->options.left < HUGE_VAL, 0,
                    "nothing is cut, all moves are rapid"); /* a part of many */
    else if (!comes_near(v) && v->program.motion->piece.n > 0)
        finding_add(v, !v->program.of_whole, 0, "the ball comes near no point of the part%s",
                    v->program.of_whole ? "; another layer may" : "");
}
