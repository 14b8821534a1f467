package lightning.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.mesh.Mesh;
import lightning.sample.Meshes;
import lightning.trace.solid.Rays;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Lanes answer as the scalar walk does, bit for bit: together and alone, from near and from afar. */
class MeshPacketsTest {
    private final MeshPackets packets = new MeshPackets();
    private final MeshProbe probe = new MeshProbe();
    private final Rays p = new Rays();
    private final double[] limits = new double[Rays.WIDTH];

    @Property
    void packets_answerAsSingleRays(@ForAll @IntRange(min = 0, max = 300) int triangles, @ForAll long seed) {
        Random random = new Random(seed);
        Mesh mesh = random.nextBoolean() ? Meshes.soup(triangles, seed) : Meshes.ball(3 + triangles / 20, 5 + triangles / 20, false);
        check(new MeshSolid(mesh), random, 10);
    }

    /** The vector code must have been compiled by the optimising compiler to say that its bits are right. */
    @Test
    void hotCode_keepsEveryBit() {
        check(new MeshSolid(Meshes.ball(60, 100, false)), new Random(1), 6000);
    }

    private void check(MeshSolid solid, Random random, int times) {
        double[] m = new double[12];
        for (int n = 0; n < times; n++) {
            double scale = Math.pow(10, random.nextInt(4) == 0 ? random.nextInt(18) - 9 : 0);
            for (int k = 0; k < 12; k++) {
                m[k] = k % 4 == 3 ? 0.2 * random.nextGaussian() : (k % 5 == 0 ? 1 : 0.3) * random.nextGaussian() * scale;
            }
            rays(random, scale);
            int mask = random.nextInt() & -1 >>> -Rays.WIDTH;
            assertNearest(solid, m, mask);
            assertBlocked(solid, m, mask, random);
        }
    }

    private void rays(Random random, double scale) {
        double far = random.nextInt(5) == 0 ? 1e6 : 2;
        double spread = random.nextBoolean() ? 0.02 : 1;
        double[] o = new double[3];
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            o[k] = far * random.nextGaussian() / scale;
            d[k] = 0.3 * random.nextGaussian() / scale - o[k];
        }
        int flat = random.nextInt(6);
        for (int i = 0; i < Rays.WIDTH; i++) {
            double apart = random.nextInt(3) == 0 ? spread / scale : 0;
            p.ox[i] = o[0] + apart * random.nextGaussian();
            p.oy[i] = o[1] + apart * random.nextGaussian();
            p.oz[i] = o[2] + apart * random.nextGaussian();
            p.dx[i] = flat == 0 ? 0 : d[0] + spread * random.nextGaussian() / scale;
            p.dy[i] = flat == 1 ? -0.0 : d[1] + spread * random.nextGaussian() / scale;
            p.dz[i] = d[2] + spread * random.nextGaussian() / scale;
            limits[i] = random.nextInt(3) == 0 ? random.nextDouble() * 2 : Double.POSITIVE_INFINITY;
        }
    }

    private void enter(MeshSolid solid, double[] m, int i) {
        probe.enter(solid, m[0] * p.ox[i] + m[1] * p.oy[i] + m[2] * p.oz[i] + m[3],
                m[4] * p.ox[i] + m[5] * p.oy[i] + m[6] * p.oz[i] + m[7], m[8] * p.ox[i] + m[9] * p.oy[i] + m[10] * p.oz[i] + m[11],
                m[0] * p.dx[i] + m[1] * p.dy[i] + m[2] * p.dz[i], m[4] * p.dx[i] + m[5] * p.dy[i] + m[6] * p.dz[i],
                m[8] * p.dx[i] + m[9] * p.dy[i] + m[10] * p.dz[i]);
    }

    private void assertNearest(MeshSolid solid, double[] m, int mask) {
        int met = packets.nearest(solid, m, 0, p, mask, limits);
        assertThat(met & ~mask).isZero();
        for (int i = 0; i < Rays.WIDTH; i++) {
            if ((mask >>> i & 1) != 0) {
                enter(solid, m, i);
                double t = probe.nearest(limits[i]);
                assertThat(met >>> i & 1).as("ray %s", i).isEqualTo(probe.triangle() >= 0 ? 1 : 0);
                if (probe.triangle() >= 0) {
                    assertThat(packets.triangle(i)).isEqualTo(probe.triangle());
                    assertThat(packets.distance(i)).isEqualTo(t);
                }
            }
        }
    }

    private void assertBlocked(MeshSolid solid, double[] m, int mask, Random random) {
        int expected = 0;
        for (int i = 0; i < Rays.WIDTH; i++) {
            enter(solid, m, i);
            double t = probe.nearest(Double.POSITIVE_INFINITY);
            limits[i] = random.nextInt(3) == 0 ? limits[i] : random.nextBoolean() ? t : Math.nextUp(t);
            expected |= probe.blocked(limits[i]) ? 1 << i : 0;
        }
        assertThat(packets.blocked(solid, m, 0, p, mask, limits)).isEqualTo(expected & mask);
    }
}
