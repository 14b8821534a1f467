package lightning.render.engine.lanes;

import java.util.Arrays;
import java.util.Random;
import lightning.base.math.Ray;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.trace.CameraRays;
import lightning.render.trace.Geometry;
import lightning.render.trace.primitive.SurfaceHit;

/** Generator of difficult rays: grazing, tangent, axis-parallel, along generators, from surfaces and from inside. */
public final class RandomRays {
    private final Geometry geometry;
    private final Random random;
    private final double maxCoordinate;

    public RandomRays(Geometry geometry, long seed) {
        this.geometry = geometry;
        random = new Random(seed);
        maxCoordinate = geometry.primitives().maxCoordinateSum / 4;
    }

    /** Fills all lanes; neighbors are often similar. */
    public void fill(RayPacket p) {
        Vec3 from = origin();
        boolean commonOrigin = random.nextBoolean();
        for (int i = 0; i < RayPacket.WIDTH; i++) {
            Vec3 o = commonOrigin ? from : origin();
            Vec3 d = direction(o);
            p.ox[i] = o.x();
            p.oy[i] = o.y();
            p.oz[i] = o.z();
            p.dx[i] = d.x();
            p.dy[i] = d.y();
            p.dz[i] = d.z();
            p.limit[i] = switch (random.nextInt(4)) {
                case 0 -> Double.POSITIVE_INFINITY;
                case 1 -> random.nextDouble();
                case 2 -> 1;
                default -> limitAtHit(o, d);
            };
        }
    }

    /** Returns a limit exactly at a hit or just after it. */
    private double limitAtHit(Vec3 o, Vec3 d) {
        double t = geometry.distance(random.nextInt(geometry.primitiveCount()), new Ray(o, d));
        return random.nextBoolean() ? t : Math.nextUp(t);
    }

    public Vec3 origin() {
        Vec3 o = switch (random.nextInt(5)) {
            case 0 -> new Vec3(signedRandom(), signedRandom(), signedRandom()).times(maxCoordinate);
            case 1 -> pointNearShape();
            case 2 -> offsetPoint(pointNearShape());
            default -> Vec3.ZERO;
        };
        return o.maxAbs() <= maxCoordinate ? o : Vec3.ZERO;
    }

    public Vec3 direction(Vec3 from) {
        Vec3 d = switch (random.nextInt(6)) {
            case 0 -> new Vec3(signedRandom(), signedRandom(), signedRandom());
            case 1 -> axisDirection();
            case 2 -> pointNearShape().minus(pointNearShape());
            default -> pointNearShape().minus(from);
        };
        if (!(d.maxAbs() > 1e-20)) {
            return new Vec3(0, -1, -0.0);
        }
        return random.nextBoolean() ? d.normalized() : d;
    }

    private Vec3 axisDirection() {
        double[] v = {0, random.nextBoolean() ? -0.0 : 1e-30, random.nextInt(3) == 0 ? signedRandom() : 0.0};
        int at = random.nextInt(3);
        v[at] = random.nextBoolean() ? 1 : -1;
        return new Vec3(v[0], v[1], v[2]);
    }

    /** Returns a point in, on, or at the edge of a shape. */
    private Vec3 pointNearShape() {
        int s = random.nextInt(geometry.primitiveCount());
        Transform toWorld = geometry.primitives().stage.placedShapes().get(s).toWorld();
        double angle = random.nextInt(4) == 0 ? Math.PI / 2 * random.nextInt(5) : random.nextDouble() * 2 * Math.PI;
        double c = Math.cos(angle);
        double z = Math.sin(angle);
        double h = random.nextInt(3) == 0 ? random.nextInt(2) : random.nextDouble();
        Vec3 local = switch (random.nextInt(5)) {
            case 0 -> new Vec3(signedRandom(), signedRandom(), signedRandom());
            case 1 -> new Vec3(c, h, z);
            case 2 -> new Vec3(c * (1 - h), h, z * (1 - h));
            case 3 -> new Vec3(random.nextInt(3) * 0.5 - 0.5, 0, random.nextInt(3) * 0.5 - 0.5);
            default -> new Vec3(signedRandom(), signedRandom(), signedRandom()).plus(new Vec3(0, 0, 1e-3)).normalized();
        };
        return geometry.toRenderSpace(toWorld.transformPoint(local));
    }

    /** Offsets a point by about as much as {@link SurfaceHit} offsets the origins of secondary rays. */
    private Vec3 offsetPoint(Vec3 p) {
        double radius = 0x1p-22 * (Math.abs(p.x()) + Math.abs(p.y()) + Math.abs(p.z()));
        return new Vec3((float) (p.x() + radius * signedRandom()), (float) (p.y() + radius * signedRandom()),
                (float) (p.z() + radius * signedRandom()));
    }

    private double signedRandom() {
        return 2 * random.nextDouble() - 1;
    }

    public static Ray ray(RayPacket p, int i) {
        return new Ray(new Vec3(p.ox[i], p.oy[i], p.oz[i]), new Vec3(p.dx[i], p.dy[i], p.dz[i]));
    }

    /** Writes the camera rays through a pixel and those to the right of it to a packet. */
    public static void loadEyeRays(CameraRays camera, int x, int y, RayPacket p) {
        Arrays.fill(p.ox, 0);
        Arrays.fill(p.oy, 0);
        Arrays.fill(p.oz, 0);
        CameraRayLanes.pixelRays(camera, x, y, p.dx, p.dy, p.dz, 0);
    }
}
