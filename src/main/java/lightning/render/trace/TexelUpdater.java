package lightning.render.trace;

import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.scene.Scene;

/**
 * Gives the rows of a tile their texels anew after a texture changed, came or went: the distance of each row's ray to its
 * own shape is computed again, and no other is searched for. Holds scratch memory: one for each thread.
 */
public final class TexelUpdater {
    private final Geometry geometry;
    private final MaterialTable materials;
    private final CameraRays camera;
    private final Tracer tracer;
    private final TexelWriter texels;
    private final RayBeam beam = new RayBeam();
    private final CandidateList candidates = new CandidateList();
    private final RayColumns rays;
    /** The directions of all rays of the eye through the tile's places. */
    private final RayColumns eyeRays;
    private final double[] direction = new double[3];
    private long rowsTouched;

    /** @param geometry with the materials as they are wanted */
    public TexelUpdater(Geometry geometry, Scene scene, Tracer tracer) {
        this.geometry = geometry;
        this.tracer = tracer;
        materials = geometry.materials();
        camera = new CameraRays(scene.camera(), scene.picture());
        rays = new RayColumns(camera);
        eyeRays = new RayColumns(camera);
        texels = new TexelWriter(geometry);
    }

    /** Rows whose texels were written since the start. */
    public long rowsTouched() {
        return rowsTouched;
    }

    /**
     * The rows of a tile's first level with their texels.
     *
     * @param positions  where their rays go
     * @param changed the materials whose textures changed, went or came
     * @return the same object where nothing changes; all other columns are shared
     */
    public HitRows updateEyeRows(HitRows rows, SamplePositions positions, MaterialSet changed) {
        return updateTexels(rows, null, null, positions, changed);
    }

    /**
     * The same for rows that are seen from others.
     *
     * @param parentRows the level that they are seen from
     */
    public HitRows updateBounceRows(HitRows rows, HitRows parentRows, BounceKind bounce, MaterialSet changed) {
        return updateTexels(rows, parentRows, bounce, null, changed);
    }

    private HitRows updateTexels(HitRows rows, HitRows parentRows, BounceKind bounce, SamplePositions positions, MaterialSet changed) {
        if (!changed.intersects(rows)) {
            return rows;
        }
        if (!hasTextures(rows)) {
            return rows.texelRed == null ? rows : rows.withoutTexels();
        }
        if (parentRows == null && positions.pixels() == null) {
            tracer.directEyeRays(camera, positions.x0(), positions.y0(), SamplePositions.SIDE, SamplePositions.SIDE, eyeRays);
        } else if (parentRows == null) {
            tracer.directSampleRays(camera, positions, eyeRays);
        }
        HitRows updated = rows.withCopiedTexels();
        for (int r = 0; r < rows.runCount; r++) {
            int material = rows.runMaterial[r];
            if (changed.contains(material) && materials.isTextured(material)) {
                updateRun(updated, r, parentRows, bounce, positions);
            }
        }
        return updated;
    }

    private boolean hasTextures(HitRows rows) {
        for (int r = 0; r < rows.runCount; r++) {
            if (materials.isTextured(rows.runMaterial[r])) {
                return true;
            }
        }
        return false;
    }

    private void updateRun(HitRows rows, int run, HitRows parentRows, BounceKind bounce, SamplePositions positions) {
        int start = rows.runStart(run);
        rays.count = rows.runEnd[run] - start;
        rays.hitCount = rays.count;
        rowsTouched += rays.count;
        for (int i = 0; i < rays.count; i++) {
            rays.slot[i] = rows.parent[start + i];
            rays.order[i] = (short) i;
        }
        if (parentRows == null) {
            rays.startAtEye();
            setEyeDirections(positions);
        } else {
            rays.startAtRows(parentRows, bounce);
            setBounceDirections(parentRows, bounce);
        }
        candidates.collect(geometry.bvh(), beam);
        // What a row hit is the nearest of all shapes, and so of those of its material.
        candidates.retainMaterial(geometry.primitives(), rows.runMaterial[run]);
        tracer.findNearest(rays, candidates);
        tracer.writeLocalPoints(rays);
        texels.write(rows, start, rays);
    }

    private void setEyeDirections(SamplePositions positions) {
        for (int i = 0; i < rays.count; i++) {
            rays.dx[i] = eyeRays.dx[rays.slot[i]];
            rays.dy[i] = eyeRays.dy[rays.slot[i]];
            rays.dz[i] = eyeRays.dz[rays.slot[i]];
        }
        positions.boundBeam(beam, camera);
    }

    private void setBounceDirections(HitRows parentRows, BounceKind bounce) {
        beam.clear();
        for (int i = 0; i < rays.count; i++) {
            bounce.writeDirection(parentRows, rays.slot[i], materials, direction);
            rays.dx[i] = direction[0];
            rays.dy[i] = direction[1];
            rays.dz[i] = direction[2];
            beam.addOrigin(rays.originX(i), rays.originY(i), rays.originZ(i));
        }
        rays.addDirectionsTo(beam, tracer);
    }
}
