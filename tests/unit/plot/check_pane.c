/* pane: where the parts of a scene stand in a picture of ten px a mm, what hides what, and how each
 * is inked: the paths of the SVG read back, against places by hand. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/palette.h"
#include "plot/pane.h"
#include "scratch.h"

static struct scene scene;
static struct pane_options options;
static char *text;

/* One layer, 20 x 10 mm. */
static void setup(void)
{
    options = (struct pane_options){.marks = 1000, .tick = 2};
    *array_push(&scene) = (struct layer){0};
}

static void teardown(void)
{
    scene_free(&scene);
    free(text);
    text = NULL;
}

static void draw(void)
{
    struct pane pane = {.view = view_from(VIEW_PLAN),
                        .box = {{0, 0, 0}, {20, 10, 5}},
                        .x = 100,
                        .y = 50,
                        .scale = 10,
                        .options = &options};
    struct svg svg = {.out = out_open(scratch_name())};
    pane_draw(&pane, &scene, &svg);
    out_close(svg.out);
    free(text);
    text = scratch_read(&(size_t){0});
}

/* The points of the k-th path with this ink, in mm of the scene; z is 1 where a subpath begins. */
static struct vec3s path_of(const char *ink, int k)
{
    struct vec3s found = {0};
    const char *s = text;
    char command = 'M';
    double x = 0, y = 0;
    for (int i = 0; s && i <= k; i++)
        s = strstr(s + (i > 0), ink);
    s = s ? strstr(s, "d=\"") : NULL;
    if (!s)
        return found;
    for (s += 3; *s != '"';) {
        char *end;
        if (strchr("Mmlhz", *s)) {
            command = *s++;
            if (command == 'z' && found.n) {
                size_t first = found.n;
                while (found.item[--first].z == 0)
                    ;
                x = found.item[first].x, y = found.item[first].y;
            }
            continue;
        }
        if (*s == '\n') {
            s++;
            continue;
        }
        double dx = (double)strtol(s, &end, 10) / 100;
        s = end;
        double dy = command == 'h' ? 0 : (double)strtol(s, &end, 10) / 100;
        s = end;
        x += dx, y += dy;
        *array_push(&found) = vec(x, y, command == 'M' || command == 'm');
    }
    for (size_t i = 0; i < found.n; i++) /* from px / 10 of the picture */
        found.item[i] = vec(found.item[i].x - 10, 15 - found.item[i].y, found.item[i].z);
    return found;
}

static void expect(const char *ink, int k, size_t n, const double want[][3])
{
    struct vec3s found = path_of(ink, k);
    ck_assert_msg(found.n == n, "%s: %zu points, not %zu\n%s", ink, found.n, n, text);
    for (size_t i = 0; i < n; i++)
        ck_assert_msg(vec_distance(found.item[i], vec(want[i][0], want[i][1], want[i][2])) < 0.011,
                      "%s: %.2f %.2f %.0f", ink, found.item[i].x, found.item[i].y, found.item[i].z);
    array_free(&found);
}

static void add_stroke(enum stroke_kind kind, size_t n, const double at[][3])
{
    struct layer *layer = &scene.item[0];
    size_t from = layer->node.n;
    for (size_t i = 0; i < n; i++)
        *array_push(&layer->node) = vec(at[i][0], at[i][1], at[i][2]);
    *array_push(&layer->stroke) = (struct stroke){.kind = kind, .from = from, .to = from + n};
}

static void add_facet(const double p[3][3])
{
    struct mesh *mesh = &scene.item[0].mesh;
    int first = (int)mesh->vertex.n;
    for (int k = 0; k < 3; k++)
        *array_push(&mesh->vertex) = vec(p[k][0], p[k][1], p[k][2]);
    *array_push(&mesh->face) = (struct face){{first, first + 1, first + 2}};
}

#define LINE "stroke=\"#D55E00\" stroke-width=\"12\""
#define RAPID "stroke=\"#999999\" stroke-width=\"9\" stroke-dasharray=\"50 35\""

/* Points along a line are left out; the part of a rapid move that leaves the picture too. */
START_TEST(strokes)
{
    add_stroke(STROKE_LINE, 4, (const double[][3]){{1, 1, 0}, {3, 1, 0}, {7, 1, 0}, {7, 9, 0}});
    add_stroke(STROKE_RAPID, 2, (const double[][3]){{15, 5, 0}, {25, 5, 0}});
    draw();
    expect(LINE, 0, 3, (const double[][3]){{1, 1, 1}, {7, 1, 0}, {7, 9, 0}});
    expect(RAPID, 0, 2, (const double[][3]){{15, 5, 1}, {20, 5, 0}});
    ck_assert(strstr(text, RAPID) < strstr(text, LINE)); /* it lies below */
    ck_assert_ptr_null(strstr(text, "stroke=\"#0072B2\""));
}
END_TEST

/* A facet from x = 8 to 12 at z = 3 lies over a line at z = 0, not over one at z = 4. */
START_TEST(what_hides)
{
    add_facet((const double[][3]){{8, 0, 3}, {12, 0, 3}, {12, 10, 3}});
    add_facet((const double[][3]){{8, 0, 3}, {12, 10, 3}, {8, 10, 3}});
    add_stroke(STROKE_LINE, 2, (const double[][3]){{2, 5, 0}, {18, 5, 0}});
    add_stroke(STROKE_LINE, 2, (const double[][3]){{2, 7, 4}, {18, 7, 4}});
    draw();
    struct vec3s found = path_of(LINE, 0);
    ck_assert_uint_eq(found.n, 6);
    static const double want[] = {2, 8, 12, 18, 2, 18};
    for (size_t i = 0; i < 6; i++) {
        ck_assert_double_eq_tol(found.item[i].x, want[i], 0.21); /* looked at every 2 px */
        ck_assert_double_eq_tol(found.item[i].y, i < 4 ? 5 : 7, 0.011);
        ck_assert(found.item[i].z == (i % 2 == 0));
    }
    array_free(&found);
}
END_TEST

/* Wholly hidden facets are not drawn; those that are partly come first. */
START_TEST(facets)
{
    add_facet((const double[][3]){{4, 4, 3}, {10, 4, 3}, {4, 8, 3}});
    add_facet((const double[][3]){{4.5, 4.5, 0}, {6, 4.5, 0}, {4.5, 5, 0}});
    add_facet((const double[][3]){{1, 1, 0}, {9, 1, 0}, {1, 9, 0}});
    draw();
    struct vec3s first = path_of("fill=\"#", 0), second = path_of("fill=\"#", 1),
                 third = path_of("fill=\"#", 2);
    ck_assert_uint_eq(first.n, 3);
    ck_assert_double_lt(vec_distance(first.item[0], vec(1, 1, 1)), 0.011);
    ck_assert_uint_eq(second.n, 3);
    ck_assert_double_lt(vec_distance(second.item[0], vec(4, 4, 1)), 0.011);
    ck_assert_uint_eq(third.n, 0);
    array_free(&first);
    array_free(&second);
    array_free(&third);
    /* level: the light is 1.6 of sqrt(1 + 1.44 + 2.56) up; whichever way round the corners go */
    char shade[PALETTE_COLOUR];
    palette_shade(shade, (size_t)(32 * (1.6 / sqrt(5) + 0.35) / 1.35));
    ck_assert_ptr_nonnull(strstr(text, shade));
    scene.item[0].mesh.face.item[0] = (struct face){{0, 2, 1}};
    scene.item[0].mesh.face.n = 1;
    draw();
    ck_assert_ptr_nonnull(strstr(text, shade));
    /* steep ones, lit from the left and up, and away from it */
    scene.item[0].mesh.vertex.item[1] = vec(10, 4, 9);
    draw();
    struct vec3 n = vec_unit(vec(-1, 0, 1)), light = vec_unit(vec(-1, 1.2, 1.6));
    palette_shade(shade, (size_t)(32 * fmin(0.999, (vec_dot(n, light) + 0.35) / 1.35)));
    ck_assert_ptr_nonnull(strstr(text, shade));
}
END_TEST

/* More facets than can be told apart: cells of one shade, 1.5 px wide, which cover the same. */
START_TEST(cells)
{
    add_facet((const double[][3]){{2, 2, 0}, {18, 2, 0}, {2, 8, 0}});
    add_facet((const double[][3]){{18, 2, 0}, {18, 8, 0}, {2, 8, 0}});
    options.marks = 1;
    draw();
    char shade[PALETTE_COLOUR], ink[80];
    palette_shade(shade, (size_t)(32 * (1.6 / sqrt(5) + 0.35) / 1.35));
    snprintf(ink, sizeof ink, "fill=\"none\" stroke=\"%s\" stroke-width=\"17\"", shade);
    struct vec3s found = path_of(ink, 0);
    double area = 0;
    for (size_t i = 0; i + 1 < found.n; i += 2) {
        ck_assert(found.item[i].z == 1 && found.item[i + 1].z == 0);
        ck_assert_double_eq_tol(found.item[i].x, 2, 0.16);
        ck_assert_double_eq_tol(found.item[i + 1].x, 18, 0.16);
        ck_assert(found.item[i].y > 1.9 && found.item[i].y < 8.1);
        area += 0.15 * (found.item[i + 1].x - found.item[i].x);
    }
    ck_assert_double_eq_tol(area, 96, 3);
    array_free(&found);
}
END_TEST

/* In eleven colours from low to high; as many as there is room for. */
START_TEST(points)
{
    options.low = vec(0, 0, 0);
    options.high = vec(20, 10, 11);
    for (int i = 0; i < 11; i++)
        *array_push(&scene.item[0].point) = vec(1 + 1.5 * i, 5, i + 0.5);
    draw();
    for (size_t i = 0; i < PALETTE_HEIGHTS; i++) {
        char ink[40];
        snprintf(ink, sizeof ink, "stroke=\"%s\"", palette_height(i));
        expect(ink, 0, 2,
               (const double[][3]){{1 + 1.5 * (double)i, 5, 1}, {1 + 1.5 * (double)i, 5, 0}});
    }
    scene.item[0].point.n = 0;
    for (int j = 0; j < 80; j++)
        for (int i = 0; i < 160; i++)
            *array_push(&scene.item[0].point) = vec(0.125 * i + 0.06, 0.125 * j + 0.06, 0);
    draw();
    char ink[40];
    snprintf(ink, sizeof ink, "stroke=\"%s\"", palette_height(0));
    struct vec3s found = path_of(ink, 0);
    ck_assert_uint_le(found.n / 2, 1000);
    ck_assert_uint_gt(found.n / 2, 500);
    array_free(&found);
    /* of a layer by its own colour */
    options.by_layer = true;
    scene.item[0].point.n = 1;
    draw();
    expect("stroke=\"#0072B2\"", 0, 2, (const double[][3]){{0.06, 0.06, 1}, {0.06, 0.06, 0}});
}
END_TEST

START_TEST(ticks_dots_and_marks)
{
    struct layer *layer = &scene.item[0];
    *array_push(&layer->normal) = (struct tick){vec(4, 5, 0), vec(0.6, -0.8, 0)};
    *array_push(&layer->normal) = (struct tick){vec(4.01, 5, 0), vec(1, 0, 0)}; /* too near */
    *array_push(&layer->axis) = (struct tick){vec(9, 5, 0), vec(0, 1, 0)};
    *array_push(&layer->joint) = vec(15, 6, 0);
    *array_push(&scene.mark) = vec(10, 4, 0);
    add_stroke(STROKE_POLES, 2, (const double[][3]){{12, 2, 0}, {14, 2, 0}});
    draw();
    expect("#009E73", 0, 3, (const double[][3]){{4, 5, 1}, {4, 5, 0}, {5.2, 3.4, 0}});
    expect("#444444", 0, 3, (const double[][3]){{9, 5, 1}, {9, 5, 0}, {9, 7, 0}});
    ck_assert_ptr_null(strstr(text, "#222")); /* nobody asked for joints */
    expect("stroke=\"#CC79A7\" stroke-width=\"45\"", 0, 4,
           (const double[][3]){{12, 2, 1}, {12, 2, 0}, {14, 2, 1}, {14, 2, 0}});
    double h = 0.8 * sqrt(0.5);
    expect("#d00000", 0, 8,
           (const double[][3]){{10.8, 4, 1},
                               {10 + h, 4 - h, 0},
                               {10, 3.2, 0},
                               {10 - h, 4 - h, 0},
                               {9.2, 4, 0},
                               {10 - h, 4 + h, 0},
                               {10, 4.8, 0},
                               {10 + h, 4 + h, 0}});
    options.joints = true;
    draw();
    expect("#222", 0, 2, (const double[][3]){{15, 6, 1}, {15, 6, 0}});
}
END_TEST

START_TEST(inks)
{
    static const struct {
        bool by_pass, by_speed, by_layer;
        struct stroke stroke;
        size_t layer;
        const char *ink;
    } k[] = {
        {0, 0, 0, {.kind = STROKE_ARC, .number = 2}, 0, "stroke=\"#0072B2\" stroke-width=\"15\""},
        {0, 0, 0, {.kind = STROKE_ARC, .number = 3}, 0, "stroke=\"#56B4E9\" stroke-width=\"15\""},
        {1, 0, 0, {.kind = STROKE_ARC, .pass = 7}, 0, "stroke=\"#D55E00\" stroke-width=\"15\""},
        {1, 0, 0, {.kind = STROKE_RAPID, .pass = 7}, 0, RAPID},
        {0, 1, 0, {.kind = STROKE_LINE, .speed = 10}, 0, "stroke=\"#C2DF23\" stroke-width=\"12\""},
        {1, 1, 0, {.kind = STROKE_LINE, .speed = 0}, 0, "stroke=\"#440154\" stroke-width=\"12\""},
        {1, 1, 1, {.kind = STROKE_LINE}, 0, "stroke=\"#8FC9EE\" stroke-width=\"44\""},
        {0, 0, 1, {.kind = STROKE_SPLINE}, 2, "stroke=\"#009E73\" stroke-width=\"11\""},
        {0, 0, 1, {.kind = STROKE_POLES}, 2, "stroke=\"#CC79A7\" stroke-width=\"7\""},
        {0, 0, 1, {.kind = STROKE_RAPID}, 2, RAPID}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char ink[PANE_INK];
        options.by_pass = k[i].by_pass;
        options.by_speed = k[i].by_speed;
        options.by_layer = k[i].by_layer;
        pane_ink(&options, k[i].layer, &k[i].stroke, ink);
        ck_assert_str_eq(ink, k[i].ink);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("pane");
    TCase *tests = tcase_create("pane");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, strokes);
    tcase_add_test(tests, what_hides);
    tcase_add_test(tests, facets);
    tcase_add_test(tests, cells);
    tcase_add_test(tests, points);
    tcase_add_test(tests, ticks_dots_and_marks);
    tcase_add_test(tests, inks);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
