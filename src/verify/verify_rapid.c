/* verify_rapid - see verify_rapid.h. */
#include "verify_rapid.h"

#include "math/elementary.h"
#include "math/kdtree.h"
#include "ncread/ncread.h"
#include "verify_finding.h"
#include "verify_judge.h"

#define BESIDE 0.2       /* of the ball's radius: no rapid move stays so near to the part ... */
#define EVEN RADIANS(25) /* that a move at rapid goes on as the cut, at most */
#define ALONG 0.7        /* ... that leads up or down the tool by less of its length */
#define STRAIGHT 0.99    /* of its length that a way down the tool leads down it, at least */
#define NOSE 50.0        /* mm: no tool is shorter */
#define WAY 0.1          /* mm that a way is shorter than the head says: it has one decimal there */
#define LAST_BIT 1.0     /* mm: nearer to the part no rapid move comes back */
#define COMING 0.3       /* of its way that an approach comes nearer, at least, ... */
#define SLOWER 0.9       /* ... and so many times slower it is than what follows, at most */
#define PLUNGE 0.2    /* mm: so far down the tool it comes at feed, at least, to be off the part */
#define SAME_WAY 0.01 /* mm, and ... */
#define SAME_AXIS 0.0005 /* ... radians: by printed digits still the way on which the tool left */

/* The ball's centre at s of a piece. */
static struct vec3 ball_at(const struct verdict *v, size_t piece, double s)
{
    return nc_motion_ball(v->program.motion, piece, s, v->options.radius).p;
}

/* How far the ball is off the part there. */
static double off_part(const struct verdict *v, const struct kdtree *part, size_t piece, double s)
{
    struct vec3 centre = ball_at(v, piece, s);
    size_t index;
    double distance2;
    kdtree_nearest(part, centre, 1, &index, &distance2);
    return sqrt(distance2) - v->options.radius;
}

/* The same at both ends of a piece. */
struct off {
    double begin, end;
};

static struct off off_ends(const struct verdict *v, const struct kdtree *part, size_t piece)
{
    return (struct off){off_part(v, part, piece, 0), off_part(v, part, piece, 1)};
}

static const struct vec3 UP = {0, 0, 1};

/* The height of the part's highest point along `up`, mm. */
static double part_top(const struct verdict *v, struct vec3 up)
{
    double top = -HUGE_VAL;
    for (size_t i = 0; i < v->program.part->n; i++)
        top = fmax(top, vec_dot(v->program.part->item[i], up));
    return top;
}

/* How far the lowest point of the ball is below that at a piece's end; 0: above. */
static double below_top(const struct verdict *v, double top, struct vec3 up, size_t piece)
{
    double low = vec_dot(ball_at(v, piece, 1), up) - v->options.radius;
    return low < top - v->options.tolerance ? top - low : 0;
}

/* Rapid moves from a place that is not known to below the top of the part: the ball may come
 * through all of it.  Of programs that others wrote it is only told, for they may rest on more. */
static void judge_dark(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    double top = part_top(v, UP);
    for (size_t i = 0; i < motion->piece.n; i++) {
        const struct nc_piece *piece = &motion->piece.item[i];
        if (!piece->dark || !piece->rapid)
            continue;
        double below = below_top(v, top, UP, i);
        if (below == 0)
            continue;
        finding_add(v, v->program.post >= 0, i,
                    "a rapid move comes from a place that is not known to %.3f mm below the part's "
                    "top: an approach is missing",
                    below);
        return;
    }
}

/* What a scan guarded ends over all of it, however the tool stands, before it goes to a place of
 * the machine, of which nothing is known here. */
static void judge_end(struct verdict *v)
{
    size_t n = v->program.motion->piece.n;
    if (!v->program.guarded || n == 0 || v->cut.n == 0)
        return;
    double below = below_top(v, part_top(v, UP), UP, n - 1);
    if (below > 0)
        finding_add(v, true, n - 1,
                    "the program ends %.3f mm below the part's top: a retract is missing", below);
}

/* Z of the machine at a piece's end, where the part is: the tool, where all that turns are
 * tables. */
static struct vec3 machine_up(const struct verdict *v, size_t piece)
{
    const struct nc_motion *motion = v->program.motion;
    for (int i = 0; i < motion->kinematics.n; i++)
        if (!motion->kinematics.axis[i].table)
            return UP;
    return nc_motion_ball(motion, piece, 1, v->options.radius).a;
}

/* Moves that nothing follows, from below the part's top or to there.  Where the tool's length is
 * off Z is the spindle's: no program of ncpost goes so low. */
static void judge_blind(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    if (motion->blind.n == 0)
        return;
    struct vec3 up = UP; /* of the highest of the part that was asked for last */
    double top = part_top(v, UP), highest = top;
    double usual = v->program.post >= 0 ? NOSE : -v->options.tolerance;
    for (size_t i = 0; i < motion->blind.n; i++) {
        const struct nc_blind *blind = &motion->blind.item[i];
        struct nc_piece at = {.line = blind->line, .block = blind->block};
        char place[60];
        ncread_place(&at, place, sizeof place);
        double more = blind->nose ? NOSE : usual;
        if (blind->z_said && !blind->turned && blind->z < top + more) {
            finding_remark(v, true,
                           "%s: Z goes at rapid to %.3f without the tool's length, which was on "
                           "before, the part's top is at %.3f",
                           place, blind->z, top);
            return;
        }
        if (blind->z_said && blind->z < top + more) {
            finding_remark(v, true,
                           "%s: Z goes at rapid to %.3f without tool centre point control, the "
                           "rotary axes not known to be at zero, the part's top is at %.3f",
                           place, blind->z, top);
            return;
        }
        if (blind->z_said || blind->pieces == 0)
            continue;
        struct vec3 before = up;
        up = machine_up(v, blind->pieces - 1);
        highest = vec_distance(up, before) > 0 ? part_top(v, up) : highest;
        double below = below_top(v, highest, up, blind->pieces - 1);
        if (below > 0) {
            finding_remark(v, true,
                           "%s: X, Y or a rotary axis goes at rapid while the ball is %.3f mm "
                           "below the part's top: Z goes first",
                           place, below);
            return;
        }
    }
}

/* As long a way at rapid as its maker counted, or a retract or an approach was taken out, but for
 * the ends of moves, which are rounded: by the last digit a move.  More may be: some moves of the
 * axes alone are not counted. */
static void judge_way(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    double said = v->program.rapid, way = v->axes.rapid_length, off = WAY;
    double digit = v->options.digit * nc_motion_degree(motion);
    for (size_t i = 0; i < motion->piece.n; i++)
        off += motion->piece.item[i].rapid ? fmax(ROUNDED, digit) : 0;
    if (said - way > off)
        finding_remark(
            v, true,
            "its rapid moves are %.1f mm long, and %.1f by its head: a retract or an approach "
            "is missing",
            way, said);
}

/* How far a place is up the tool from where the tool left the part, mm; below 0: it is not on that
 * way, or the axis is another. */
static double up_the_way(struct nc_motion_pose left, struct nc_motion_pose at)
{
    struct vec3 off = vec_sub(at.p, left.p);
    bool same =
        vec_distance(at.a, left.a) <= SAME_AXIS && vec_length(vec_reject(off, left.a)) <= SAME_WAY;
    return same ? vec_dot(off, left.a) : -1;
}

/*
 * A rapid move down the tool to where it has just come up, the rotary axes having been turned
 * above: the last of the rapid moves the first of which left the part there.  That way is known to
 * be free, be there a wall beside it, but for its last bit.
 */
static bool comes_back(const struct verdict *v, size_t last)
{
    const struct nc_motion *motion = v->program.motion;
    const struct nc_piece *piece = motion->piece.item;
    size_t first = last;
    while (first > 0 && piece[first - 1].rapid)
        first--;
    if (first == 0 || first == last)
        return false;
    struct nc_motion_pose left = nc_motion_at(motion, &piece[first], 0);
    double up = up_the_way(left, nc_motion_at(motion, &piece[first], 1));
    double down = up_the_way(left, nc_motion_at(motion, &piece[last], 0));
    double end = up_the_way(left, nc_motion_at(motion, &piece[last], 1));
    return end >= LAST_BIT && up >= end && down >= end;
}

/* The way of a piece at its start or end. */
static struct vec3 course(const struct verdict *v, size_t piece, bool end)
{
    const double near = 1.0 / 64;
    return end ? vec_sub(ball_at(v, piece, 1), ball_at(v, piece, 1 - near))
               : vec_sub(ball_at(v, piece, near), ball_at(v, piece, 0));
}

/* A lone rapid move on the course of the cut before and after it, and no farther off the part than
 * the ball is thick: one block of the cut that has G0. */
static bool goes_on(const struct verdict *v, size_t piece, struct off off)
{
    const struct nc_motion *motion = v->program.motion;
    const struct nc_piece *p = &motion->piece.item[piece];
    double radius = v->options.radius;
    if (piece + 1 >= motion->piece.n || p[-1].rapid || p[1].rapid)
        return false;
    struct vec3 way = course(v, piece, false), axis = nc_motion_at(motion, p, 0).a;
    return vec_length(way) > 0 && fabs(vec_dot(way, axis)) < ALONG * vec_length(way) &&
           vec_angle(course(v, piece - 1, true), way) < EVEN &&
           vec_angle(course(v, piece, true), course(v, piece + 1, false)) < EVEN &&
           vec_distance(ball_at(v, piece, 0), ball_at(v, piece, 1)) < 2 * radius &&
           off.begin <= radius && off.end <= radius;
}

/* A rapid move that stays beside the part from end to end, across the tool. */
static bool goes_beside(const struct verdict *v, size_t piece, struct off off)
{
    const struct nc_motion *motion = v->program.motion;
    const struct nc_piece *p = &motion->piece.item[piece];
    struct nc_motion_pose a = nc_motion_at(motion, p, 0), b = nc_motion_at(motion, p, 1);
    double near = fmax(v->map.touch, BESIDE * v->options.radius);
    struct vec3 way = vec_sub(b.p, a.p);
    return vec_length(way) > ROUNDED && fabs(vec_dot(way, a.a)) < ALONG * vec_length(way) &&
           off.begin <= near && off.end <= near;
}

/* Straight down the tool at feed, nearer to the part by half of that way: a ball that was on the
 * part would be in it. */
static bool plunges(const struct verdict *v, size_t piece, struct off off)
{
    const struct nc_motion *motion = v->program.motion;
    const struct nc_piece *p = &motion->piece.item[piece];
    struct nc_motion_pose a = nc_motion_at(motion, p, 0);
    struct vec3 way = vec_sub(nc_motion_at(motion, p, 1).p, a.p);
    double down = -vec_dot(way, a.a);
    return p->shape == SHAPE_LINE && down >= PLUNGE && down >= STRAIGHT * vec_length(way) &&
           off.begin - fmax(0, off.end) >= down / 2;
}

/* mm/min along the ball's way. */
static double speed_of(const struct verdict *v, size_t piece)
{
    const struct nc_piece *p = &v->program.motion->piece.item[piece];
    double way = vec_distance(ball_at(v, piece, 0), ball_at(v, piece, 1));
    return p->inverse ? p->feed * way : p->feed;
}

/* More slowly than the cut goes on, and nearer to the part: an approach, from whatever side. */
static bool approaches(const struct verdict *v, size_t piece, struct off off)
{
    const struct nc_motion *motion = v->program.motion;
    double way = vec_distance(ball_at(v, piece, 0), ball_at(v, piece, 1));
    double nearer = off.begin - fmax(0, off.end);
    return way >= PLUNGE && nearer >= COMING * way && piece + 1 < motion->piece.n &&
           !motion->piece.item[piece + 1].rapid &&
           speed_of(v, piece) < SLOWER * speed_of(v, piece + 1);
}

/* From the end of a rapid move, so far off the part, the tool goes on at feed, nearer to the part:
 * between points far apart the ball may be as far off these when it is on it, but then it comes no
 * nearer. */
static bool comes_nearer(const struct verdict *v, const struct kdtree *part, size_t rapid,
                         double off)
{
    const struct nc_motion *motion = v->program.motion;
    size_t next = rapid + 1;
    if (next >= motion->piece.n || motion->piece.item[next].rapid)
        return false;
    struct off then = off_ends(v, part, next);
    return off - then.end > LAST_BIT || plunges(v, next, then) || approaches(v, next, then);
}

/*
 * Rapid moves that reach the part or go along it: where the ball was not on it already and leaves
 * it, nor comes back by the way on which it has just left, nor comes nearer yet at feed.  The last
 * move has to leave the part, too.
 */
static void judge_touches(struct verdict *v)
{
    const struct nc_motion *motion = v->program.motion;
    struct kdtree *part = kdtree_new(v->program.part->item, v->program.part->n);
    size_t n = motion->piece.n, touches = 0, first = 0, besides = 0, beside = 0;
    double on = v->map.touch;
    for (size_t i = 0; i < n; i++) {
        if (!motion->piece.item[i].rapid)
            continue;
        bool still = vec_distance(motion->piece.item[i].p[0], motion->piece.item[i].p[1]) == 0;
        struct off off = off_ends(v, part, i);
        bool begins = i > 0 && off.begin <= on;
        if (off.end <= on && !(still && begins) && !comes_back(v, i) &&
            !comes_nearer(v, part, i, off.end))
            first = touches++ == 0 ? i : first;
        else if (i > 0 && (goes_beside(v, i, off) || goes_on(v, i, off)))
            beside = besides++ == 0 ? i : beside;
    }
    if (touches > 0)
        finding_add(v, true, first, "a rapid move ends on the part (blocks: %zu)", touches);
    if (besides > 0)
        finding_add(v, true, beside, "a rapid move goes along beside the part (blocks: %zu)",
                    besides);
    if (n > 0 && v->cut.n > 0 && off_part(v, part, n - 1, 1) <= on)
        finding_add(v, true, n - 1, "the program ends on the part: no retract follows");
    kdtree_free(part);
}

void verify_rapid(struct verdict *v)
{
    judge_way(v);
    if (v->map.points == 0)
        return;
    judge_touches(v);
    judge_dark(v);
    judge_end(v);
    judge_blind(v);
}
