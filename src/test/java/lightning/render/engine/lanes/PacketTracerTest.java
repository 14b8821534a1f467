package lightning.render.engine.lanes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.solid.Form;
import lightning.scene.Camera;
import lightning.scene.Picture;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Every answer of a packet is compared with the scalar functions of all shapes, bit for bit. */
class PacketTracerTest {
    private static final int PACKETS = 25;

    private final RayPacket p = new RayPacket();

    private static PacketTracer inTurn(Geometry geometry) {
        return new PacketTracer(geometry.bvh(), Integer.MAX_VALUE);
    }

    private static PacketTracer byTree(Geometry geometry) {
        return new PacketTracer(geometry.bvh(), 1);
    }

    @Property
    void nearest_isThatOfAllShapesInEveryBit(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(TraceScenes.wild(shapes, seed));
        assertNearest(geometry, byTree(geometry), seed);
        assertNearest(geometry, inTurn(geometry), seed + 1);
    }

    private void assertNearest(Geometry geometry, PacketTracer tracer, long seed) {
        TraceRays rays = new TraceRays(geometry, seed);
        Random random = new Random(seed);
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(p);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            tracer.nearest(p, live);
            for (int i = 0; i < live; i++) {
                Ray ray = TraceRays.ray(p, i);
                int expected = geometry.nearestOfAll(ray);
                assertThat(p.primitive[i]).as("%s", ray).isEqualTo(expected);
                assertThat(bits(p.t[i])).isEqualTo(bits(expected < 0 ? Form.MISS : geometry.distance(expected, ray)));
            }
        }
    }

    @Property
    void blocked_isThatOfAllShapes(@ForAll @IntRange(min = 1, max = 40) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(TraceScenes.wild(shapes, seed));
        assertBlocked(geometry, byTree(geometry), seed);
        assertBlocked(geometry, inTurn(geometry), seed + 1);
    }

    private void assertBlocked(Geometry geometry, PacketTracer tracer, long seed) {
        TraceRays rays = new TraceRays(geometry, seed);
        Random random = new Random(seed);
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(p);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            int expected = 0;
            for (int i = 0; i < live; i++) {
                expected |= geometry.blockedByAny(TraceRays.ray(p, i), p.limit[i]) ? 1 << i : 0;
            }
            assertThat(tracer.blocked(p, live)).isEqualTo(expected);
        }
    }

    @Property
    void surfacesAndDistances_areThoseOfScalarCodeInEveryBit(@ForAll @IntRange(min = 1, max = 12) int shapes, @ForAll long seed) {
        Geometry geometry = new Geometry(TraceScenes.wild(shapes, seed));
        PacketTracer tracer = new PacketTracer(geometry);
        TraceRays rays = new TraceRays(geometry, seed);
        Random random = new Random(seed);
        SurfacePacket out = new SurfacePacket();
        Surface surface = new Surface();
        for (int n = 0; n < PACKETS; n++) {
            rays.fill(p);
            int live = 1 + random.nextInt(RayPacket.WIDTH);
            tracer.nearest(p, live);
            double[] t = p.t.clone();
            tracer.distances(p, live);
            tracer.surfaces(p, live, out);
            for (int i = 0; i < live; i++) {
                assertThat(bits(p.t[i])).isEqualTo(bits(t[i]));
                if (p.primitive[i] >= 0) {
                    surface.at(geometry.primitives(), p.primitive[i], p.part[i], p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i],
                            t[i]);
                    assertThat(new long[] {bits(out.ownX[i]), bits(out.ownY[i]), bits(out.ownZ[i]), bits(out.px[i]), bits(out.py[i]),
                        bits(out.pz[i]), bits(out.nx[i]), bits(out.ny[i]), bits(out.nz[i])})
                            .as("%s shape %s", TraceRays.ray(p, i), geometry.shape(p.primitive[i]))
                            .containsExactly(bits(surface.ownX), bits(surface.ownY), bits(surface.ownZ), bits(surface.px),
                                    bits(surface.py), bits(surface.pz), bits(surface.nx), bits(surface.ny), bits(surface.nz));
                }
            }
        }
    }

    @Property
    void eyeRays_areThoseOfTheCameraInEveryBit(@ForAll @IntRange(min = 0, max = 500) int column,
            @ForAll @IntRange(min = 0, max = 500) int row, @ForAll long seed) {
        Random random = new Random(seed);
        Camera camera = new Camera(new Vec3(random.nextGaussian(), 1, 2), new Vec3(random.nextGaussian(), random.nextGaussian(), -3),
                Vec3.Y, 1 + random.nextInt(170));
        CameraRays rays = new CameraRays(camera, new Picture(1 + random.nextInt(1000), 1 + random.nextInt(1000), 1));
        TraceRays.eye(rays, column, row, p);
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            assertThat(TraceRays.ray(p, i)).isEqualTo(rays.through(column + i, row));
        }
    }

    /** The vector code must have been compiled by the optimising compiler to say that its bits are right. */
    @Test
    void hotCode_keepsEveryBit() {
        for (Scene scene : new Scene[] {TraceScenes.bird(), TraceScenes.house(), TraceScenes.cloud(60, 5)}) {
            Geometry geometry = new Geometry(scene);
            PacketTracer tracer = new PacketTracer(geometry);
            CameraRays camera = new CameraRays(scene.camera(), new Picture(320, 320, 1));
            for (int y = 0; y < 320; y++) {
                for (int x = 0; x < 320; x += RayPacket.WIDTH) {
                    TraceRays.eye(camera, x, y, p);
                    tracer.nearest(p, RayPacket.WIDTH);
                    for (int i = y % 13; i < RayPacket.WIDTH; i += 13) {
                        Ray ray = camera.through(x + i, y);
                        int expected = geometry.nearestOfAll(ray);
                        assertThat(p.primitive[i]).isEqualTo(expected);
                        assertThat(bits(p.t[i])).isEqualTo(bits(expected < 0 ? Form.MISS : geometry.distance(expected, ray)));
                    }
                }
            }
        }
    }

    @Test
    void emptyScene_isMissedAndBlocksNothing() {
        Scene empty = new Scene(Picture.DEFAULT, Camera.DEFAULT, TraceScenes.bird().world(), java.util.List.of(), java.util.List.of(),
                java.util.List.of());
        PacketTracer tracer = new PacketTracer(new Geometry(empty));
        TraceRays.eye(new CameraRays(Camera.DEFAULT, Picture.DEFAULT), 0, 0, p);
        tracer.nearest(p, RayPacket.WIDTH);
        assertThat(p.primitive).containsOnly(-1);
        assertThat(p.t).containsOnly(Form.MISS);
        assertThat(tracer.blocked(p, RayPacket.WIDTH)).isZero();
    }

    static long bits(double v) {
        return Double.doubleToLongBits(v);
    }
}
