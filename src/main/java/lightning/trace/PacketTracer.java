package lightning.trace;

/**
 * Traces packets of rays. Holds scratch memory: one for each thread.
 *
 * <p>A packet is a way to run, not an approximation: each lane's answer is that of the scalar
 * functions of {@link Solids} and {@link Surface}, bit for bit.
 */
public final class PacketTracer {
    private final ShapeTable shapes;
    private final Surface surface = new Surface();

    public PacketTracer(Geometry geometry) {
        shapes = geometry.shapes();
    }

    /** Finds the nearest hit of the first {@code live} lanes; writes {@code t} and {@code shape}. */
    public void nearest(RayPacket p, int live) {
        for (int i = 0; i < live; i++) {
            p.t[i] = Solids.MISS;
            p.shape[i] = -1;
            for (int s = 0; s < shapes.count; s++) {
                double t = shapes.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
                if (t < p.t[i]) {
                    p.t[i] = t;
                    p.shape[i] = s;
                }
            }
        }
    }

    /**
     * Which of the first {@code live} lanes meet any shape at a distance below their {@code limit}.
     *
     * @return one bit for each lane, the lowest for lane 0
     */
    public int blocked(RayPacket p, int live) {
        int mask = 0;
        for (int i = 0; i < live; i++) {
            for (int s = 0; s < shapes.count; s++) {
                if (shapes.distance(s, p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]) < p.limit[i]) {
                    mask |= 1 << i;
                    break;
                }
            }
        }
        return mask;
    }

    /** For lanes whose {@code shape} is known without a search: writes {@code t}. */
    public void distances(RayPacket p, int live) {
        for (int i = 0; i < live; i++) {
            p.t[i] = p.shape[i] < 0 ? Solids.MISS
                    : shapes.distance(p.shape[i], p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i]);
        }
    }

    /** Computes the surfaces of those of the first {@code live} lanes that hit a shape. */
    public void surfaces(RayPacket p, int live, SurfacePacket out) {
        for (int i = 0; i < live; i++) {
            if (p.shape[i] >= 0) {
                surface.at(shapes, p.shape[i], p.ox[i], p.oy[i], p.oz[i], p.dx[i], p.dy[i], p.dz[i], p.t[i]);
                out.ownX[i] = surface.ownX;
                out.ownY[i] = surface.ownY;
                out.ownZ[i] = surface.ownZ;
                out.px[i] = surface.px;
                out.py[i] = surface.py;
                out.pz[i] = surface.pz;
                out.nx[i] = surface.nx;
                out.ny[i] = surface.ny;
                out.nz[i] = surface.nz;
            }
        }
    }

    /** Puts the eye rays through pixels {@code x … x + live − 1} of row {@code y} into the packet. */
    static void eyeRays(CameraRays camera, int x, int y, int live, RayPacket p) {
        for (int i = 0; i < live; i++) {
            Ray ray = camera.through(x + i, y);
            p.ox[i] = 0;
            p.oy[i] = 0;
            p.oz[i] = 0;
            p.dx[i] = ray.direction().x();
            p.dy[i] = ray.direction().y();
            p.dz[i] = ray.direction().z();
        }
    }
}
