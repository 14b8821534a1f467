package lightning.render.engine.lanes;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import lightning.base.math.Vec3;
import lightning.render.engine.KernelAgreement;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Benchmark in nanoseconds per ray of one shape, without boxes. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class ShapeKernels {
    private static final int RAYS = 1024;
    private static final int SIZE = 32;
    private static final int W = RayPacket.WIDTH;

    public enum Kind { SPHERE, CONE, CYLINDER, PLANE }

    @Param
    public Kind kind;

    private final RayPacket[] packets = new RayPacket[RAYS / W];
    private PrimitiveLanes solid;

    /** Aims a small image at the shape, and fails if a kernel disagrees with the scalar code. */
    @Setup
    public void prepare() {
        String name = kind.name().toLowerCase(Locale.ROOT);
        String material = Material.DEFAULT.name();
        Placement placement = new Placement(Vec3.ZERO, new Vec3(30, 20, 10), new Vec3(1, 1.5, 0.8));
        SceneNode node = switch (kind) {
            case SPHERE -> new Shape(Solid.SPHERE, name, material, placement);
            case CONE -> new Shape(Solid.CONE, name, material, placement);
            case CYLINDER -> new Shape(Solid.CYLINDER, name, material, placement);
            case PLANE -> new Shape(Solid.PLANE, name, material, placement);
        };
        Camera eye = new Camera(new Vec3(0.5, 1, 4), new Vec3(0, 0.5, 0), Vec3.Y, 30);
        Geometry geometry = Geometry.of(new Scene(PictureSettings.DEFAULT, eye, World.DEFAULT, List.of(), List.of(node), List.of()));
        CameraRays camera = new CameraRays(eye, new PictureSettings(SIZE, SIZE, 0));
        solid = new PrimitiveLanes(geometry.primitives());
        for (int i = 0; i < RAYS; i++) {
            if (i % W == 0) {
                packets[i / W] = new RayPacket();
            }
            PacketRays.setRay(packets[i / W], i % W, camera.pixelRay(i % SIZE, i / SIZE), Double.POSITIVE_INFINITY);
        }
        nearest();
        int hits = 0;
        for (int i = 0; i < RAYS; i++) {
            double t = geometry.distance(0, camera.pixelRay(i % SIZE, i / SIZE));
            KernelAgreement.requireEqual(packets[i / W].t[i % W] == t, name, i);
            hits += t < SolidGeometry.MISS ? 1 : 0;
        }
        if (hits < RAYS / 10) {
            throw new IllegalStateException("only " + hits + " rays hit the " + name);
        }
    }

    /** Finds the nearest hit of each ray. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public RayPacket[] nearest() {
        for (RayPacket p : packets) {
            solid.resetHits(p);
            solid.updateNearest(p, 0, -1 >>> -W);
            solid.writePrimitives(p);
        }
        return packets;
    }
}
