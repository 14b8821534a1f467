package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.TexelColumns;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.light.ObjectSurface;
import lightning.scene.node.Solid;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests the terms of all samples of an area light, and their conservative bounds. */
class AreaTermsTest {
    private static final int COUNT = 100;
    private static final int SAMPLES = 5;
    private static final double[] SHININESS = {0.5, 5, 14, 60, 180, 1e3, 1e6};

    private final HitRows rows = new HitRows(COUNT, TexelColumns.NONE);
    private final RowShadowRays ways = new RowShadowRays();
    private final int[] may = RowBits.allocate();

    @Property
    void rowsAimedAtSample_matchEquationCosine(@ForAll Random random, @ForAll boolean scalar, @ForAll LightType type) {
        LightSource source = draw(random, type);
        TermKernel terms = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        int s = random.nextInt(SAMPLES);
        int[] rowSet = RowBits.allocate();
        for (int i = 0; i < COUNT; i++) {
            if (random.nextInt(20) == 0) {
                RowBits.add(rowSet, i);
            }
        }
        float[] cosine = new float[TermKernel.MAX_ROWS];
        int[] facing = RowBits.allocate();
        Arrays.fill(facing, -1);
        terms.aim(rows, source, s, ways, rowSet, cosine, facing);
        terms.aimShadowRays(rows, source, s, rowSet, ways);
        for (int i = 0; i < COUNT; i++) {
            float expected = cosine(source, i, s);
            assertThat(RowBits.contains(facing, i)).isEqualTo(RowBits.contains(rowSet, i) && expected > 0);
            if (RowBits.contains(rowSet, i)) {
                assertThat(Float.floatToRawIntBits(cosine[i])).isEqualTo(Float.floatToRawIntBits(expected));
                assertThat(new Vec3(ways.x[i], ways.y[i], ways.z[i])).isEqualTo(source.centerSamples().position((int) ways.pattern[i], s));
            }
        }
    }

    @Property
    void metallicTermsOfSample_matchEquation(@ForAll Random random, @ForAll boolean scalar, @ForAll LightType type) {
        LightSource source = draw(random, type);
        TermKernel terms = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        int s = random.nextInt(SAMPLES);
        int[] all = RowBits.allocate();
        RowBits.add(all, 0, COUNT);
        int[] facing = RowBits.allocate();
        terms.aim(rows, source, s, ways, all, new float[TermKernel.MAX_ROWS], facing);
        float[] specular = new float[TermKernel.MAX_ROWS];
        float[] grazing = new float[TermKernel.MAX_ROWS];
        double alpha = StrictMath.pow(10, -3 * random.nextDouble());
        terms.metallicSpeculars(rows, 0, COUNT, facing, alpha, specular, grazing);
        for (int i = 0; i < COUNT; i++) {
            if (RowBits.contains(facing, i)) {
                LightingEquation equation = equation(source, i, s);
                assertThat(specular[i]).isEqualTo(
                        equation.metallicSpecular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], alpha));
                assertThat(grazing[i]).isEqualTo(
                        equation.metallicGrazing(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], alpha));
            }
        }
    }

    @Property
    void metallicTermsOfRowsOfDifferentRoughness_matchEquation(@ForAll Random random, @ForAll boolean scalar, @ForAll LightType type) {
        LightSource source = draw(random, type);
        TermKernel terms = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        int s = random.nextInt(SAMPLES);
        int[] all = RowBits.allocate();
        RowBits.add(all, 0, COUNT);
        int[] facing = RowBits.allocate();
        terms.aim(rows, source, s, ways, all, new float[TermKernel.MAX_ROWS], facing);
        float[] specular = new float[TermKernel.MAX_ROWS];
        float[] grazing = new float[TermKernel.MAX_ROWS];
        double[] alpha = random.doubles(TermKernel.MAX_ROWS, 0, 3).map(exponent -> StrictMath.pow(10, -exponent)).toArray();
        int from = random.nextInt(COUNT);
        terms.metallicSpeculars(rows, from, COUNT, facing, alpha, specular, grazing);
        for (int i = 0; i < COUNT; i++) {
            boolean isWritten = i >= from && RowBits.contains(facing, i);
            LightingEquation equation = equation(source, i, s);
            assertThat(specular[i]).isEqualTo(isWritten
                    ? equation.metallicSpecular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], alpha[i]) : 0);
            assertThat(grazing[i]).isEqualTo(isWritten
                    ? equation.metallicGrazing(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], alpha[i]) : 0);
        }
    }

    @Property
    void rowOutsideFacingBound_facesNoSample(@ForAll Random random, @ForAll LightType type) {
        LightSource source = draw(random, type);
        Engines.LANES.terms().addPossiblyFacing(rows, source, may);
        for (int i = 0; i < COUNT; i++) {
            for (int s = 0; s < SAMPLES && !RowBits.contains(may, i); s++) {
                assertThat(cosine(source, i, s)).isNotPositive();
            }
        }
    }

    @Property
    void rowOutsideHighlightBound_hasNoHighlight(@ForAll Random random, @ForAll LightType type,
            @ForAll @IntRange(max = 6) int exponent) {
        LightSource source = draw(random, type);
        double shininess = SHININESS[exponent];
        Engines.LANES.terms().addPossibleHighlights(rows, 0, COUNT, source, shininess, may);
        for (int i = 0; i < COUNT; i++) {
            for (int s = 0; s < SAMPLES && !RowBits.contains(may, i); s++) {
                assertThat(
                        equation(source, i, s).specular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], shininess))
                        .isZero();
            }
        }
    }

    @Property
    void rowsFacingAwayFromLight_areExcludedByBounds(@ForAll Random random) {
        LightSource source = lamp(LightType.POINT, new Vec3(0, 3, 0), 0.3);
        Arrays.fill(rows.ny, -1);
        Arrays.fill(rows.vz, -1);
        rows.count = COUNT;
        Arrays.setAll(ways.pattern, _ -> random.nextInt(AreaSamples.ROTATIONS));
        Arrays.setAll(ways.patternLanes, i -> ways.pattern[i]);
        TermKernel lanes = Engines.LANES.terms();
        lanes.addPossiblyFacing(rows, source, may);
        assertThat(RowBits.count(may, COUNT)).isZero();
        // Seen along −z, a row that faces down mirrors −z, which is perpendicular to the light.
        lanes.addPossibleHighlights(rows, 0, COUNT, source, 60, may);
        assertThat(RowBits.count(may, COUNT)).isZero();
    }

    private float cosine(LightSource source, int i, int s) {
        return equation(source, i, s).cosine(rows.nx[i], rows.ny[i], rows.nz[i]);
    }

    private LightingEquation equation(LightSource source, int i, int s) {
        LightingEquation equation = new LightingEquation(source.at(source.centerSamples(), ways.pattern[i], s));
        equation.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
        return equation;
    }

    /** Creates rows, many of which just face a sample or just have a highlight, some of them inside the light; sizes are log-uniform. */
    private LightSource draw(Random random, LightType type) {
        double size = type == LightType.DIRECTIONAL ? 90 * random.nextDouble() : StrictMath.pow(10, 8 * random.nextDouble() - 6);
        Vec3 center = unit(random).times(StrictMath.pow(10, 8 * random.nextDouble() - 4));
        LightSource source = lamp(type, center, size);
        rows.count = COUNT;
        for (int i = 0; i < COUNT; i++) {
            int rotation = random.nextInt(AreaSamples.ROTATIONS);
            ways.pattern[i] = rotation;
            ways.patternLanes[i] = rotation;
            Vec3 sample = source.centerSamples().position(rotation, random.nextInt(SAMPLES));
            Vec3 away = unit(random).times(StrictMath.pow(10, 6 * random.nextDouble() - 3) * source.centerSamples().extent());
            boolean directional = type == LightType.DIRECTIONAL;
            Vec3 p = random.nextInt(20) == 0 ? sample : source.position().plus(away);
            rows.px[i] = (float) p.x();
            rows.py[i] = (float) p.y();
            rows.pz[i] = (float) p.z();
            Vec3 toTarget = directional ? sample : sample.minus(new Vec3(rows.px[i], rows.py[i], rows.pz[i]));
            Vec3 side = toTarget.cross(unit(random));
            Vec3 normal = side.length() > 0 && random.nextBoolean() ? tilted(random, side, toTarget) : unit(random);
            rows.nx[i] = (float) normal.x();
            rows.ny[i] = (float) normal.y();
            rows.nz[i] = (float) normal.z();
            Vec3 view = unit(random);
            rows.vx[i] = (float) view.x();
            rows.vy[i] = (float) view.y();
            rows.vz[i] = (float) view.z();
        }
        return source;
    }

    /** Returns a direction almost perpendicular to the shadow ray. */
    private static Vec3 tilted(Random random, Vec3 side, Vec3 toTarget) {
        double little = (random.nextDouble() - 0.5) * StrictMath.pow(10, -9 * random.nextDouble());
        return side.normalized().plus(toTarget.normalized().times(little)).normalized();
    }

    private static Vec3 unit(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    private static LightSource lamp(LightType type, Vec3 center, double size) {
        AreaShape area = type == LightType.DIRECTIONAL ? new AreaShape(0, Math.max(size, 0.01), 0, 0, Vec3.Y, SAMPLES)
                : new AreaShape(size, 0, size, size, Vec3.Y, SAMPLES);
        if (type == LightType.OBJECT) {
            Transform place = Transform.translation(center).times(Transform.scaling(Vec3.ONE.times(size)));
            area = area.withSurface(Optional.of(new ObjectSurface(Solid.PLANE, place, Optional.empty(), null)));
        }
        Light light = Light.of("l", type).withPosition(center).withDirection(new Vec3(0.3, -1, 0.2)).withArea(area);
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return LightSource.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }
}
