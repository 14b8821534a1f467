package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.BruteForce;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Compares every result of a packet with the scalar functions over all shapes, bit for bit. */
class PacketTracerTest {
    private static final int PACKETS = 25;

    private final RayPacket packet = new RayPacket();

    private static PacketTracer linearTracer(Geometry geometry) {
        return new PacketTracer(geometry.bvh(), Integer.MAX_VALUE);
    }

    private static PacketTracer bvhTracer(Geometry geometry) {
        return new PacketTracer(geometry.bvh(), 1);
    }

    @Property
    void nearestHit_matchesBruteForceBitForBit(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        assertNearest(geometry, bvhTracer(geometry), seed);
        assertNearest(geometry, linearTracer(geometry), seed + 1);
    }

    private void assertNearest(Geometry geometry, PacketTracer tracer, long seed) {
        RandomRays rays = new RandomRays(geometry, seed);
        Random random = new Random(seed);
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(packet);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            tracer.findNearest(packet, live);
            for (int i = 0; i < live; i++) {
                Ray ray = RandomRays.ray(packet, i);
                int expected = BruteForce.nearest(geometry, ray);
                assertThat(packet.primitive[i]).as("%s", ray).isEqualTo(expected);
                assertThat(bits(packet.t[i])).isEqualTo(bits(expected < 0 ? SolidGeometry.MISS : geometry.distance(expected, ray)));
            }
        }
    }

    @Property
    void occlusion_matchesBruteForce(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        assertBlocked(geometry, bvhTracer(geometry), seed);
        assertBlocked(geometry, linearTracer(geometry), seed + 1);
    }

    private void assertBlocked(Geometry geometry, PacketTracer tracer, long seed) {
        RandomRays rays = new RandomRays(geometry, seed);
        Random random = new Random(seed);
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(packet);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            int expected = 0;
            for (int i = 0; i < live; i++) {
                expected |= BruteForce.isBlocked(geometry, RandomRays.ray(packet, i), packet.limit[i]) ? 1 << i : 0;
            }
            assertThat(tracer.findBlocked(packet, live)).isEqualTo(expected);
        }
    }

    @Property
    void surfacesAndDistances_matchScalarCodeBitForBit(@ForAll @IntRange(min = 1, max = 12) int shapes, @ForAll long seed) {
        Geometry geometry = Geometry.of(TraceScenes.randomScene(shapes, seed));
        PacketTracer tracer = new PacketTracer(geometry);
        RandomRays rays = new RandomRays(geometry, seed);
        Random random = new Random(seed);
        SurfacePacket out = new SurfacePacket();
        SurfaceHit surface = new SurfaceHit();
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(packet);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            tracer.findNearest(packet, live);
            double[] t = packet.t.clone();
            tracer.writeDistances(packet, live);
            tracer.writeSurfaces(packet, live, out);
            for (int i = 0; i < live; i++) {
                assertThat(bits(packet.t[i])).isEqualTo(bits(t[i]));
                if (packet.primitive[i] >= 0) {
                    surface.compute(geometry.primitives(), packet.primitive[i], packet.part[i], packet.ox[i], packet.oy[i], packet.oz[i],
                            packet.dx[i], packet.dy[i], packet.dz[i],
                            t[i]);
                    assertThat(new long[] {bits(out.localX[i]), bits(out.localY[i]), bits(out.localZ[i]), bits(out.px[i]), bits(out.py[i]),
                        bits(out.pz[i]), bits(out.nx[i]), bits(out.ny[i]), bits(out.nz[i])})
                            .as("%s shape %s", RandomRays.ray(packet, i), geometry.shape(packet.primitive[i]))
                            .containsExactly(bits(surface.localX), bits(surface.localY), bits(surface.localZ), bits(surface.px),
                                    bits(surface.py), bits(surface.pz), bits(surface.nx), bits(surface.ny), bits(surface.nz));
                }
            }
        }
    }

    @Property
    void eyeRays_matchCameraBitForBit(@ForAll @IntRange(min = 0, max = 500) int column,
            @ForAll @IntRange(min = 0, max = 500) int row, @ForAll long seed) {
        Random random = new Random(seed);
        Camera camera = new Camera(new Vec3(random.nextGaussian(), 1, 2), new Vec3(random.nextGaussian(), random.nextGaussian(), -3),
                Vec3.Y, 1 + random.nextInt(170));
        CameraRays rays = new CameraRays(camera, new PictureSettings(1 + random.nextInt(1000), 1 + random.nextInt(1000), 1));
        RandomRays.loadEyeRays(rays, column, row, packet);
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            assertThat(RandomRays.ray(packet, i)).isEqualTo(rays.pixelRay(column + i, row));
        }
    }

    /** Runs long enough for the optimizing compiler, since interpreted vector code proves nothing about its bits. */
    @Test
    void compiledCode_matchesBitForBit() {
        for (Scene scene : new Scene[] {TraceScenes.bird(), TraceScenes.house(), TraceScenes.cloud(60, 5)}) {
            Geometry geometry = Geometry.of(scene);
            PacketTracer tracer = new PacketTracer(geometry);
            CameraRays camera = new CameraRays(scene.camera(), new PictureSettings(320, 320, 1));
            for (int y = 0; y < 320; y++) {
                for (int x = 0; x < 320; x += RayPacket.WIDTH) {
                    RandomRays.loadEyeRays(camera, x, y, packet);
                    tracer.findNearest(packet, RayPacket.WIDTH);
                    for (int i = y % 13; i < RayPacket.WIDTH; i += 13) {
                        Ray ray = camera.pixelRay(x + i, y);
                        int expected = BruteForce.nearest(geometry, ray);
                        assertThat(packet.primitive[i]).isEqualTo(expected);
                        assertThat(bits(packet.t[i])).isEqualTo(bits(expected < 0 ? SolidGeometry.MISS : geometry.distance(expected, ray)));
                    }
                }
            }
        }
    }

    @Test
    void emptyScene_hasNoHitsOrOcclusion() {
        Scene empty =
                new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, TraceScenes.bird().world(), java.util.List.of(), java.util.List.of(),
                        java.util.List.of());
        PacketTracer tracer = new PacketTracer(Geometry.of(empty));
        RandomRays.loadEyeRays(new CameraRays(Camera.DEFAULT, PictureSettings.DEFAULT), 0, 0, packet);
        tracer.findNearest(packet, RayPacket.WIDTH);
        assertThat(packet.primitive).containsOnly(-1);
        assertThat(packet.t).containsOnly(SolidGeometry.MISS);
        assertThat(tracer.findBlocked(packet, RayPacket.WIDTH)).isZero();
    }

    static long bits(double v) {
        return Double.doubleToLongBits(v);
    }
}
