package lightning.render.shading.composition;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.LightWeight;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.WeightedLayer;
import lightning.render.trace.HitRows;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.ShapeGains;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Tests that sums over any range of the lights have the bits of the equation's tree. */
class LightSumTest {
    private static final int MOST = 40;
    private static final Stage STAGE = new Stage(List.of(), List.of(shape("a"), shape("b")));

    private final Random random = new Random(0);
    private int firstRow;
    private int rows;
    private int[] owners;
    private WeightedLight[] lights;
    private LightLayer[] layers;
    private int first;
    private int end;

    @Property(tries = 300)
    void lightSum_matchesTreeBits(@ForAll long seed, @ForAll boolean scalar, @ForAll boolean storesColors,
            @ForAll @IntRange(max = MOST) int count) {
        draw(seed, count, storesColors);
        assertTree(
                new LightSum((scalar ? Engines.SCALAR : Engines.LANES).sums()).total(firstRow, rows, owners, lights, layers, first, end));
    }

    private void draw(long seed, int count, boolean storesColors) {
        random.setSeed(seed);
        rows = 1 + random.nextInt(50);
        firstRow = random.nextInt(rows + 1);
        first = random.nextBoolean() ? 0 : random.nextInt(count + 1);
        end = random.nextBoolean() ? count : first + random.nextInt(count - first + 1);
        owners = random.ints(rows, 0, STAGE.shapeCount()).toArray();
        lights = new WeightedLight[count];
        layers = new LightLayer[count];
        for (int l = 0; l < count; l++) {
            lights[l] = light();
            layers[l] = layer(storesColors);
        }
    }

    private static Shape shape(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), Placement.IDENTITY);
    }

    private WeightedLight light() {
        double intensity = random.nextInt(4) == 0 ? 0 : random.nextDouble();
        Light light = Light.of("l", LightType.POINT).withIntensity(intensity)
                .withColor(new Rgb(random.nextDouble(), random.nextDouble(), random.nextInt(2))).withInfluence(contribution());
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        return WeightedLight.of(light, new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, STAGE, LightRig.of(List.of(light))));
    }

    private Influence contribution() {
        return random.nextBoolean() ? Influence.DEFAULT
                : new Influence(true, random.nextInt(3), random.nextInt(3), 1,
                        random.nextBoolean() ? ShapeGains.NONE : ShapeGains.of("a", random.nextInt(2) * random.nextDouble()));
    }

    private LightLayer layer(boolean storesColors) {
        if (random.nextInt(3) == 0) {
            return LightRows.unlit(new byte[rows]);
        }
        boolean specular = random.nextBoolean();
        boolean grazing = random.nextBoolean();
        if (storesColors) {
            return new Weighted(new float[][] {column(), column(), column()},
                    specular ? new float[][] {column(), column(), column()} : null,
                    grazing ? new float[][] {column(), column(), column()} : null);
        }
        LightRows untinted = LightRows.lit(new byte[rows], new LightRows.Terms(column(), specular ? column() : null,
                grazing ? column() : null, random.nextBoolean() ? column() : null), 1);
        return random.nextBoolean() ? untinted : untinted.withTint(new float[][] {column(), column(), column()});
    }

    /** Layer of contributions whose rows are all lit. */
    private static final class Weighted extends WeightedLayer {
        Weighted(float[][] diffuse, float[][] specular, float[][] grazing) {
            super(diffuse, specular, grazing);
        }

        @Override
        public boolean isUnreached() {
            return false;
        }

        @Override
        public byte[] states() {
            return new byte[0];
        }

        @Override
        public short[][] visibleSamples() {
            return null;
        }

        @Override
        public float[][] tint() {
            return null;
        }

        @Override
        public int litCount() {
            return 1;
        }

        @Override
        public long bytes() {
            return 0;
        }

        @Override
        public long newBytes(LightLayer before) {
            return 0;
        }

        @Override
        public long bytesReadByCompositing() {
            return 0;
        }

        @Override
        public long rowBytesRead(LightLayer before) {
            return 0;
        }
    }

    private float[] column() {
        float[] column = new float[HitRows.paddedLength(rows)];
        for (int i = 0; i < rows; i++) {
            column[i] = random.nextInt(4) == 0 ? 0 : random.nextFloat();
        }
        return column;
    }

    private void assertTree(SumColumns sum) {
        for (int i = firstRow; i < rows; i++) {
            for (int channel = 0; channel < 3; channel++) {
                assertSameBits(sum.diffuse()[channel][i], treeSum(i, channel, false), "diffuse");
                assertSameBits(sum.hasSpecular ? sum.specular()[channel][i] : 0, treeSum(i, channel, true), "specular");
            }
        }
    }

    private float treeSum(int row, int channel, boolean specular) {
        float[] terms = new float[lights.length];
        for (int l = 0; l < terms.length; l++) {
            terms[l] = lights[l].isDark() || layers[l].litCount() == 0 ? 0 : contribution(row, channel, specular, lights[l], layers[l]);
        }
        return LightingEquation.sum(terms, first, end);
    }

    private float contribution(int row, int channel, boolean specular, WeightedLight light, LightLayer layer) {
        return switch (layer) {
            case LightRows exact -> {
                float[] term = specular ? exact.specular : exact.cosine;
                LightWeight weight = specular ? light.specular() : light.diffuse();
                float tint = exact.tint == null ? 1 : exact.tint[channel][row];
                yield term == null ? 0 : LightingEquation.contribution(weight.channel(channel), term[row],
                        exact.falloff == null ? 1 : exact.falloff[row], tint * light.gain(owners[row]));
            }
            case WeightedLayer weighted -> {
                float[][] columns = specular ? weighted.specular : weighted.diffuse;
                yield columns == null ? 0 : columns[channel][row];
            }
        };
    }

    private static void assertSameBits(float actual, float expected, String term) {
        assertThat(Float.floatToRawIntBits(actual)).as(term + " " + actual + ", expected " + expected)
                .isEqualTo(Float.floatToRawIntBits(expected));
    }
}
