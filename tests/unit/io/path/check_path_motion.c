/*
 * path_motion: random arcs and helices in the words of Creo and of NX, against the circle they were
 * made on: where each motion goes, point by point, which way round and how many turns.
 */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "io/path/path.h"
#include "scratch.h"
#include "seed.h"

static uint64_t seed;

/* 0 <= x < 1 */
static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

static struct path read_text(const char *text)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(path_read(scratch_text(text), &path, &error) == 0, "%s", error.text);
    return path;
}

/* A helix about an axis: place and height at an angle from its start. */
struct helix {
    struct vec3 centre, axis, arm;
    double rise; /* a radian */
};

static struct vec3 on(const struct helix *h, double angle)
{
    struct vec3 p = vec_add(h->centre, vec_turn(h->arm, h->axis, angle));
    return vec_along(p, h->rise * angle, h->axis);
}

static struct helix any_helix(double rise)
{
    struct helix h = {.rise = rise};
    h.axis = vec_unit(vec(chance() - 0.5, chance() - 0.5, chance() - 0.5));
    h.centre = vec(100 * chance(), 100 * chance(), 100 * chance());
    h.arm = vec_scale(1 + 20 * chance(), vec_unit(vec_cross(h.axis, vec(0.3, 0.5, 0.8))));
    return h;
}

/* A radian; one of less than 0.01 mm in a turn, as the reader says, is none. */
static double some_rise(void)
{
    double rise = chance() - 0.5;
    return fabs(2 * PI * rise) > 0.011 ? rise : 0.1;
}

/* All the arcs of the path run along the helix, without a gap, to this angle. */
static void expect_along(const struct path *path, const struct helix *h, double angle)
{
    struct pose at = {on(h, 0), vec(0, 0, 1)};
    double done = 0;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind != PATH_ARC) {
            at = item->to;
            continue;
        }
        const struct path_arc *arc = &path->arc.item[item->index];
        struct motion m = motion_arc(at, item->to, arc->centre, arc->axis);
        for (int k = 0; k <= 10; k++)
            ck_assert_double_lt(
                vec_distance(motion_at(&m, k / 10.0).p, on(h, done + m.sweep * k / 10)), 2e-4);
        done += m.sweep;
        at = item->to;
    }
    ck_assert_double_eq_tol(done, angle, 1e-4);
}

static int put(char *end, const char *word, struct vec3 p)
{
    return sprintf(end, "%s%.7f,%.7f,%.7f", word, p.x, p.y, p.z);
}

START_TEST(right_handed)
{
    for (int i = 0; i < 300; i++) {
        seed = (uint64_t)i + 1;
        struct helix h = any_helix(i % 3 ? 0 : some_rise());
        double angle = i % 7 == 0 ? 2 * PI : 0.05 + 6.1 * chance();
        char text[800], *end = text;
        end += put(end, "GOTO/", on(&h, 0));
        end += put(end, "\nCIRCLE/", h.centre);
        end += put(end, ",", h.axis);
        end += i % 2 ? sprintf(end, ",%.7f", vec_length(h.arm)) : 0;
        end += put(end, "\nGOTO/", on(&h, angle));
        sprintf(end, "\nFINI\n");
        struct path path = read_text(text);
        expect_along(&path, &h, angle);
        path_free(&path);
    }
}
END_TEST

/* NX: clockwise, the centre as high as the start or as the end; the end is in the n-th turn. */
START_TEST(clockwise_turns)
{
    for (int i = 0; i < 300; i++) {
        seed = (uint64_t)i + 1;
        struct helix h = any_helix(some_rise());
        int turns = 1 + (int)(5 * chance());
        double angle = 2 * PI * (i % 3 == 0 ? turns : turns - 1 + 0.05 + 0.9 * chance());
        struct vec3 lift = vec_scale(i % 2 ? h.rise * angle : 0, h.axis);
        char text[800], *end = text;
        end += put(end, "GOTO/", on(&h, 0));
        end += put(end, "\nCIRCLE/", vec_add(h.centre, lift));
        end += put(end, ",", vec_scale(-1, h.axis));
        end += sprintf(end, ",%.7f,.06,.5,10,0,TIMES,%d", vec_length(h.arm), turns);
        end += put(end, "\nGOTO/", on(&h, angle));
        sprintf(end, "\nFINI\n");
        struct path path = read_text(text);
        expect_along(&path, &h, angle);
        path_free(&path);
    }
}
END_TEST

/* Creo lists points of an arc without a word; one that is off it ends the arc. */
START_TEST(points_on_the_arc)
{
    static const char list[] =
        "GOTO/5,0,0\nCIRCLE/0,0,0,0,0,1,5\nGOTO/3,4,0\n-3,4,0\n-5,0,0\n%s\nFINI\n";
    static const struct {
        const char *behind;
        size_t arcs;
    } trial[] = {{"-4,-3,0", 4}, {"-9,0,0", 3}, {"GOTO/-4,-3,0", 3}, {"-4,-3,1", 3}, {"-5,0,0", 3}};
    for (int creo = 0; creo <= 1; creo++)
        for (size_t i = 0; i < sizeof trial / sizeof *trial; i++) {
            char text[300];
            int n = sprintf(text, "%s", creo ? "$$* Pro/CLfile 8.0\n" : "");
            snprintf(text + n, sizeof text - (size_t)n, list, trial[i].behind);
            struct path path = read_text(text);
            ck_assert_uint_eq(path.arc.n, creo ? trial[i].arcs : 1);
            path_free(&path);
        }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_motion");
    TCase *tests = tcase_create("arcs");
    tcase_add_test(tests, right_handed);
    tcase_add_test(tests, clockwise_turns);
    tcase_add_test(tests, points_on_the_arc);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
