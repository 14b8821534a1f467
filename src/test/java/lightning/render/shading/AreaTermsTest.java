package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.scene.Area;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.World;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Terms of all samples of a light that is larger than a point, and what is known of them beforehand. */
class AreaTermsTest {
    private static final int COUNT = 100;
    private static final int SAMPLES = 5;
    private static final double[] SHININESS = {0.5, 5, 14, 60, 180, 1e3, 1e6};

    private final HitRows rows = new HitRows(COUNT, false);
    private final RowWays ways = new RowWays();
    private final int[] may = RowBits.room();

    @Property
    void rowsAimedAtASample_haveTheCosineOfTheEquation(@ForAll Random random, @ForAll boolean scalar, @ForAll LightType type) {
        Lamp lamp = draw(random, type);
        Terms terms = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        int s = random.nextInt(SAMPLES);
        int[] which = RowBits.room();
        for (int i = 0; i < COUNT; i++) {
            if (random.nextInt(20) == 0) {
                RowBits.add(which, i);
            }
        }
        float[] cosine = new float[Terms.ROWS];
        int[] facing = RowBits.room();
        Arrays.fill(facing, -1);
        terms.aim(rows, lamp, s, ways.turn, which, cosine, facing);
        terms.lead(rows, lamp, s, which, ways);
        for (int i = 0; i < COUNT; i++) {
            float expected = cosine(lamp, i, s);
            assertThat(RowBits.contains(facing, i)).isEqualTo(RowBits.contains(which, i) && expected > 0);
            if (RowBits.contains(which, i)) {
                assertThat(Float.floatToRawIntBits(cosine[i])).isEqualTo(Float.floatToRawIntBits(expected));
                assertThat(new Vec3(ways.x[i], ways.y[i], ways.z[i])).isEqualTo(lamp.area().source((int) ways.turn[i], s));
            }
        }
    }

    @Property
    void rowThatMayFaceNoSample_facesNone(@ForAll Random random, @ForAll LightType type) {
        Lamp lamp = draw(random, type);
        Engines.LANES.terms().mayFace(rows, lamp, may);
        for (int i = 0; i < COUNT; i++) {
            for (int s = 0; s < SAMPLES && !RowBits.contains(may, i); s++) {
                assertThat(cosine(lamp, i, s)).isNotPositive();
            }
        }
    }

    @Property
    void rowThatMayShineForNoSample_hasNoHighlight(@ForAll Random random, @ForAll LightType type,
            @ForAll @IntRange(max = 6) int exponent) {
        Lamp lamp = draw(random, type);
        double shininess = SHININESS[exponent];
        Engines.LANES.terms().mayShine(rows, 0, COUNT, lamp, shininess, may);
        for (int i = 0; i < COUNT; i++) {
            for (int s = 0; s < SAMPLES && !RowBits.contains(may, i); s++) {
                assertThat(equation(lamp, i, s).specular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], shininess))
                        .isZero();
            }
        }
    }

    @Property
    void rowsTurnedAwayFromAllOfALight_areKnownAndDull(@ForAll Random random) {
        Lamp lamp = lamp(LightType.POINT, new Vec3(0, 3, 0), 0.3);
        Arrays.fill(rows.ny, -1);
        Arrays.fill(rows.vz, -1);
        rows.count = COUNT;
        Arrays.setAll(ways.turn, _ -> random.nextInt(LampArea.TURNS));
        Terms lanes = Engines.LANES.terms();
        lanes.mayFace(rows, lamp, may);
        assertThat(RowBits.count(may, COUNT)).isZero();
        // Seen along −z, a row that looks down mirrors −z, which is square to the light.
        lanes.mayShine(rows, 0, COUNT, lamp, 60, may);
        assertThat(RowBits.count(may, COUNT)).isZero();
    }

    private float cosine(Lamp lamp, int i, int s) {
        return equation(lamp, i, s).cosine(rows.nx[i], rows.ny[i], rows.nz[i]);
    }

    private LightingEquation equation(Lamp lamp, int i, int s) {
        LightingEquation equation = new LightingEquation(lamp.sample((int) ways.turn[i], s));
        equation.at(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
        return equation;
    }

    /** Rows of which many are on the edge of facing a sample, or of having a highlight, some of them in the light; sizes are log-uniform. */
    private Lamp draw(Random random, LightType type) {
        double size = type == LightType.DIRECTIONAL ? 90 * random.nextDouble() : StrictMath.pow(10, 8 * random.nextDouble() - 6);
        Vec3 center = unit(random).times(StrictMath.pow(10, 8 * random.nextDouble() - 4));
        Lamp lamp = lamp(type, center, size);
        rows.count = COUNT;
        for (int i = 0; i < COUNT; i++) {
            int turn = random.nextInt(LampArea.TURNS);
            ways.turn[i] = turn;
            Vec3 sample = lamp.area().source(turn, random.nextInt(SAMPLES));
            Vec3 away = unit(random).times(StrictMath.pow(10, 6 * random.nextDouble() - 3) * lamp.area().extent());
            boolean directional = type == LightType.DIRECTIONAL;
            Vec3 p = random.nextInt(20) == 0 ? sample : lamp.source().plus(away);
            rows.px[i] = (float) p.x();
            rows.py[i] = (float) p.y();
            rows.pz[i] = (float) p.z();
            Vec3 way = directional ? sample : sample.minus(new Vec3(rows.px[i], rows.py[i], rows.pz[i]));
            Vec3 side = way.cross(unit(random));
            Vec3 normal = side.length() > 0 && random.nextBoolean() ? leaning(random, side, way) : unit(random);
            rows.nx[i] = (float) normal.x();
            rows.ny[i] = (float) normal.y();
            rows.nz[i] = (float) normal.z();
            Vec3 view = unit(random);
            rows.vx[i] = (float) view.x();
            rows.vy[i] = (float) view.y();
            rows.vz[i] = (float) view.z();
        }
        return lamp;
    }

    /** Square to the way but for a little. */
    private static Vec3 leaning(Random random, Vec3 side, Vec3 way) {
        double little = (random.nextDouble() - 0.5) * StrictMath.pow(10, -9 * random.nextDouble());
        return side.normalized().plus(way.normalized().times(little)).normalized();
    }

    private static Vec3 unit(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    private static Lamp lamp(LightType type, Vec3 center, double size) {
        Area area = type == LightType.DIRECTIONAL ? new Area(0, Math.max(size, 0.01), 0, 0, Vec3.Y, SAMPLES)
                : new Area(size, 0, size, size, Vec3.Y, SAMPLES);
        Light light = Light.of("l", type).withPosition(center).withDirection(new Vec3(0.3, -1, 0.2)).withArea(area);
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return Lamp.of(light, new Scene(Picture.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }
}
