/*
 * hollow_edge: a roof of two facets, turned up or down, by its angle, which is known; seen from
 * either side, of one surface or of two, in any order of its places.
 */
#include <check.h>
#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/hollow_edge.h"

static const double RAD = 3.14159265358979323846 / 180;

struct roof {
    double rise;     /* degrees: of each side from its edge outwards */
    double far_rise; /* the same at the far end of the edge, of the normals */
    bool flipped, two;
    int order; /* 0, 1: which end of the edge has the lower place */
};

static void add_vertex(struct patch_mesh *q, struct vec3 point, double slope, int sheet,
                       size_t place)
{
    struct vec3 n = vec(-sin(slope * RAD), 0, cos(slope * RAD));

    *array_push(&q->vertex) =
        (struct patch_mesh_vertex){.point = point, .normal = n, .sheet = sheet, .place = place};
}

/* Two facets beside an edge along y, their normals upwards. */
static struct patch_mesh roof_of(struct roof r, bool flipped[2])
{
    struct patch_mesh q = {.sheets = r.two ? 2 : 1, .flipped = flipped};
    double h = 5 * tan(r.rise * RAD);
    size_t near = (size_t)r.order, far = 1 - near;

    flipped[0] = flipped[1] = r.flipped;
    for (int k = 0; k < 2; k++) {
        double way = k ? 1 : -1;
        struct vec3 end[2];
        end[near] = vec(0, 0, 0);
        end[far] = vec(0, 8, 0);
        for (size_t i = 0; i < 2; i++)
            add_vertex(&q, end[i], way * (i == near ? r.rise : r.far_rise), r.two ? k : 0, i);
        add_vertex(&q, vec(5 * way, 4, h), way * r.rise, r.two ? k : 0, 3 * (size_t)k + 2);
        int a = 3 * k + (int)near, b = 3 * k + (int)far, c = 3 * k + 2;
        *array_push(&q.face) = k ? (struct face){{b, a, c}} : (struct face){{a, b, c}};
        *array_push(&q.sheet) = r.two ? k : 0;
    }
    return q;
}

static void free_mesh(struct patch_mesh *q)
{
    array_free(&q->vertex);
    array_free(&q->face);
    array_free(&q->sheet);
}

START_TEST(by_the_angle_of_a_roof)
{
    static const struct {
        struct roof roof;
        double angle; /* degrees; 0: it is not hollow */
    } cases[] = {
        {{30, 30, false, false, 0}, 60},   {{30, 30, false, true, 1}, 60},
        {{-30, -30, false, true, 0}, 0},   {{-30, -30, true, true, 0}, 60},
        {{30, 30, true, false, 1}, 0},     {{60, 60, false, true, 0}, 120},
        {{-60, -60, true, false, 1}, 120}, {{0.6, 0.6, false, true, 0}, 1.2},
        {{0.4, 0.4, false, true, 0}, 0},   {{0, 0, false, true, 0}, 0},
        {{30, 0.4, false, true, 0}, 0},    {{30, 20, false, false, 1}, 40},
        {{-20, -30, true, false, 0}, 40},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bool flipped[2];
        struct patch_mesh q = roof_of(cases[i].roof, flipped);
        struct hollow_edge sharpest, *within = hollow_edges_find(&q, &sharpest);
        ck_assert_msg(fabs(sharpest.angle / RAD - cases[i].angle) < 1e-9, "%zu: %g", i,
                      sharpest.angle / RAD);
        ck_assert_double_eq(within[0].angle, cases[i].roof.two ? 0 : sharpest.angle);
        if (sharpest.angle > 0) {
            ck_assert_double_eq(vec_distance(sharpest.at, vec(0, 4, 0)), 0);
            ck_assert_int_eq(sharpest.sheet[0], 0);
            ck_assert_int_eq(sharpest.sheet[1], cases[i].roof.two);
        }
        free(within);
        free_mesh(&q);
    }
}
END_TEST

/* Of an edge with three facets nobody knows what is inside. */
START_TEST(no_edge_of_three)
{
    bool flipped[2];
    struct patch_mesh q = roof_of((struct roof){30, 30, false, false, 0}, flipped);
    struct hollow_edge sharpest;

    struct face again = q.face.item[0];
    *array_push(&q.face) = again;
    *array_push(&q.sheet) = 0;
    free(hollow_edges_find(&q, &sharpest));
    ck_assert_double_eq(sharpest.angle, 0);
    free_mesh(&q);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("hollow_edge");
    TCase *tests = tcase_create("hollow_edge");
    tcase_add_test(tests, by_the_angle_of_a_roof);
    tcase_add_test(tests, no_edge_of_three);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
