/* fuzz_reader - see fuzz_reader.h. */
#include "fuzz_reader.h"

#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "io/cloud/cloud.h"
#include "io/cloud/matrix.h"
#include "io/mesh/meshfile.h"
#include "io/nurbs/surfaces.h"
#include "io/path/path.h"
#include "machine/machine.h"
#include "ncread/ncread.h"
#include "scratch.h"
#include "stage/tool_file.h"

static void read_cloud(const char *file)
{
    struct vec3s points = {0};
    struct cloud_count count = {0};
    struct error error;
    cloud_read(file, 1, &points, &count, &error);
    array_free(&points);
}

static void read_matrix(const char *file)
{
    struct transform matrix;
    struct error error;
    matrix_read(file, &matrix, &error);
}

static void read_mesh(const char *file)
{
    struct mesh mesh = {0};
    struct error error;
    if (mesh_read(file, &mesh, &error) == 0)
        mesh_free(&mesh);
}

static void read_surfaces(const char *file)
{
    struct patches patches = {0};
    struct surfaces_unit unit;
    struct error error;
    surfaces_read(file, 0, &patches, &unit, &error);
    patches_free(&patches);
}

static void read_path(const char *file)
{
    struct path path = {0};
    struct error error;
    if (path_read(file, &path, &error) == 0)
        path_free(&path);
}

static void read_machine(const char *file)
{
    struct machine machine = machine_default();
    struct error error;
    if (machine_read(&machine, file, &error) == 0)
        machine_finish(&machine, &error);
}

static void read_control(const char *file)
{
    struct machine machine = machine_default();
    struct error error;
    if (machine_control(&machine, file, &error) == 0)
        machine_finish(&machine, &error);
}

static void read_tool(const char *file)
{
    struct tool_file tool = {0};
    struct tool_body body;
    struct error error;
    if (tool_file_read(&tool, file, &error) == 0)
        tool_file_body(&tool, tool.radius > 0 ? tool.radius : 4, &body, &error);
}

static void read_program(enum control_id control, const char *file)
{
    struct machine machine = machine_default();
    struct ncread_head head = {.ball = 0};
    struct nc_motion motion = {0};
    struct error error;
    if (machine_finish(&machine, &error) != 0)
        abort();
    struct ncread_options options = {.dialect = ncread_of(control),
                                     .tcp = true,
                                     .kinematics = ncread_kinematics(&machine),
                                     .head = &head};
    ncread_tell(file, &error);
    ncread_read(file, &options, &motion, &error);
    nc_motion_free(&motion);
}

static void read_fanuc(const char *file)
{
    read_program(CONTROL_fanuc, file);
}

static void read_siemens(const char *file)
{
    read_program(CONTROL_siemens, file);
}

static void read_heidenhain(const char *file)
{
    read_program(CONTROL_heidenhain, file);
}

static void read_linuxcnc(const char *file)
{
    read_program(CONTROL_linuxcnc, file);
}

static const struct fuzz_reader {
    const char *name;
    void (*read)(const char *file);
} readers[] = {{"cloud", read_cloud},
               {"ptx", read_cloud},
               {"pcd", read_cloud},
               {"las", read_cloud},
               {"obj", read_cloud},
               {"cloud-ply", read_cloud},
               {"matrix", read_matrix},
               {"ply", read_mesh},
               {"stl", read_mesh},
               {"off", read_mesh},
               {"iges", read_surfaces},
               {"step", read_surfaces},
               {"nurbs", read_surfaces},
               {"cl", read_path},
               {"cl-catia", read_path},
               {"cl-nx", read_path},
               {"cl-creo", read_path},
               {"cl-others", read_path},
               {"machine", read_machine},
               {"control", read_control},
               {"tool", read_tool},
               {"nc-fanuc", read_fanuc},
               {"nc-siemens", read_siemens},
               {"nc-heidenhain", read_heidenhain},
               {"nc-linuxcnc", read_linuxcnc}};

/* What ends the process (base/cli.h: no memory is left) ends the reading instead. */
static jmp_buf back;
static bool reading;

_Noreturn void __real_exit(int status);
_Noreturn void __wrap_exit(int status);

void __wrap_exit(int status)
{
    if (reading)
        longjmp(back, 1);
    __real_exit(status);
}

void fuzz_begin(void)
{
    static char tool[] = "fuzz", quiet[] = "-q";
    static char *argv[] = {tool, quiet, NULL};
    static const struct cli_option none[] = {{.name = NULL}};
    struct cli cli = {.tool = "fuzz", .option = none};
    cli_parse(&cli, 2, argv);
}

const struct fuzz_reader *fuzz_reader_of(const char *name)
{
    for (size_t i = 0; i < sizeof readers / sizeof *readers; i++)
        if (strcmp(readers[i].name, name) == 0)
            return &readers[i];
    return NULL;
}

void fuzz_read(const struct fuzz_reader *reader, const void *bytes, size_t n)
{
    const char *file = scratch_bytes(bytes, n);
    if (setjmp(back) == 0) {
        reading = true;
        reader->read(file);
    }
    reading = false;
}
