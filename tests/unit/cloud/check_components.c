/* components: pieces end at sharp edges and gaps; small ones go to those about them, but islands
 * stay. */
#include <check.h>
#include <stdlib.h>

#include "cloud/segment_steps.h"
#include "rough.h"

static const struct vec3 directions[] = {{0, 0, 1}, {0.6, 0, 0.8}};

/* Pieces of points with these labels; `of` is for the caller to free. */
static size_t pieces_of(const struct vec3s *p, int *label, bool settle, int **of)
{
    size_t *near = cloud_neighbours(p->item, p->n, 1);
    struct vec3 *normal = mem_alloc(p->n, sizeof *normal);
    struct components c = {p->n, near, normal, directions, label};
    struct ints found = {0};
    cloud_normals(p->item, p->n, near, vec(0, 0, 1), 1, normal);
    *of = mem_alloc(p->n, sizeof **of);
    if (settle)
        components_settle(&c);
    components_find(&c, *of, &found);
    size_t n = found.n;
    array_free(&found);
    free(normal);
    free(near);
    return n;
}

/* Two squares that meet at 90 degrees: one label, two pieces, the border where the edge is. */
START_TEST(a_sharp_edge_parts)
{
    struct vec3s p = {0};
    int *of, *label = mem_alloc(8000, sizeof *label);
    rectangle(&p, 4000, vec(0, 0, 0), vec(20, 0, 0), vec(0, 20, 0), 0);
    rectangle(&p, 4000, vec(0, 0, 0), vec(0, 20, 0), vec(0, 0, -20), 0);
    for (size_t i = 0; i < p.n; i++)
        label[i] = 0;
    ck_assert_uint_eq(pieces_of(&p, label, false, &of), 2);
    for (size_t i = 0; i < p.n; i++)
        ck_assert(of[i] == of[i < 4000 ? 0 : 4000] || hypot(p.item[i].x, p.item[i].z) < 0.1);
    free(of);
    free(label);
    array_free(&p);
}
END_TEST

/* A plane with labels astray, a patch too small to be a part (23 points in the mean, 47 by five
 * standard deviations, of which a hundredth of all is 60), and islands of 40 and 20 points. */
START_TEST(small_ones)
{
    struct vec3s p = {0};
    int *of, *label = mem_alloc(6060, sizeof *label);
    rectangle(&p, 6000, vec(0, 0, 0), vec(20, 0, 0), vec(0, 20, 0), 0);
    rectangle(&p, 40, vec(100, 0, 0), vec(2, 0, 0), vec(0, 2, 0), 0);
    rectangle(&p, 20, vec(0, 100, 0), vec(1, 0, 0), vec(0, 1, 0), 0);
    for (size_t i = 0; i < p.n; i++)
        label[i] = i % 50 == 7 || vec_distance(p.item[i], vec(8, 8, 0)) < 0.7;
    ck_assert_uint_eq(pieces_of(&p, label, true, &of), 2);
    for (size_t i = 0; i < p.n; i++) {
        ck_assert(i >= 6000 || of[i] == 0);
        ck_assert(i < 6000 || of[i] == (i < 6040 ? 1 : COMPONENT_NONE));
        ck_assert(i % 50 != 7 || i >= 6000 || label[i] == 0 ||
                  vec_distance(p.item[i], vec(8, 8, 0)) < 1.5);
    }
    free(of);
    free(label);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("components");
    TCase *tests = tcase_create("components");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_sharp_edge_parts);
    tcase_add_test(tests, small_ones);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
