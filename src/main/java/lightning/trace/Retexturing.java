package lightning.trace;

import java.util.Arrays;
import lightning.math.Vec3;
import lightning.scene.Scene;

/**
 * Gives the rows of a tile their texels anew after a texture changed, came or went: the distance of each row's ray to its
 * own shape is computed again, and no other is searched for. Holds scratch memory: one for each thread.
 */
public final class Retexturing {
    private static final int ROWS = 1024;

    private final Geometry geometry;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final PacketTracer tracer;
    private final TexelColumns texels;
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();
    private final RayPacket packet = new RayPacket();
    private final SurfacePacket surface = new SurfacePacket();
    private final double[] dx = new double[ROWS];
    private final double[] dy = new double[ROWS];
    private final double[] dz = new double[ROWS];
    private long rowsTouched;

    /** @param geometry with the materials as they are wanted */
    public Retexturing(Geometry geometry, Scene scene, PacketTracer tracer) {
        this.geometry = geometry;
        this.tracer = tracer;
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        texels = new TexelColumns(geometry);
    }

    /** Rows whose texels were written since the start. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /**
     * The rows of a tile's first level with their texels.
     *
     * @param places  where their rays go
     * @param changed the materials whose textures changed, went or came
     * @return the same object where nothing changes; all other columns are shared
     */
    public HitRows eye(HitRows rows, SamplePlaces places, MaterialSet changed) {
        return textured(rows, null, places, changed);
    }

    /**
     * The same for rows that are seen in mirrors.
     *
     * @param from the level that they are seen from
     */
    public HitRows mirrored(HitRows rows, HitRows from, MaterialSet changed) {
        return textured(rows, from, null, changed);
    }

    private HitRows textured(HitRows rows, HitRows from, SamplePlaces places, MaterialSet changed) {
        if (!changed.isIn(rows)) {
            return rows;
        }
        if (!hasTextures(rows)) {
            return rows.texelRed == null ? rows : rows.withoutTexels();
        }
        HitRows now = rows.withOwnTexels();
        for (int r = 0; r < rows.runs; r++) {
            int material = rows.runMaterial[r];
            if (changed.contains(material) && materials.isTextured(material)) {
                run(now, r, from, places);
            }
        }
        return now;
    }

    private boolean hasTextures(HitRows rows) {
        for (int r = 0; r < rows.runs; r++) {
            if (materials.isTextured(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    private void run(HitRows rows, int run, HitRows from, SamplePlaces places) {
        int start = rows.runStart(run);
        int count = rows.runEnd[run] - start;
        rowsTouched += count;
        beam.clear();
        for (int i = 0; i < count; i++) {
            int parent = rows.parent[start + i];
            if (from == null) {
                eye(camera.at(places.x(parent), places.y(parent)).direction(), i);
                beam.origin(0, 0, 0);
            } else {
                MirrorRays.direction(from, parent, dx, dy, dz, i);
                beam.origin(from.px[parent], from.py[parent], from.pz[parent]);
            }
        }
        beam.directions(dx, dy, dz, count);
        candidates.collect(geometry, beam);
        // What a row hit is the nearest of all shapes, and so of those of its material.
        candidates.keepMaterial(geometry.shapes(), rows.runMaterial[run]);
        for (int i = 0; i < count; i += RayPacket.WIDTH) {
            int live = Math.min(RayPacket.WIDTH, count - i);
            load(rows, from, start, i, live);
            tracer.nearest(packet, live, candidates);
            tracer.surfaces(packet, live, surface);
            texels.write(rows, start + i, live, packet, surface);
        }
    }

    private void eye(Vec3 direction, int ray) {
        dx[ray] = direction.x();
        dy[ray] = direction.y();
        dz[ray] = direction.z();
    }

    private void load(HitRows rows, HitRows from, int start, int ray, int live) {
        if (from == null) {
            Arrays.fill(packet.ox, 0);
            Arrays.fill(packet.oy, 0);
            Arrays.fill(packet.oz, 0);
        } else {
            for (int i = 0; i < live; i++) {
                int parent = rows.parent[start + ray + i];
                packet.ox[i] = from.px[parent];
                packet.oy[i] = from.py[parent];
                packet.oz[i] = from.pz[parent];
            }
        }
        System.arraycopy(dx, ray, packet.dx, 0, live);
        System.arraycopy(dy, ray, packet.dy, 0, live);
        System.arraycopy(dz, ray, packet.dz, 0, live);
    }
}
