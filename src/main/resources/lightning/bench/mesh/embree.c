/*
 * Traces rays against one mesh with Embree 3, on one thread, by commands on standard input, one answer a line:
 *
 *   mesh FILE        reads int32 vertices, int32 triangles, float[3 * vertices], int32[3 * triangles]; answers 0
 *   build THREADS    builds the tree; answers the seconds that pass and the bytes that it keeps
 *   rays FILE        reads int32 n, a multiple of 16, and the columns ox oy oz dx dy dz of n floats each; answers n
 *   nearest16        the nearest hits, packets of 16, coherent; answers seconds of processor time and how many rays hit
 *   blocked16        whether anything is hit before distance 1; answers alike
 *   nearest1         the nearest hits, single rays, incoherent; answers alike
 *   write FILE       the nearest hits of single rays: float distance, infinite for a miss, and int32 triangle of each ray; answers 0
 *
 * All numbers are little endian. The scene is robust: Embree's watertight mode.
 */
#include <embree3/rtcore.h>
#include <math.h>
#include <pmmintrin.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <xmmintrin.h>

static int32_t vertices, triangles, count;
static float *position, *column[6];
static int32_t *index_;
static int64_t kept;
static RTCDevice device;
static RTCScene scene;

static double seconds(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static bool count_bytes(void *user, ssize_t bytes, bool post) {
    __sync_fetch_and_add(&kept, bytes);
    return true;
}

static void *take(FILE *file, size_t bytes, size_t spare) {
    void *to = malloc(bytes + spare);
    if (!to || fread(to, 1, bytes, file) != bytes) {
        printf("cannot read\n");
        exit(1);
    }
    return to;
}

static FILE *opened(const char *name, const char *mode) {
    FILE *file = fopen(name, mode);
    if (!file) {
        printf("cannot open %s\n", name);
        exit(1);
    }
    return file;
}

static void mesh(const char *name) {
    FILE *file = opened(name, "rb");
    int32_t *head = take(file, 8, 0);
    vertices = head[0];
    triangles = head[1];
    free(head);
    /* Embree reads 16 bytes at the last vertex. */
    position = take(file, 12ll * vertices, 16);
    index_ = take(file, 12ll * triangles, 0);
    fclose(file);
}

static void rays(const char *name) {
    FILE *file = opened(name, "rb");
    int32_t *head = take(file, 4, 0);
    count = *head;
    free(head);
    for (int c = 0; c < 6; c++) {
        free(column[c]);
        column[c] = take(file, 4ll * count, 0);
    }
    fclose(file);
}

static double build(int threads) {
    char options[32];
    if (scene) {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    snprintf(options, sizeof options, "threads=%d", threads);
    device = rtcNewDevice(options);
    kept = 0;
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, NULL);
    double start = seconds(CLOCK_MONOTONIC);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry shape = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(shape, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, position, 0, 12, vertices);
    rtcSetSharedGeometryBuffer(shape, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, index_, 0, 12, triangles);
    rtcCommitGeometry(shape);
    rtcAttachGeometry(scene, shape);
    rtcReleaseGeometry(shape);
    rtcCommitScene(scene);
    return seconds(CLOCK_MONOTONIC) - start;
}

static struct RTCIntersectContext context(int coherent) {
    struct RTCIntersectContext c;
    rtcInitIntersectContext(&c);
    c.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return c;
}

static int nearest16(void) {
    struct RTCIntersectContext c = context(1);
    struct RTCRayHit16 r;
    _Alignas(64) int32_t valid[16];
    int hits = 0;
    memset(valid, -1, sizeof valid);
    for (int n = 0; n < count; n += 16) {
        memcpy(r.ray.org_x, column[0] + n, 64);
        memcpy(r.ray.org_y, column[1] + n, 64);
        memcpy(r.ray.org_z, column[2] + n, 64);
        memcpy(r.ray.dir_x, column[3] + n, 64);
        memcpy(r.ray.dir_y, column[4] + n, 64);
        memcpy(r.ray.dir_z, column[5] + n, 64);
        for (int i = 0; i < 16; i++) {
            r.ray.tnear[i] = 0;
            r.ray.tfar[i] = INFINITY;
            r.ray.mask[i] = -1;
            r.ray.time[i] = 0;
            r.ray.flags[i] = 0;
            r.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            r.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, scene, &c, &r);
        for (int i = 0; i < 16; i++) {
            hits += r.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        }
    }
    return hits;
}

static int blocked16(void) {
    struct RTCIntersectContext c = context(1);
    struct RTCRay16 r;
    _Alignas(64) int32_t valid[16];
    int hits = 0;
    memset(valid, -1, sizeof valid);
    for (int n = 0; n < count; n += 16) {
        memcpy(r.org_x, column[0] + n, 64);
        memcpy(r.org_y, column[1] + n, 64);
        memcpy(r.org_z, column[2] + n, 64);
        memcpy(r.dir_x, column[3] + n, 64);
        memcpy(r.dir_y, column[4] + n, 64);
        memcpy(r.dir_z, column[5] + n, 64);
        for (int i = 0; i < 16; i++) {
            r.tnear[i] = 0;
            r.tfar[i] = 1;
            r.mask[i] = -1;
            r.time[i] = 0;
            r.flags[i] = 0;
        }
        rtcOccluded16(valid, scene, &c, &r);
        for (int i = 0; i < 16; i++) {
            hits += r.tfar[i] < 0;
        }
    }
    return hits;
}

static int nearest1(FILE *answers) {
    struct RTCIntersectContext c = context(0);
    struct RTCRayHit r;
    int hits = 0;
    for (int n = 0; n < count; n++) {
        r.ray.org_x = column[0][n];
        r.ray.org_y = column[1][n];
        r.ray.org_z = column[2][n];
        r.ray.dir_x = column[3][n];
        r.ray.dir_y = column[4][n];
        r.ray.dir_z = column[5][n];
        r.ray.tnear = 0;
        r.ray.tfar = INFINITY;
        r.ray.mask = -1;
        r.ray.time = 0;
        r.ray.flags = 0;
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &c, &r);
        int hit = r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        hits += hit;
        if (answers) {
            float t = hit ? r.ray.tfar : INFINITY;
            int32_t triangle = hit ? (int32_t) r.hit.primID : -1;
            fwrite(&t, 4, 1, answers);
            fwrite(&triangle, 4, 1, answers);
        }
    }
    return hits;
}

static void timed(int hits, double start) {
    printf("%.9f %d\n", seconds(CLOCK_THREAD_CPUTIME_ID) - start, hits);
}

int main(void) {
    char line[4200], what[32], name[4096];
    /* As Embree's manual asks. */
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    while (fgets(line, sizeof line, stdin)) {
        int words = sscanf(line, "%31s %4095[^\n]", what, name);
        double start = seconds(CLOCK_THREAD_CPUTIME_ID);
        if (words == 2 && !strcmp(what, "mesh")) {
            mesh(name);
            printf("0\n");
        } else if (words == 2 && !strcmp(what, "build")) {
            double took = build(atoi(name));
            printf("%.9f %lld\n", took, (long long) kept);
        } else if (words == 2 && !strcmp(what, "rays")) {
            rays(name);
            printf("%d\n", count);
        } else if (!strcmp(what, "nearest16")) {
            timed(nearest16(), start);
        } else if (!strcmp(what, "blocked16")) {
            timed(blocked16(), start);
        } else if (!strcmp(what, "nearest1")) {
            timed(nearest1(NULL), start);
        } else if (words == 2 && !strcmp(what, "write")) {
            FILE *answers = opened(name, "wb");
            nearest1(answers);
            fclose(answers);
            printf("0\n");
        } else {
            printf("cannot do %s\n", what);
            return 1;
        }
        fflush(stdout);
    }
    return 0;
}
