package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import lightning.base.math.PowerFunction;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.engine.lanes.PowerLanes;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.HitRows;
import lightning.render.trace.TexelColumns;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.value.Attenuation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that vector lanes give the bits of the scalar code. */
class VectorLanesTest {
    private static final double[] EXPONENTS = {0, 1, 2, 0.5, 16, 37.25, 1e-6, 1e4, 1e6};

    @Property(tries = 200)
    void lanePowers_matchScalarBits(@ForAll Random random, @ForAll @IntRange(min = 1, max = 1024) int count) {
        double n = random.nextBoolean() ? EXPONENTS[random.nextInt(EXPONENTS.length)] : 100 * random.nextDouble();
        double[] x = new double[1024];
        double[] expected = new double[count];
        for (int i = 0; i < count; i++) {
            x[i] = switch (random.nextInt(8)) {
                case 0 -> 0;
                case 1 -> 1;
                case 2 -> Math.scalb(random.nextDouble(), -random.nextInt(1075));
                case 3 -> 1 - Math.scalb(random.nextDouble(), -random.nextInt(54));
                default -> random.nextDouble();
            };
            expected[i] = PowerFunction.pow(x[i], n);
        }
        PowerLanes.of(x, 0, count, n);
        for (int i = 0; i < count; i++) {
            assertThat(Double.doubleToRawLongBits(x[i])).as("power " + i).isEqualTo(Double.doubleToRawLongBits(expected[i]));
        }
    }

    @Property(tries = 300)
    void laneTerms_matchEquationBits(@ForAll Random random, @ForAll LightType type, @ForAll boolean scalar,
            @ForAll @IntRange(min = 1, max = 200) int count) {
        HitRows rows = rows(random, count);
        LightSource source = lamp(random, type, rows);
        double shininess = EXPONENTS[random.nextInt(EXPONENTS.length)];
        TermKernel lanes = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        float[] cosine = new float[1024];
        float[] specular = new float[1024];
        float[] falloff = new float[1024];
        lanes.aim(rows, source);
        lanes.cosines(rows, cosine);
        if (source.hasCone()) {
            lanes.computeConeCosines(rows, source);
        }
        int from = random.nextInt(count);
        int[] queried = RowBits.allocate();
        for (int i = 0; i < count; i++) {
            specular[i] = -1;
            if (random.nextBoolean()) {
                RowBits.add(queried, i);
            }
        }
        lanes.speculars(rows, from, count, queried, shininess, specular);
        int[] inside = RowBits.allocate();
        if (source.hasCone()) {
            lanes.selectInside(queried, count, source.cosAngle(), inside);
        }
        if (type.hasPosition()) {
            lanes.falloffs(rows, source, falloff);
        }
        LightingEquation equation = new LightingEquation(source);
        for (int i = 0; i < count; i++) {
            equation.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
            assertSameBits(cosine[i], equation.cosine(rows.nx[i], rows.ny[i], rows.nz[i]), "cosine");
            if (source.hasCone()) {
                assertThat(RowBits.contains(inside, i)).isEqualTo(RowBits.contains(queried, i) && equation.insideCone());
            }
            // The mask of a tube is not part of the lanes.
            if (type.hasPosition() && !AngularMask.isActive(source)) {
                assertSameBits(falloff[i], equation.falloff(), "falloff");
            }
            if (i < from || !RowBits.contains(queried, i)) {
                assertSameBits(specular[i], -1, "specular term of an unselected row");
            } else {
                assertSameBits(specular[i], equation.specular(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i],
                        rows.vz[i], shininess), "specular");
            }
        }
    }

    @Property(tries = 300)
    void anisotropicTerms_matchEquationBits(@ForAll Random random, @ForAll LightType type, @ForAll boolean scalar,
            @ForAll @IntRange(min = 1, max = 200) int count) {
        HitRows rows = rows(random, count);
        LightSource source = lamp(random, type, rows);
        Material material = Material.of("m").withModel(ShadingModel.PRINCIPLED)
                .withAnisotropy(new Anisotropy(random.nextBoolean() ? 1 : 0.01 + 0.9 * random.nextDouble(), 90 * random.nextGaussian()));
        AnisotropicHighlight highlight = ((Bsdf.Principled) Bsdf.of(material)).highlight();
        double[] alpha = new double[1024];
        float[] specular = new float[1024];
        float[] grazing = new float[1024];
        TermKernel terms = (scalar ? Engines.SCALAR : Engines.LANES).terms();
        terms.aim(rows, source);
        int from = random.nextInt(count);
        int[] queried = RowBits.allocate();
        for (int i = 0; i < count; i++) {
            alpha[i] = Material.alpha(random.nextDouble());
            specular[i] = -1;
            grazing[i] = -2;
            if (random.nextBoolean()) {
                RowBits.add(queried, i);
            }
        }
        terms.anisotropicSpeculars(rows, from, count, queried, highlight, alpha, specular, grazing);
        LightingEquation equation = new LightingEquation(source);
        for (int i = 0; i < count; i++) {
            boolean isSelected = i >= from && RowBits.contains(queried, i);
            equation.moveTo(rows.px[i], rows.py[i], rows.pz[i], rows.nx[i], rows.ny[i], rows.nz[i]);
            float[] tangent = {rows.tangentX[i], rows.tangentY[i], rows.tangentZ[i]};
            if (!isSelected || equation.cosine(rows.nx[i], rows.ny[i], rows.nz[i]) > 0) {
                double facets = equation.anisotropicFacets(rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i], rows.vz[i], tangent,
                        highlight, alpha[i]);
                double schlick = equation.schlick(rows.vx[i], rows.vy[i], rows.vz[i]);
                assertSameBits(specular[i], !isSelected ? -1 : (float) (facets * (1 - schlick)), "specular");
                assertSameBits(grazing[i], !isSelected ? -2 : (float) (facets * schlick), "grazing");
            }
        }
    }

    private static void assertSameBits(float actual, float expected, String term) {
        assertThat(Float.floatToRawIntBits(actual)).as(term + " " + actual + ", expected " + expected)
                .isEqualTo(Float.floatToRawIntBits(expected));
    }

    private static HitRows rows(Random random, int count) {
        HitRows rows = new HitRows(count, TexelColumns.TANGENTS);
        rows.count = count;
        for (int i = 0; i < count; i++) {
            rows.px[i] = 10 * random.nextFloat() - 5;
            rows.py[i] = 10 * random.nextFloat() - 5;
            rows.pz[i] = 10 * random.nextFloat() - 5;
            Vec3 n = unit(random);
            rows.nx[i] = (float) n.x();
            rows.ny[i] = (float) n.y();
            rows.nz[i] = (float) n.z();
            Vec3 t = n.cross(Math.abs(n.x()) < 0.6 ? new Vec3(1, 0, 0) : Vec3.Y).normalized();
            rows.tangentX[i] = (float) t.x();
            rows.tangentY[i] = (float) t.y();
            rows.tangentZ[i] = (float) t.z();
            Vec3 v = unit(random);
            rows.vx[i] = (float) v.x();
            rows.vy[i] = (float) v.y();
            rows.vz[i] = (float) v.z();
        }
        return rows;
    }

    /** Includes directions along the axes. */
    private static Vec3 unit(Random random) {
        return switch (random.nextInt(6)) {
            case 0 -> new Vec3(0, random.nextBoolean() ? 1 : -1, 0);
            case 1 -> new Vec3(0, 0, -1);
            default -> new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
        };
    }

    /** Sometimes the light is at a row's point. */
    private static LightSource lamp(Random random, LightType type, HitRows rows) {
        int row = random.nextInt(rows.count);
        Vec3 position = random.nextInt(3) == 0 ? new Vec3(rows.px[row], rows.py[row], rows.pz[row])
                : new Vec3(5 * random.nextGaussian(), 5 * random.nextGaussian(), 5 * random.nextGaussian());
        double[] angles = {0, 1e-3, 30, 90, 120, 180};
        Light light = Light.of("l", type).withPosition(position).withDirection(unit(random))
                .withAngle(angles[random.nextInt(angles.length)]).withDropoff(EXPONENTS[random.nextInt(EXPONENTS.length)])
                .withAttenuation(new Attenuation(random.nextInt(2), random.nextInt(2) * random.nextDouble(), random.nextInt(2)))
                .withArea(new AreaShape(0, 0, 0, 0, Vec3.Y, 4));
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return LightSource.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light)));
    }
}
