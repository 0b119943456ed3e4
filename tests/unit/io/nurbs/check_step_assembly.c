/* step_assembly: representations that a relation makes one have one leader, others their own; a
 * component names its axes and those of its place; a placing and its inverse cancel. */
#include "io/nurbs/step_assembly.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "scratch.h"

static struct step step;
static struct step_assembly assembly;
static struct error error;

static void teardown(void)
{
    step_assembly_free(&assembly);
    step_free(&step);
}

static void read_data(const char *data)
{
    char text[4000];
    struct reader r;
    snprintf(text, sizeof text,
             "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n%sENDSEC;\n"
             "END-ISO-10303-21;\n",
             data);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_msg(step_read(&r, &step, &error) == 0, "%s", error.text);
    reader_close(&r);
    ck_assert_msg(step_assembly_read(&step, &assembly, &error) == 0, "%s", error.text);
}

/* 1 is 2, and 2 is 3; 5 is alone. */
START_TEST(one_and_the_same)
{
    read_data("#1=SHAPE_REPRESENTATION('',(),$);\n#2=ADVANCED_BREP_SHAPE_REPRESENTATION('',(),$);\n"
              "#3=SHAPE_REPRESENTATION('',(),$);\n#5=SHAPE_REPRESENTATION('',(),$);\n"
              "#8=SHAPE_REPRESENTATION_RELATIONSHIP('','',#1,#2);\n"
              "#9=SHAPE_REPRESENTATION_RELATIONSHIP('','',#3,#2);\n");
    ck_assert_uint_eq(assembly.component.n, 0);
    long leader = step_assembly_leader(&assembly, 1);
    ck_assert(leader >= 1 && leader <= 3);
    ck_assert_int_eq(step_assembly_leader(&assembly, 2), leader);
    ck_assert_int_eq(step_assembly_leader(&assembly, 3), leader);
    ck_assert_int_eq(step_assembly_leader(&assembly, 5), 5);
    ck_assert(!step_assembly_is_alias(&assembly, 5));
}
END_TEST

/* The component 1 in 2: its axes come to lie on those that the relation names second. */
START_TEST(a_component)
{
    read_data("#1=SHAPE_REPRESENTATION('',(#14),$);\n#2=SHAPE_REPRESENTATION('',(#15),$);\n"
              "#10=CARTESIAN_POINT('',(1.,0.,0.));\n#11=CARTESIAN_POINT('',(10.,20.,30.));\n"
              "#12=DIRECTION('',(0.,0.,1.));\n#13=DIRECTION('',(0.,1.,0.));\n"
              "#16=DIRECTION('',(1.,0.,0.));\n#14=AXIS2_PLACEMENT_3D('',#10,#12,#16);\n"
              "#15=AXIS2_PLACEMENT_3D('',#11,#12,#13);\n"
              "#17=ITEM_DEFINED_TRANSFORMATION('','',#14,#15);\n"
              "#18=(REPRESENTATION_RELATIONSHIP('','',#1,#2)"
              "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#17)"
              "SHAPE_REPRESENTATION_RELATIONSHIP());\n");
    ck_assert_uint_eq(assembly.component.n, 1);
    const struct step_component *c = &assembly.component.item[0];
    ck_assert_int_eq(c->relation, 18);
    ck_assert_int_eq(c->child, 1);
    ck_assert_int_eq(c->parent, 2);
    ck_assert_int_eq(c->child_axes, 14);
    ck_assert_int_eq(c->parent_axes, 15);
}
END_TEST

START_TEST(there_and_back)
{
    /* x to y, y to z, z to x, with a shift */
    const struct transform t = {{{0, 0, 1, 5}, {1, 0, 0, -7}, {0, 1, 0, 11}, {0, 0, 0, 1}}};
    struct transform back = step_assembly_inverse(&t);
    struct vec3 p = vec(1, 2, 3), q = transform_point(&t, p);
    ck_assert_double_lt(vec_distance(q, vec(8, -6, 13)), 1e-12);
    ck_assert_double_lt(vec_distance(transform_point(&back, q), p), 1e-12);
    struct transform both = transform_product(t, back);
    ck_assert(transform_is_identity(&both));
}
END_TEST

START_TEST(references_and_names)
{
    static const struct {
        const char *name;
        bool is;
    } row[] = {{"SHAPE_REPRESENTATION", true},
               {"REPRESENTATION", true},
               {"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION", false},
               {"REPRESENTATION_RELATIONSHIP", false},
               {"PRESENTATION", false}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct step_value record = {
            .kind = STEP_RECORD, .text = row[i].name, .length = strlen(row[i].name)};
        ck_assert_int_eq(step_is_representation(&record), row[i].is);
    }
    const struct step_value to = {.kind = STEP_REFERENCE, .number = 42};
    const struct step_value number = {.kind = STEP_NUMBER, .number = 42};
    ck_assert_int_eq(step_reference(&to), 42);
    ck_assert_int_eq(step_reference(&number), 0);
    ck_assert_int_eq(step_reference(NULL), 0);
    ck_assert(!step_is_representation(NULL));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step_assembly");
    TCase *tests = tcase_create("step_assembly");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, one_and_the_same);
    tcase_add_test(tests, a_component);
    tcase_add_test(tests, there_and_back);
    tcase_add_test(tests, references_and_names);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
