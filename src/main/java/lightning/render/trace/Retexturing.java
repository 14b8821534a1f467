package lightning.render.trace;

import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.Candidates;
import lightning.scene.Scene;

/**
 * Gives the rows of a tile their texels anew after a texture changed, came or went: the distance of each row's ray to its
 * own shape is computed again, and no other is searched for. Holds scratch memory: one for each thread.
 */
public final class Retexturing {
    private final Geometry geometry;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final Tracer tracer;
    private final TexelColumns texels;
    private final Beam beam = new Beam();
    private final Candidates candidates = new Candidates();
    private final RayColumns rays;
    /** The directions of all rays of the eye through the tile's places. */
    private final RayColumns eye;
    private final double[] direction = new double[3];
    private long rowsTouched;

    /** @param geometry with the materials as they are wanted */
    public Retexturing(Geometry geometry, Scene scene, Tracer tracer) {
        this.geometry = geometry;
        this.tracer = tracer;
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        rays = new RayColumns(camera);
        eye = new RayColumns(camera);
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
        return textured(rows, null, null, places, changed);
    }

    /**
     * The same for rows that are seen from others.
     *
     * @param from the level that they are seen from
     */
    public HitRows seenFrom(HitRows rows, HitRows from, Bounce bounce, MaterialSet changed) {
        return textured(rows, from, bounce, null, changed);
    }

    private HitRows textured(HitRows rows, HitRows from, Bounce bounce, SamplePlaces places, MaterialSet changed) {
        if (!changed.isIn(rows)) {
            return rows;
        }
        if (!hasTextures(rows)) {
            return rows.texelRed == null ? rows : rows.withoutTexels();
        }
        if (from == null && places.pixels() == null) {
            tracer.eye(camera, places.x0(), places.y0(), SamplePlaces.SIDE, SamplePlaces.SIDE, eye);
        } else if (from == null) {
            tracer.samples(camera, places, eye);
        }
        HitRows now = rows.withOwnTexels();
        for (int r = 0; r < rows.runs; r++) {
            int material = rows.runMaterial[r];
            if (changed.contains(material) && materials.isTextured(material)) {
                run(now, r, from, bounce, places);
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

    private void run(HitRows rows, int run, HitRows from, Bounce bounce, SamplePlaces places) {
        int start = rows.runStart(run);
        rays.count = rows.runEnd[run] - start;
        rays.hits = rays.count;
        rowsTouched += rays.count;
        for (int i = 0; i < rays.count; i++) {
            rays.slot[i] = rows.parent[start + i];
            rays.order[i] = (short) i;
        }
        if (from == null) {
            rays.fromEye();
            towards(places);
        } else {
            rays.from(from, bounce);
            bounce(from, bounce);
        }
        candidates.collect(geometry.bvh(), beam);
        // What a row hit is the nearest of all shapes, and so of those of its material.
        candidates.keepMaterial(geometry.primitives(), rows.runMaterial[run]);
        tracer.nearest(rays, candidates);
        tracer.ownPoints(rays);
        texels.write(rows, start, rays);
    }

    private void towards(SamplePlaces places) {
        for (int i = 0; i < rays.count; i++) {
            rays.dx[i] = eye.dx[rays.slot[i]];
            rays.dy[i] = eye.dy[rays.slot[i]];
            rays.dz[i] = eye.dz[rays.slot[i]];
        }
        places.bound(beam, camera);
    }

    private void bounce(HitRows from, Bounce bounce) {
        beam.clear();
        for (int i = 0; i < rays.count; i++) {
            bounce.direct(from, rays.slot[i], materials, direction);
            rays.dx[i] = direction[0];
            rays.dy[i] = direction[1];
            rays.dz[i] = direction[2];
            beam.origin(rays.originX(i), rays.originY(i), rays.originZ(i));
        }
        rays.sweep(beam, tracer);
    }
}
