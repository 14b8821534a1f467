package lightning.render.shading.layer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.Tracer;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConeCullingTest {
    private static final Camera AT_ORIGIN = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);

    private static final Tracer TRACER = Engines.LANES.tracer(Geometry.of(scene(Light.of("l", LightType.POINT))));

    private static Scene scene(Light light) {
        return new Scene(PictureSettings.DEFAULT, AT_ORIGIN, World.DEFAULT, List.of(), List.of(), List.of(light));
    }

    /** Creates rows whose normals point up. */
    private static HitRows rows(Vec3... points) {
        HitRows rows = new HitRows(points.length, TexelColumns.NONE);
        rows.count = points.length;
        for (int i = 0; i < points.length; i++) {
            rows.px[i] = (float) points[i].x();
            rows.py[i] = (float) points[i].y();
            rows.pz[i] = (float) points[i].z();
            rows.ny[i] = 1;
        }
        return rows;
    }

    /** Tests a light at height 1 that shines straight down; the cone's half-angle is that of the farthest point it just reaches. */
    private static boolean reaches(double angle, Vec3... points) {
        Light down = Light.of("l", LightType.SPOT).withPosition(Vec3.Y).withDirection(Vec3.Y.negated()).withAngle(angle);
        return ConeCulling.canReach(LightSource.of(down, scene(down)), rows(points).bounds(TRACER));
    }

    @ParameterizedTest
    @CsvSource({"44.9, false", "45.1, true", "179, true", "1, false"})
    void pointAt45Degrees_isReachedOnlyByWiderCones(double angle, boolean reached) {
        assertThat(reaches(angle, new Vec3(1, 0, 0))).isEqualTo(reached);
    }

    @ParameterizedTest
    @CsvSource({"20, false", "50, true"})
    void groundBox_isReachedByConeOverNearestPart(double angle, boolean reached) {
        assertThat(reaches(angle, new Vec3(1, 0, 0), new Vec3(1.2, 0, 0.1))).isEqualTo(reached);
    }

    @ParameterizedTest
    @CsvSource({"0", "5", "90"})
    void boxBehindLight_isCulledUpToHalfSpace(double angle) {
        assertThat(reaches(angle, new Vec3(-0.1, 3, 0), new Vec3(0.1, 3.1, 0))).isFalse();
    }

    @ParameterizedTest
    @CsvSource({"0", "5", "90"})
    void boxAroundLight_isReached(double angle) {
        assertThat(reaches(angle, new Vec3(-1, 0, -1), new Vec3(1, 2, 1))).isTrue();
    }

    /**
     * Cones from empty through half-spaces to full, or as wide as a row's angle from the axis; boxes from single points up, near
     * the light and far away.
     */
    @Property
    void culledBox_containsNoPointInCone(@ForAll long seed, @ForAll @IntRange(min = -6, max = 8) int scale) {
        var random = new Random(seed);
        double size = Math.pow(10, scale);
        Light anywhere = Light.of("l", LightType.SPOT).withPosition(vector(random, size)).withDirection(vector(random, 1));
        for (int i = 0; i < 50; i++) {
            Vec3 at = anywhere.position().plus(vector(random, size * Math.pow(10, 1 - 9 * random.nextDouble())));
            Vec3[] points = new Vec3[1 + random.nextInt(20)];
            double spread = random.nextBoolean() ? 0 : size * Math.pow(10, -17 * random.nextDouble());
            Arrays.setAll(points, _ -> at.plus(vector(random, spread)));
            HitRows rows = rows(points);
            Light light = anywhere.withAngle(random.nextBoolean() ? angle(random) : edgeAngle(anywhere, rows, random));
            LightSource source = LightSource.of(light, scene(light));
            if (!ConeCulling.canReach(source, rows.bounds(TRACER))) {
                var equation = new LightingEquation(source);
                for (int p = 0; p < points.length; p++) {
                    equation.moveTo(rows.px[p], rows.py[p], rows.pz[p], rows.nx[p], rows.ny[p], rows.nz[p]);
                    assertThat(equation.insideCone()).isFalse();
                }
            }
        }
    }

    /** Returns a uniform angle, or 0, 45, 90, 135 or 180 degrees plus or minus a power of ten. */
    private static double angle(Random random) {
        double off = (random.nextBoolean() ? 1 : -1) * Math.pow(10, 1 - 16 * random.nextDouble());
        return random.nextInt(3) == 0 ? 180 * random.nextDouble() : Math.clamp(45 * random.nextInt(5) + off, 0, 180);
    }

    /** Returns the angle of the first row from the axis, in degrees, plus or minus a few roundings. */
    private static double edgeAngle(Light light, HitRows rows, Random random) {
        Vec3 toTarget = new Vec3(rows.px[0], rows.py[0], rows.pz[0]).minus(light.position());
        double cosine = toTarget.normalized().dot(light.direction().normalized());
        return Math.clamp(Math.toDegrees(Math.acos(Math.clamp(cosine, -1, 1))) * (1 + (random.nextInt(9) - 4) * 0x1p-52), 0, 180);
    }

    private static Vec3 vector(Random random, double size) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).times(size);
    }

    @ParameterizedTest
    @CsvSource({"44.9, 0, 0", "45.1, 1, 1"})
    void culledTile_usesNoMemoryAndNoRays(double angle, int rays, int stateBytes) {
        Light light = Light.of("l", LightType.SPOT).withPosition(Vec3.Y).withDirection(Vec3.Y.negated()).withAngle(angle);
        Geometry empty = Geometry.of(scene(light));
        var kernel = new LightKernel(empty, Engines.LANES.tracer(empty), Engines.LANES.terms(), ViewEffects.ALL);
        LightRows layer = kernel.recompute(rows(new Vec3(1, 0, 0)), LightSource.of(light, scene(light)), ColumnAllocator.NEW_ARRAYS);
        assertThat(kernel.shadowRays().getOrDefault("l", 0L)).isEqualTo(rays);
        assertThat(kernel.rowsTouched()).isEqualTo(rays);
        assertThat(layer.bytes(LightRows.Column.STATE)).isEqualTo(stateBytes);
    }

    @Test
    void forcedConeEffect_tracesEveryTile() {
        Light light = Light.of("l", LightType.SPOT).withPosition(Vec3.Y).withDirection(Vec3.Y.negated()).withAngle(10);
        Geometry empty = Geometry.of(scene(light));
        var kernel = new LightKernel(empty, Engines.LANES.tracer(empty), Engines.LANES.terms(),
                ViewEffects.ALL.withForced(List.of(RenderEffect.SPOT_CONE)));
        LightRows layer = kernel.recompute(rows(new Vec3(1, 0, 0)), LightSource.of(light, scene(light)), ColumnAllocator.NEW_ARRAYS);
        assertThat(kernel.rowsTouched()).isEqualTo(1);
        assertThat(layer.state(0)).isEqualTo(LightRows.OUTSIDE_CONE);
    }

    @ParameterizedTest
    @CsvSource({"1, 3", "-1, 0"})
    void culledRowInWidenedCone_isLitUnlessFacingAway(float up, int state) {
        Light narrow = Light.of("l", LightType.SPOT).withPosition(Vec3.Y).withDirection(Vec3.Y.negated()).withAngle(10);
        Geometry empty = Geometry.of(scene(narrow));
        var kernel = new LightKernel(empty, Engines.LANES.tracer(empty), Engines.LANES.terms(), ViewEffects.ALL);
        HitRows rows = rows(new Vec3(1, 0, 0));
        rows.ny[0] = up;
        LightRows before = kernel.recompute(rows, LightSource.of(narrow, scene(narrow)), ColumnAllocator.NEW_ARRAYS);
        Light wide = narrow.withAngle(80);
        LightRows after =
                kernel.update(rows, LightSource.of(wide, scene(wide)), before, ConeChange.ANGLE_ADD, false, ColumnAllocator.NEW_ARRAYS);
        assertThat(after.state(0)).isEqualTo(state);
    }
}
