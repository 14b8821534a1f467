package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.PowerFunction;
import lightning.base.math.Rgb;
import lightning.render.engine.choice.Engines;
import lightning.render.shading.InteriorTint;
import lightning.render.trace.HitRows;
import lightning.render.trace.TexelColumns;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.Transmission;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Tests that lanes and loops compute the same bits for rows of transparent materials. */
class ClearTermLanesTest {
    private static final int ROWS = 77;

    @Property
    void lanes_matchLoops(@ForAll Random random) {
        HitRows rows = new HitRows(ROWS, TexelColumns.NONE, true, false, false);
        rows.count = ROWS;
        for (int i = 0; i < ROWS; i++) {
            rows.nx[i] = random.nextInt(4) == 0 ? 0 : random.nextFloat() * 2 - 1;
            rows.ny[i] = random.nextFloat() * 2 - 1;
            rows.nz[i] = random.nextInt(4) == 0 ? 1 : random.nextFloat() * 2 - 1;
            rows.vx[i] = random.nextInt(4) == 0 ? 0 : random.nextFloat() * 2 - 1;
            rows.vy[i] = random.nextFloat() * 2 - 1;
            rows.vz[i] = random.nextInt(4) == 0 ? -1 : random.nextFloat() * 2 - 1;
            rows.insideDistance[i] =
                    random.nextInt(3) == 0 ? -1 : random.nextInt(8) == 0 ? 0 : (float) Math.pow(10, random.nextInt(12) - 6);
        }
        Transmission glass = glass(random);
        InteriorTint interior = new InteriorTint(glass);
        float[][] lanes = new float[4][1024];
        float[][] loops = new float[4][1024];
        int from = random.nextInt(20);
        Engines.LANES.sums().clearTerms(rows, from, ROWS, glass, interior, lanes[0], new float[][] {lanes[1], lanes[2], lanes[3]});
        Engines.SCALAR.sums().clearTerms(rows, from, ROWS, glass, interior, loops[0], new float[][] {loops[1], loops[2], loops[3]});
        for (int k = 0; k < 4; k++) {
            for (int i = from; i < ROWS; i++) {
                assertSameBits(lanes[k][i], loops[k][i]);
            }
        }
    }

    private static void assertSameBits(float actual, float expected) {
        assertThat(Float.floatToRawIntBits(actual)).isEqualTo(Float.floatToRawIntBits(expected));
    }

    private static Transmission glass(Random random) {
        double ior = switch (random.nextInt(3)) {
            case 0 -> 1;
            case 1 -> 1.52;
            default -> 1 + 2 * random.nextDouble();
        };
        Rgb tint = new Rgb(random.nextInt(3) == 0 ? 0 : random.nextDouble(), random.nextInt(3) == 0 ? 1 : random.nextDouble(),
                random.nextDouble());
        return new Transmission(Rgb.WHITE, ior, random.nextInt(4) == 0, tint, 0.01 + random.nextDouble(),
                MaterialAttribute.SHADOWS.initial());
    }

    @Property
    void powerOfLogarithm_hasBitsOfPower(@ForAll Random random) {
        double x = random.nextInt(10) == 0 ? random.nextInt(2) : random.nextDouble();
        double n = random.nextInt(10) == 0 ? 0 : Math.pow(10, random.nextInt(10) - 5) * random.nextDouble();
        assertThat(PowerFunction.powOfLog2(PowerFunction.log2(x), n)).isEqualTo(PowerFunction.pow(x, n));
        assertThat(PowerFunction.pow(1, n)).isEqualTo(1);
    }
}
