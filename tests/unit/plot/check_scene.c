/* scene, palette: the box of a layer by its parts, one at a time; colours by hand. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "plot/palette.h"
#include "plot/pane.h"
#include "plot/scene.h"

static struct layer layer;

static void box_is(struct box box, struct vec3 low, struct vec3 high)
{
    ck_assert_double_lt(vec_distance(box.low, low), 1e-12);
    ck_assert_double_lt(vec_distance(box.high, high), 1e-12);
}

static void add_stroke(enum stroke_kind kind, struct vec3 a, struct vec3 b)
{
    size_t from = layer.node.n;
    *array_push(&layer.node) = a;
    *array_push(&layer.node) = b;
    *array_push(&layer.stroke) = (struct stroke){.kind = kind, .from = from, .to = from + 2};
}

START_TEST(parts_of_a_layer)
{
    /* rapid moves alone count */
    add_stroke(STROKE_RAPID, vec(-50, 0, 0), vec(0, 60, 70));
    box_is(layer_box(&layer, 0), vec(-50, 0, 0), vec(0, 60, 70));
    /* beside anything else they do not */
    *array_push(&layer.point) = vec(1, 2, 3);
    box_is(layer_box(&layer, 0), vec(1, 2, 3), vec(1, 2, 3));
    add_stroke(STROKE_ARC, vec(0, 2, 3), vec(1, 2, 5));
    box_is(layer_box(&layer, 0), vec(0, 2, 3), vec(1, 2, 5));
    *array_push(&layer.mesh.vertex) = vec(1, -3, 4);
    box_is(layer_box(&layer, 0), vec(0, -3, 3), vec(1, 2, 5));
    /* ticks by the length that they are drawn in */
    *array_push(&layer.normal) = (struct tick){vec(1, 2, 5), vec(0.6, 0, 0.8)};
    *array_push(&layer.axis) = (struct tick){vec(0, 0, 3), vec(0, -1, 0)};
    box_is(layer_box(&layer, 10), vec(0, -10, 3), vec(7, 2, 13));
    layer_free(&layer);
    ck_assert_uint_eq(layer.point.n + layer.stroke.n + layer.axis.n, 0);
}
END_TEST

/* Of rapid moves what is within 7 % of the diagonal (here 50) is shown too. */
START_TEST(room_for_rapid_moves)
{
    struct scene scene = {0};
    struct view plan = view_from(VIEW_PLAN);
    *array_push(&layer.point) = vec(0, 0, 0);
    *array_push(&layer.point) = vec(30, 40, 0);
    add_stroke(STROKE_RAPID, vec(-2, 10, 0), vec(10, 100, 0));
    *array_push(&scene) = layer;
    box_is(scene_box(&scene, &plan, 0), vec(-2, 0, 0), vec(30, 43.5, 0));
    /* none of those that lie wholly elsewhere */
    scene.item[0].node.item[0] = vec(200, 200, 0);
    scene.item[0].node.item[1] = vec(300, 300, 0);
    box_is(scene_box(&scene, &plan, 0), vec(0, 0, 0), vec(30, 40, 0));
    /* seen from the front z is up */
    struct view front = view_from(VIEW_FRONT);
    scene.item[0].point.item[1] = vec(30, 40, 7);
    ck_assert_double_eq_tol(scene_box(&scene, &front, 0).high.y, 7, 1e-12);
    scene_free(&scene);
    ck_assert_uint_eq(scene.n, 0);
}
END_TEST

static unsigned long rgb(const char *colour)
{
    ck_assert_int_eq(colour[0], '#');
    ck_assert_uint_eq(strlen(colour), 7);
    return strtoul(colour + 1, NULL, 16);
}

START_TEST(colours)
{
    char a[PALETTE_COLOUR], b[PALETTE_COLOUR];
    /* all of a cycle differ, then it begins anew */
    for (size_t i = 0; i < PALETTE_CYCLE; i++) {
        ck_assert_str_eq(palette_cycle(i + PALETTE_CYCLE), palette_cycle(i));
        for (size_t k = 0; k < i; k++)
            ck_assert_str_ne(palette_cycle(i), palette_cycle(k));
    }
    /* viridis: each is lighter than the one below it, by the weights of its red, green and blue */
    double before = 0;
    for (size_t i = 0; i < PALETTE_HEIGHTS; i++) {
        unsigned long c = rgb(palette_height(i));
        double light = 0.2126 * (double)(c >> 16) + 0.7152 * (double)(c >> 8 & 255) +
                       0.0722 * (double)(c & 255);
        ck_assert_double_gt(light, before);
        before = light;
    }
    ck_assert_str_eq(palette_height(PALETTE_HEIGHTS), palette_height(PALETTE_HEIGHTS - 1));
    palette_shade(a, 0);
    ck_assert_str_eq(a, "#5C6876");
    palette_shade(a, PALETTE_SHADES - 1);
    ck_assert_str_eq(a, "#F0F3F6");
    for (size_t i = 1; i < PALETTE_SHADES; i++) {
        palette_shade(a, i - 1);
        palette_shade(b, i);
        ck_assert_uint_gt(rgb(b), rgb(a));
    }
    /* of #0072B2: half of each, and a quarter of each above three quarters of 255 */
    palette_tint(a, 0, 0);
    ck_assert_str_eq(a, "#003959");
    palette_tint(a, 0, PALETTE_SHADES - 1);
    ck_assert_str_eq(a, "#BFDBEB");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("scene");
    TCase *tests = tcase_create("scene");
    tcase_add_test(tests, parts_of_a_layer);
    tcase_add_test(tests, room_for_rapid_moves);
    tcase_add_test(tests, colours);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
