/* path_coverage - see path_coverage.h. */
#include "stage/path_coverage.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/cli.h"
#include "coverage_judge.h"
#include "gouge/guard_mesh.h"
#include "math/kdtree.h"
#include "path_judged.h"
#include "stage/path_options.h"
#include "toolpath/rest_passes.h"
#include "toolpath/scallop.h"

enum { ROUNDS = 6 };

/* Of the points that are left: no round follows one that leaves so many of them. */
static const double STUCK = 0.9;

/* What rows of the mesh are measured by, which promise nothing, mm. */
static const double USUAL = 0.02;

/* Noises by which the surface that the points stand for may be off them. */
static const double SIGMAS = 1.5;

/* Of the limit as all stages leave it, those to come each with a tolerance of its own: a ball that
 * comes so near to a point could cut it.  So much of the limit of this one rest passes can. */
static const double SURE = 0.5, SOME = 0.8;

/* Of the radius: strips in planes are no shorter. */
static const double SHORT = 1;

/* Points on a mesh that are looked at, at most; where there are so many and nothing is promised,
 * vertices that stand closer than points have to are left out: rest passes need them all. */
static const double MOST = 300000;
enum { MANY = 50000 };

/* Points on a mesh: on its facets where nobody knows more of it. */
static void add_mesh(const struct mesh *mesh, double spacing, int threads, struct vec3s *to)
{
    bool facets = mesh->origin.scan.n == 0 && mesh->origin.surface.n == 0;
    const struct guard_mesh_options how = {spacing, MOST, facets ? GUARD_FLAT : GUARD_CURVED,
                                           threads};

    guard_points_of_mesh(mesh, NULL, &how, to);
}

/* Of very many points so many that each of the others has one of them within `gap`. */
static void add_thinned(double gap, const struct vec3s *from, struct vec3s *to)
{
    size_t n = from->n;
    struct box around;

    if (n < MANY) {
        vec3s_add(to, from->item, n);
        return;
    }
    struct gouge_check *all = gouge_from_points(from->item, n);
    bool *kept = mem_alloc(n, sizeof *kept);
    gouge_thinned(all, gap, kept, &around);
    for (size_t i = 0; i < n; i++)
        if (kept[i])
            *array_push(to) = from->item[i];
    free(kept);
    gouge_free(all);
}

/* The points that are to be cut: those of the scan, or points on the mesh half a row apart, or as
 * close ones on the facets of the meshes that guard, which c->facets gets.  False for these. */
static bool add_points(struct path_coverage *c, const struct mesh *region, int threads,
                       struct vec3s *to)
{
    const struct path_options *o = &path_options;
    struct vec3s on_mesh = {0};

    if (o->facets.n > 0) {
        add_thinned(2 * c->spacing, &o->facets, &c->facets);
        vec3s_add(to, c->facets.item, c->facets.n);
        return false;
    }
    vec3s_add(to, o->certain.item, o->certain.n);
    vec3s_add(to, o->doubtful.item, o->doubtful.n);
    if (to->n > 0)
        return true;
    if (o->scallop > 0) {
        add_mesh(region, c->spacing, threads, to);
        return false;
    }
    add_mesh(region, c->spacing, threads, &on_mesh); /* nothing is promised: */
    add_thinned(2 * c->spacing, &on_mesh, to);       /* half a row apart in the mean */
    array_free(&on_mesh);
    return false;
}

/* The points of the scan alone, and what keeps a tool out from under them. */
static struct gouge_check *bare_guard(const struct vec3s *points, int threads)
{
    const struct vec3s *curtain = &path_options.curtain;
    struct vec3s all = {0};

    vec3s_add(&all, points->item, points->n);
    vec3s_add(&all, curtain->item, curtain->n);
    return gouge_new(all, threads);
}

/* Of a scan what is asked for. */
static void keep_region(struct vec3s *points)
{
    struct region region = path_options_points();
    size_t kept = 0;

    for (size_t i = 0; i < points->n && region_given(&region); i++)
        if (region_holds(&region, points->item[i]))
            points->item[kept++] = points->item[i];
    points->n = region_given(&region) ? kept : points->n;
}

/* What the mesh is off its scan is left, too; where that is more than all else it is said. */
static double spent_by(const struct mesh *mesh, const struct path_coverage *c)
{
    double spent = isfinite(mesh->origin.ledger) ? mesh->origin.ledger : 0;

    if (c->scallop > 0 && spent > c->scallop + c->tolerance)
        say("the mesh is up to %.3g mm off what it is of: so much may stay beside scallop and "
            "tolerance",
            spent);
    return spent;
}

struct path_coverage path_coverage_new(const struct mesh *mesh, const struct mesh *region,
                                       const struct toolpath *t)
{
    const struct path_options *o = &path_options;
    struct path_coverage c = {.scallop = o->scallop};
    double noise = fmax(o->noise, 0), h = c.scallop > 0 ? c.scallop : USUAL;
    struct vec3s points = {0};

    if (!t->lift.guard)
        return c;
    c.rule = &t->rule;
    c.tolerance = t->lift.tolerance;
    c.spacing = scallop_step(h, o->radius, 0) / 2;
    c.scan = add_points(&c, region, t->threads, &points);
    if (c.scan)
        c.bare = bare_guard(&points, t->threads);
    bool guarded = c.scan || o->facets.n > 0;
    c.part = region == mesh || guarded ? NULL : mesh;
    if (guarded)
        keep_region(&points);
    c.coverage = coverage_new(points.item, points.n, t->threads);
    c.vertex = kdtree_new_by(mesh->vertex.item, mesh->vertex.n, t->threads);
    array_free(&points);
    c.rows = h + SIGMAS * noise + spent_by(mesh, &c);
    c.allowed = c.rows + c.tolerance;
    double limit = h + c.tolerance + SIGMAS * noise;
    c.options = (struct coverage_options){
        .guard = c.bare ? c.bare : t->lift.guard,
        .assumed = c.bare ? t->lift.guard : NULL,
        .holder = &t->rule.holder,
        .upright = o->body.ball_only && t->lift.axis.kind == AXIS_FIXED,
        .axis = t->lift.axis.direction,
        .radius = o->radius,
        .limit = limit,
        .near = fmin(SURE * (c.allowed + STAGES * c.tolerance), SOME * limit),
        .tolerance = t->lift.tolerance + noise / 2,
        .vertex = c.vertex,
        .normal = mesh->normal.item,
        .threads = t->threads};
    if (t->rule.chain.n < 2)
        c.options.axes = coverage_judge_axes(&t->rule.chain);
    return c;
}

void path_coverage_free(struct path_coverage *c)
{
    coverage_free(c->coverage);
    coverage_free(c->judged);
    gouge_free(c->bare);
    kdtree_free(c->vertex);
    array_free(&c->facets);
    array_free(&c->options.axes);
}

/* Strips over what is left become passes of the path. */
static void add_strips(const struct rest_strips *strips, struct toolpath *t)
{
    size_t pass = t->strip.n > 0 ? t->strip.item[t->strip.n - 1].pass : 0;

    for (size_t i = 0; i < strips->n; i++) {
        const struct rest_strip *strip = &strips->item[i];
        const struct contacts *c = &strip->contact;
        struct vec3 way = vec_sub(c->item[c->n - 1].p, c->item[0].p);
        struct vec3 along = vec_unit(vec(way.x, way.y, 0));
        bool forward = contacts_forward(c->item, c->n, strip->planes) >= 0;
        t->lift.feed.side = strip->planes;
        t->lift.feed.plane = vec_scale(forward ? 1 : -1, strip->planes);
        toolpath_strip(t, ++pass, c->item, c->n, vec_length(along) > 0 ? along : vec(1, 0, 0));
    }
}

/* Planes closer from round to round, across those of the passes and along them by turns. */
static struct rest_options options_of(const struct path_coverage *c, size_t round,
                                      struct vec3 planes)
{
    static const double part[ROUNDS] = {0.9, 0.7, 0.6, 0.5, 0.4, 0.3};
    double step = part[round] * scallop_step(c->scallop, c->options.radius, 0);

    return (struct rest_options){.planes = planes,
                                 .turned = round % 2 == 1,
                                 .rough = round > 1,
                                 .step = step,
                                 .gap = fmax(c->options.radius / 2, 2 * step),
                                 .longest = SHORT * c->options.radius};
}

void path_coverage_rest(struct path_coverage *c, struct vec3 planes, struct toolpath *t)
{
    if (!c->coverage || c->scallop == 0 || vec_length(planes) == 0)
        return;
    coverage_cut(c->coverage, &c->options, &t->swept, &t->swept_end);
    t->lift.offset = c->options.radius;
    t->rest = true;
    size_t left = coverage_report(c->coverage).left.n, before = SIZE_MAX;
    for (size_t round = 0; round < ROUNDS && left > 0 && (double)left < STUCK * (double)before;
         round++) {
        size_t n;
        before = round > 0 ? left : before; /* the first turn of planes need not be the right one */
        const struct coverage_point *point = coverage_points(c->coverage, &n);
        struct rest_options options = options_of(c, round, planes);
        struct rest_strips strips = rest_passes_find(point, n, &options);
        add_strips(&strips, t);
        toolpath_cut(t);
        coverage_cut(c->coverage, &c->options, &t->swept, &t->swept_end);
        note("rest passes: %zu strips for %zu points", strips.n, left);
        left = coverage_report(c->coverage).left.n;
        c->strips += strips.n;
        c->rounds++;
        rest_strips_free(&strips);
    }
}

/* Noise is taken out of a scan by the surfaces that guard, and by who judges in a way of its own:
 * where that puts a point elsewhere, more or less is left of it. */
static void measure_judged(struct path_coverage *c, const struct toolpath *t)
{
    struct vec3s points = {0};

    if (!c->scan || c->scallop == 0 || !(path_options.noise > 0))
        return;
    vec3s_add(&points, path_options.believed.item, path_options.believed.n);
    coverage_judge_settle(&points, c->options.radius, path_options.noise, c->options.threads);
    keep_region(&points);
    c->judged = coverage_new(points.item, points.n, c->options.threads);
    coverage_cut(c->judged, &c->options, &t->ball, &t->ball_end);
    array_free(&points);
}

static bool any_is_cut(const struct coverage *coverage)
{
    size_t n;
    const struct coverage_point *point = coverage_points(coverage, &n);

    for (size_t i = 0; i < n; i++)
        if (point[i].state == COVERAGE_CUT)
            return true;
    return n == 0;
}

/* Of a part of which nobody knows what is left: is the ball at any point of the scan? */
static bool touches_scan(const struct toolpath *t)
{
    const struct coverage_options options = {
        .radius = path_options.radius, .limit = t->lift.tolerance, .threads = t->threads};
    const struct vec3s *points = &path_options.believed;
    struct coverage *scan = coverage_new(points->item, points->n, t->threads);

    coverage_cut(scan, &options, &t->ball, &t->ball_end);
    bool touches = any_is_cut(scan);
    coverage_free(scan);
    return touches;
}

void path_coverage_measure(struct path_coverage *c, const struct toolpath *t)
{
    if (!c->coverage) {
        c->nothing = t->lift.guard && !touches_scan(t);
        return;
    }
    coverage_restart(c->coverage);
    coverage_cut(c->coverage, &c->options, &t->ball, &t->ball_end);
    c->nothing = !any_is_cut(c->coverage);
    measure_judged(c, t);
}

/* What who judges a program by the points takes for left: of a scan by all of its points. */
static struct path_verdicts judged_left(const struct path_coverage *c)
{
    size_t n;
    const struct coverage_point *point = coverage_points(c->coverage, &n);
    const struct vec3s *guard = c->scan ? &path_options.believed : &c->facets;
    struct vec3s place = {0};

    vec3s_add(&place, guard->item, guard->n);
    for (size_t i = 0; guard->n == 0 && i < n; i++)
        *array_push(&place) = point[i].p;
    if (c->part)
        add_mesh(c->part, c->spacing, c->options.threads, &place);
    struct path_verdicts verdicts = path_judged(c, &place);
    array_free(&place);
    return verdicts;
}

static void say_out(const struct coverage_report *r)
{
    struct vec3 at = r->out.at;

    if (r->out.n > 0)
        say("out of reach of ball and tool: %zu of %zu points, %.1f mm2, where up to %.3f mm "
            "stays, "
            "worst at %.3f %.3f %.3f",
            r->out.n, r->points, r->out.area, r->out.highest, at.x, at.y, at.z);
}

static void say_kept(const struct coverage_report *r, struct unmets *unmet)
{
    struct vec3 at = r->kept.at;

    if (r->kept.n > 0)
        unmet_say(
            unmet,
            "kept off by the surface between the points of the scan, which alone would let it "
            "by: %zu of %zu points (%.2f %%), %.1f mm2, up to %.3f mm, worst at %.3f %.3f %.3f",
            r->kept.n, r->points, 100 * (double)r->kept.n / (double)r->points, r->kept.area,
            r->kept.highest, at.x, at.y, at.z);
}

/* Rows that promise no scallop are as far apart as was asked for: nothing is too much between
 * them. */
static void say_left(const struct path_coverage *c, const struct coverage_report *r,
                     struct unmets *unmet)
{
    struct vec3 at = r->left.at;
    char most[64] = "the rows promise no scallop";

    if (c->scallop > 0)
        snprintf(most, sizeof most, "at most %g", path_options.left_share);
    if (r->left.n > 0)
        unmet_say(unmet,
                  "left though within reach: %zu of %zu points (%.2f %%, %s), %.1f mm2, more than "
                  "%.3f mm and up to %.3f mm, worst at %.3f %.3f %.3f",
                  r->left.n, r->points, 100 * (double)r->left.n / (double)r->points, most,
                  r->left.area, c->options.limit, r->left.highest, at.x, at.y, at.z);
}

static void say_judged(const struct path_coverage *c, const struct path_judged *judged,
                       struct unmets *unmet)
{
    const struct coverage_point *worst = &judged->worst;
    char unseen[96] = "";

    if (judged->unseen > 0)
        snprintf(unseen, sizeof unseen, " (%zu if no edge goes on that no point tells of)",
                 judged->unseen);
    if (judged->n > 0)
        unmet_say(unmet,
                  "who judges by the %s alone takes %zu of these for left though "
                  "within reach%s, beside %zu that are: up to %.3f mm, worst at %.3f %.3f %.3f",
                  c->scan ? "points of the scan" : "facets of the mesh", judged->n, unseen,
                  judged->left, worst->height, worst->p.x, worst->p.y, worst->p.z);
}

/* What a path leaves that no fitter follows, where that is more than may be. */
static void say_as_is(const struct path_coverage *c, const struct path_judged *judged,
                      struct unmets *unfitted)
{
    size_t points = coverage_report(c->coverage).points;
    size_t left = judged->left + path_judged_most(judged->n);

    unmet_later(unfitted,
                "without a fitter, whose tolerance makes up for it, up to %zu of %zu points (%.2f "
                "%%, at most %g) are left to who judges by the points: more than %.3f mm",
                left, points, 100 * (double)left / (double)points, path_options.left_share,
                judged->limit);
}

/* Who judges a program that cuts nothing refuses it. */
static int say_nothing(const struct path_coverage *c, struct unmets *unmet)
{
    if (!c->nothing)
        return EXIT_DONE;
    unmet_say(unmet, "nothing is cut: the ball comes to none of the points, expected a smaller one "
                     "or another part of them");
    return EXIT_UNMET;
}

int path_coverage_conclude(const struct path_coverage *c, struct path_head *head)
{
    int status = say_nothing(c, &head->unmet);
    if (!c->coverage)
        return status;
    struct coverage_report r = coverage_report(c->coverage);
    struct path_verdicts verdicts = {.worse = {.much = false}};
    if (c->scallop > 0)
        verdicts = judged_left(c);
    struct path_judged judged = verdicts.worse;
    bool unmet_left = judged.much;
    if (c->scallop > 0 && c->part) /* who judges it leaves no share */
        unmet_left = judged.n > 0 || (r.left.n > 0 && r.left.highest > c->allowed + c->tolerance);

    struct unmets *unmet = unmet_left ? &head->unmet : NULL;
    say_out(&r);
    say_kept(&r, unmet);
    say_left(c, &r, unmet);
    if (unmet_left || judged.more)
        say_judged(c, &judged, unmet);
    if (!unmet_left && verdicts.as_is.much)
        say_as_is(c, &verdicts.as_is, &head->unfitted);
    if (r.left.n == 0)
        note("all of %zu points within reach are cut to %.3f mm; %zu rest passes in %zu rounds",
             r.points, c->options.limit, c->strips, c->rounds);
    return unmet_left ? EXIT_UNMET : status;
}
